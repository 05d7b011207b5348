#pragma once
/// The whole tessellation as a file that all ranks write: the same bytes for every number of ranks.
///
/// Laws: those of tool/io/output_file.hpp. A file is written beside its place, and renamed when it
/// is complete on all ranks.

#include <string>

#include "../../mpi/communicator.hpp"
#include "../../mpi/triangulate.hpp"
#include "../io/vtk_grid.hpp"

namespace signum::mpi {

/// How names end of what is written: .h5 and .vtkhdf (VTK's HDF5, with the arrays of signum
/// beside), .npy and .i32 (the faces, as signum writes them), .json (for as many faces as one rank
/// holds), .pvtu (a piece a rank beside it: the bytes depend on their number).
[[nodiscard]] std::string endings();

struct Whole {
    const std::vector<distributed::Placed>& slice;  ///< of all sites, by number, rank after rank
    std::int64_t sites;                             ///< of all ranks
    const Stretch& stretch;
    Metric metric;
    WeightIs weight_is;
    const VtkGrid& piece;  ///< of this rank; asked for by .pvtu alone
};
/// `name` ends as one of them. Collective. Throws NameError, MachineError and
/// std::invalid_argument.
void write(Communicator& ranks, const std::string& name, const Whole& whole);

}  // namespace signum::mpi
