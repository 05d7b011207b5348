#pragma once
/// One part of a tessellation, which is built where its sites are, and told by others what it has
/// to know of theirs.
///
/// A part builds the tessellation of its own sites, of those of others that are near, and of the
/// *common* ones, which every part knows: all sites whose cells have no end, and some of the
/// greatest. It then asks about each face at an own site that a site which it does not know may
/// reach; what conflicts is inserted, and the faces that come with it are asked about, until
/// nothing conflicts.
///
/// Theorem. In the end the star of every own site is that in the whole, and who is hidden in the
/// part is hidden in the whole.
///
/// A face that no site of the whole conflicts with is one of the whole, and a site is hidden in the
/// whole where it is in a part of it. It remains that every face at an own site is without conflict
/// in the end. No site that the part knows conflicts with it. One at infinity is as in the whole,
/// for all neighbours of infinity are known. Of a finite one let t be a site that is not known: its
/// centre lies beyond the box of the own sites, grown by how far others were asked to look, and so
/// beyond the line of one of its sides, and its weight or radius is G at most. A face is asked
/// about where such a t may reach its vertex (Ball); and *all those are found* by a search from the
/// faces that have another vertex than own sites:
///  - power, in the plane and in space: from face to face across those that t may reach, for the
///    faces in conflict with t lie side by side. One of them contains t's centre, which the
///    triangle of three own sites cannot, or is at infinity.
///  - the others: from site to site of the faces that lead on. Let n be towards t's side, at a
///  right
///    angle to the line, h the least n·t there, and f(q) = d(q, s) - r_s + n·q, where s is the site
///    that is nearest to q. A face leads on where f >= h - G at its vertex. That is more than what
///    t may reach: beyond the line the vertex of large discs leads on, whatever lies there. t takes
///    all points between any of its cell and its centre, and there f >= h - G. From the centre
///    towards n f does not fall, and in the end one is in a cell without an end. Where that way
///    crosses an edge, f is no less at one of its ends (parts/reach.hpp), and that face joins the
///    two sites.
/// Later on all faces that were not there are at sites that came.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <stop_token>
#include <vector>

#include "../arrays.hpp"
#include "../space/triangulate.hpp"
#include "exchange.hpp"
#include "site_store.hpp"

namespace signum::distributed {

/// What all know of each part.
struct PartBounds {
    Extent extent;   ///< of its sites that are not common
    double spacing;  ///< SiteStore::spacing()
};

/// A face of the plane, or a cell of space, by the numbers of its sites in the whole; -1 for
/// infinity, which comes first, or else the least. In space the least of the others is the second.
template <std::size_t corners>
using WholeCell = std::array<std::int64_t, corners>;
using WholeFace = WholeCell<3>;

/// Which face is across an edge of another one: that opposite vertex `corner` of `face`.
struct Adjacency {
    WholeFace face;
    std::int64_t corner;
    WholeFace neighbour;
};

struct WholeHidden {
    std::int64_t site;
    std::int64_t by;
};

/// All sites lie on one line (power), or in one plane (space), or one hides all others: there is
/// nothing that parts could share.
class NoStructure : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

/// All that a part knows, as a tessellation of its own, whose sites stand in the order of their
/// numbers: around an own site it is that of the whole, number by number.
struct Known {
    std::vector<std::int64_t> ids;
    std::vector<char> are_own;
    std::vector<Site3> sites;  ///< in the plane z is 0
    TessellationArrays plane;  ///< of the plane,
    SpaceTessellation space;   ///< or of space
};

class Part {
 public:
    Part() = default;
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;
    virtual ~Part() = default;

    /// `number`: which of the parts it is. `common`: as above, those of other parts. Expected O(n
    /// log n), and the number of sites told. Throws Stopped, NoStructure, and what the exchange
    /// does.
    virtual void settle(const SiteStore& own, std::span<const Placed> common,
                        std::span<const PartBounds> parts, std::size_t number, Exchange& exchange,
                        const std::stop_token& stop) = 0;

    /// The faces or cells whose least site is an own one (WholeCell).
    virtual void each_face(const std::function<void(std::span<const std::int64_t>)>& put) const = 0;
    /// Both sides of each edge whose lesser site is an own one, where there are several between its
    /// two sites: of all others the faces tell. In space there are none.
    virtual void each_adjacency(const std::function<void(const Adjacency&)>& put) const = 0;
    /// The neighbours of each visible own site, -1 for infinity: in the plane counterclockwise, one
    /// as often as there are edges between the two; in space by their numbers.
    virtual void each_star(
        const std::function<void(std::int64_t site, std::span<const std::int64_t> neighbours)>& put)
        const = 0;
    /// O(n log n).
    [[nodiscard]] virtual Known known() const = 0;
    /// The own sites that are hidden, and who is nearest to their centres in the whole.
    [[nodiscard]] virtual std::vector<WholeHidden> hidden() const = 0;
    /// How many sites of others were told, how often it asked, and how many faces and edges it
    /// asked about.
    struct Told {
        std::size_t sites = 0;
        std::size_t rounds = 0;
        std::size_t faces = 0;
        std::size_t edges = 0;
    };
    [[nodiscard]] virtual Told told() const noexcept = 0;
};

[[nodiscard]] std::unique_ptr<Part> make_part(const Kind& kind);

}  // namespace signum::distributed
