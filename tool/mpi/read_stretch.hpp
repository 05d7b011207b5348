#pragma once
/// A tessellation from a file, of which each rank reads a stretch.

#include <cstdint>
#include <optional>
#include <string>

#include "../../mpi/communicator.hpp"
#include "../../mpi/triangulate.hpp"

namespace signum::mpi {

struct ReadStretch {
    Stretch stretch;
    /// What the file says of itself: not one of faces alone.
    struct Says {
        std::int64_t sites;
        distributed::Kind kind;
    };
    std::optional<Says> says;
};

/// `name`: .h5, .hdf5 or .vtkhdf as signum-mpi writes it, or .npy and .i32, faces alone;
/// `dimension`: of the latter. Collective. Throws InputError and MachineError.
[[nodiscard]] ReadStretch read_stretch(Communicator& ranks, const std::string& name,
                                       std::size_t dimension);
/// Whether a name ends as one of a file that says itself what it is.
[[nodiscard]] bool is_hdf5(const std::string& name);

}  // namespace signum::mpi
