#pragma once
/// Tessellations of more sites than fit into memory: parts that lie on a disk are
/// settled one after the other, or as many at a time as there are threads. The result is that of
/// triangulate().

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
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

/// They are not the same each time.
class SitesChanged : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

/// How many bytes a site of a part takes while that is settled, and when faces are sorted.
[[nodiscard]] constexpr std::int64_t bytes_a_site(const Kind& kind) noexcept {
    return kind.dimension == 3 ? 1200 : 320;
}

/// Each part has a file open, and there may be as many again.
inline constexpr std::size_t most_parts = 500;

/// How much there is of it.
struct WholeCounts {
    std::size_t parts = 0;
    std::size_t settled = 0;  ///< parts that this call settles: a piece has the faces of the others
    std::int64_t sites = 0;
    std::int64_t hidden = 0;
    std::int64_t faces = 0;  ///< or cells
    std::int64_t infinite_faces = 0;
    std::uint64_t checksum = 0;  ///< of the sites and their numbers
};

/// What an earlier call left.
struct PiecesFound {
    std::size_t all = 0;  ///< pieces, whether they are there or not
    std::size_t whole = 0;
    std::vector<std::string> damaged;  ///< their files
};

/// A call keeps pieces of its work, and a later one goes on from them: the sites of each part, and
/// the faces of each part that is settled. A piece has its name, .piece at the end, once all of it
/// is on the disk. A damaged one is made anew, and so is one of other sites, of another kind or
/// number of parts.
struct Pieces {
    /// A folder that is there, for one call at a time. The caller removes it when it has no more
    /// use for it. Empty: nothing is kept.
    std::string folder = {};
    /// Called with the parts, the sites and their checksum, before a piece is read. Where it
    /// throws, pieces stay as they are.
    std::function<void(const WholeCounts&)> belong = {};
    /// Called once all pieces have been read, before parts are settled.
    std::function<void(const PiecesFound&)> found = {};
};

struct DiskOptions {
    /// How many parts so many sites are dealt to. Called once, when all are counted.
    std::function<std::size_t(std::int64_t sites)> parts = [](std::int64_t) -> std::size_t {
        return 1;
    };
    int threads = 0;           ///< that settle parts, as Options::threads
    std::string folder = ".";  ///< where files without a name take some 140 bytes a site, of
                               ///< space 270
    Pieces pieces = {};        ///< which take some 90 bytes a site, of space 260
    std::stop_token stop = {};
    std::function<void(double)> progress = {};  ///< by one thread at a time
};

/// Calls begin(counts), and put(numbers) for one stretch after the other of the faces in the order
/// of arrays.hpp, three numbers each, or of cells in that of SpaceTessellation, four numbers each.
/// Throws NoStructure, std::invalid_argument (what check() says, or no part, or more than
/// most_parts), SitesChanged, Stopped, std::system_error where the disk fails.
void triangulate_on_disk(const SlicedSites& sites, const Kind& kind, const DiskOptions& options,
                         const std::function<void(const WholeCounts&)>& begin,
                         const std::function<void(std::span<const std::int64_t>)>& put);

}  // namespace signum::distributed
