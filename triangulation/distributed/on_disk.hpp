#pragma once
/// Tessellations of more sites than fit into memory: parts that lie on a disk are
/// settled one after the other, or as many at a time as there are threads. The result is that of
/// triangulate().

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "exchange.hpp"
#include "part.hpp"

namespace signum::distributed {

/// Sites that are read slice by slice, as often as they are asked for.
struct SlicedSites {
    std::size_t slices;
    /// Those of one slice, numbered from 0 through all of them.
    std::function<std::vector<Placed>(std::size_t slice)> read;
};

/// How many bytes a site of a part takes while that is settled, and when faces are sorted.
[[nodiscard]] constexpr std::int64_t bytes_a_site(const Kind& kind) noexcept {
    return kind.dimension == 3 ? 1200 : 320;
}

/// Each part has a file open, and there may be as many again.
inline constexpr std::size_t most_parts = 500;

struct DiskOptions {
    /// How many parts so many sites are dealt to. Called once, when all are counted.
    std::function<std::size_t(std::int64_t sites)> parts = [](std::int64_t) -> std::size_t {
        return 1;
    };
    int threads = 0;           ///< that settle parts, as Options::threads
    std::string folder = ".";  ///< where files without a name take some 140 bytes a site, of
                               ///< space 270
    std::stop_token stop = {};
    std::function<void(double)> progress = {};  ///< by one thread at a time
};

/// How much there is of it.
struct WholeCounts {
    std::size_t parts = 0;
    std::int64_t sites = 0;
    std::int64_t hidden = 0;
    std::int64_t faces = 0;  ///< or cells
    std::int64_t infinite_faces = 0;
};

/// Calls begin(counts), and put(numbers) for one stretch after the other of the faces in the order
/// of arrays.hpp, three numbers each, or of cells in that of SpaceTessellation, four numbers each.
/// Throws NoStructure, std::invalid_argument (what check() says, or no part, or more than
/// most_parts), Stopped, std::system_error where the disk fails.
void triangulate_on_disk(const SlicedSites& sites, const Kind& kind, const DiskOptions& options,
                         const std::function<void(const WholeCounts&)>& begin,
                         const std::function<void(std::span<const std::int64_t>)>& put);

}  // namespace signum::distributed
