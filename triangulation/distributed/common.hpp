#pragma once
/// The sites that every part knows: those whose cells may have no end, and the greatest.
///
/// Who has a cell without an end is seen from some direction as no other is. Let some vectors g
/// span a cone, and u be a site that is beyond t along each of them: g·u > g·t, by more than what
/// t's radius is greater than u's. Then far out in every direction of the cone u is nearer than t:
///  - power, in the plane and in space: the centre of t is not on the hull of all where that holds
///    in cones all around;
///  - Euclid: with unit vectors, two that follow one another around: all those between are αg + βg'
///    with α + β >= 1;
///  - supremum, Manhattan: two vertices of the dual norm's ball that follow one another; far out
///  the
///    norm of q - c is the greater one of g·(q - c) and g'·(q - c).
/// So t has a cell with an end if for any cone there is such a site. Tried is one that is far out
/// along the cone's middle and lies in the same strip across as t. Bounds of what rounding does are
/// on the safe side.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "exchange.hpp"
#include "site_store.hpp"

namespace signum::distributed {

/// How many of the greatest sites are common: what each of a part's faces may be reached by is
/// judged by the greatest of the others.
inline constexpr std::size_t most_greatest = 64;

/// For each cone, sites that are farthest out in strips.
class Farthest {
 public:
    /// `whole`: of all sites.
    Farthest(const Kind& kind, const Extent& whole);

    /// Some of the sites: the more, the fewer others are taken for endless. Of many it takes a
    /// part, evenly. O(n).
    void include(std::span<const Placed> sites);
    /// Whether any site in an extent (SiteStore) has a cell with an end. Asks cone `first` before
    /// the others; it becomes a cone that says no.
    [[nodiscard]] bool have_an_end(const Extent& extent, std::size_t& first) const noexcept;

 private:
    struct Far {
        Site3 site;
        double out = -__builtin_huge_val();  ///< along the cone's vectors, all together
    };
    using Vector = std::array<double, axes>;
    struct Cone {
        std::vector<Vector> vectors;               ///< as many as there are dimensions
        std::vector<std::array<double, 2>> range;  ///< of the whole across, by each but the first
    };

    [[nodiscard]] std::size_t dimension() const noexcept { return cones_.front().vectors.size(); }
    /// Whether a known site is beyond all that are in an extent, in a cone.
    [[nodiscard]] bool is_beyond(std::size_t cone, const Extent& extent) const noexcept;
    /// How far a site is out along a cone's vectors, or the farthest place of an extent.
    [[nodiscard]] static Vector along(const Cone& cone, const Extent& extent) noexcept;
    /// Where in far_ the strip of a cone is.
    [[nodiscard]] std::size_t strip(std::size_t cone, const Vector& out) const noexcept;

    bool has_radii_;
    std::vector<Cone> cones_;  ///< all around
    std::size_t strips_;       ///< along one coordinate across
    std::size_t strips_of_cone_ = 1;
    std::vector<Far> far_;
};

/// Those of a part of which it does not follow that their cells have an end: neither by what is
/// farthest, a first choice among them included, nor by a tessellation of the rest.
[[nodiscard]] std::vector<Placed> endless_among(const SiteStore& store, const Farthest& farthest);

/// Those with the greatest weights or radii, most_greatest or, where others have the same, fewer.
[[nodiscard]] std::vector<Placed> greatest_of(std::span<const Placed> sites, const Kind& kind);

/// All that are common, by their numbers: of what endless_among() finds in the parts those whose
/// cells have no end, and of what greatest_of() finds there the greatest. Throws NoStructure
/// (part.hpp) where all sites lie on one line, in the power metric, or in one plane, of space, or
/// one hides all others.
[[nodiscard]] std::vector<Placed> common_of(std::vector<Placed> endless,
                                            std::span<const Placed> greatest, const Kind& kind);

}  // namespace signum::distributed
