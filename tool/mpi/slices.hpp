#pragma once
/// Sites from one file, of which each rank reads a slice: no rank holds all of them.

#include <cstdint>
#include <string>
#include <vector>

#include "../../mpi/communicator.hpp"
#include "../../triangulation/distributed/exchange.hpp"

namespace signum::mpi {

struct Slices {
    /// This rank's, numbered as they stand in the file, from 0.
    std::vector<distributed::Placed> sites;
    bool has_radii = false;  ///< or weights
};

/// Of FILE.h5:/path/to/array the file; any other name is one.
[[nodiscard]] std::string file_of(const std::string& name);

/// `name`: a file of text (x y, or x y r, a line; of space x y z, or x y z r), .npy, .f64, or
/// FILE.h5:/path/to/coordinates, of as many columns; `radii`: where in the latter file there are
/// radii or weights, or empty.
/// Collective. Throws InputError, with line and column where it has them, and MachineError.
[[nodiscard]] Slices read_slices(Communicator& ranks, const std::string& name, int dimension,
                                 const std::string& radii);

}  // namespace signum::mpi
