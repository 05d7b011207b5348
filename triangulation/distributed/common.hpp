#pragma once
/// The sites that every part knows: those whose cells may have no end, and the greatest.
///
/// Who has a cell without an end is seen from some direction as no other is. Let g and g' be two
/// vectors that follow one another around, and u a site that is beyond t along both: g·u > g·t and
/// g'·u > g'·t, each by more than what t's radius is greater than u's. Then far out in every
/// direction between, u is nearer than t:
///  - power: the centre of t is not on the hull of all where that holds all around;
///  - Euclid: with unit vectors, all those between are αg + βg' with α + β >= 1;
///  - supremum, Manhattan: g and g' are vertices of the dual norm's ball that follow one another;
///    far out the norm of q - c is the greater one of g·(q - c) and g'·(q - c).
/// So t has a cell with an end if for any two such vectors there is such a site. Tried is one that
/// is far out along g + g' and lies in the same strip across as t. Bounds of what rounding does are
/// on the safe side.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "../metric.hpp"
#include "exchange.hpp"
#include "site_store.hpp"

namespace signum::distributed {

/// How many of the greatest sites are common: what each of a part's faces may be reached by is
/// judged by the greatest of the others.
inline constexpr std::size_t most_greatest = 64;

/// For each two vectors, sites that are farthest out in strips.
class Farthest {
 public:
    /// `whole`: of all sites.
    Farthest(Metric metric, const Extent& whole);

    /// Some of the sites: the more, the fewer others are taken for endless. O(n).
    void include(std::span<const Placed> sites);
    /// Whether any site in an extent (SiteStore) has a cell with an end.
    [[nodiscard]] bool have_an_end(const Extent& extent) const noexcept;

 private:
    static constexpr std::size_t strips = 512;
    struct Far {
        Site site;
        double out = -__builtin_huge_val();  ///< along g + g'
    };

    /// The greatest of g·c over an extent, g the k-th vector; all lengths scaled.
    [[nodiscard]] double most_along(std::size_t k, const Extent& extent) const noexcept;
    [[nodiscard]] double along(std::size_t k, const Site& site) const noexcept;
    /// Of a place across g + g'.
    [[nodiscard]] std::size_t strip(std::size_t k, double across) const noexcept;

    bool has_radii_;
    std::vector<Point> vectors_;                 ///< all around
    std::vector<std::array<double, 2>> across_;  ///< of the whole, for each two
    std::vector<Far> far_;                       ///< strip by strip
};

/// Those of a part of which it does not follow that their cells have an end, by a first choice
/// among them, too.
[[nodiscard]] std::vector<Placed> endless_among(const SiteStore& store, const Farthest& farthest);

/// Those with the greatest third numbers, most_greatest or, where others have the same, fewer.
[[nodiscard]] std::vector<Placed> greatest_of(std::span<const Placed> sites, Metric metric,
                                              WeightIs weight_is);

/// All that are common, by their numbers: of what endless_among() finds in the parts those whose
/// cells have no end, and of what greatest_of() finds there the greatest. Throws NoStructure
/// (part.hpp) where all sites lie on one line, in the power metric, or one hides all others.
[[nodiscard]] std::vector<Placed> common_of(std::vector<Placed> endless,
                                            std::span<const Placed> greatest, Metric metric,
                                            WeightIs weight_is);

}  // namespace signum::distributed
