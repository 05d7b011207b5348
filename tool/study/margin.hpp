#pragma once
/// How near the determinants of a tessellation come to 0: what an arithmetic has to resolve to see
/// which of two sites is nearer.
///
/// Law: the margin of an edge between two finite faces is |determinant| / magnitude of the
/// in_circle that asks for it, the site across against the face, the magnitude being that of its
/// terms: from 1, far from a tie, to 0, a tie. Arithmetic with a relative error e, a dozen
/// roundings in, can take the wrong sign where the margin is below some 10 e: 1e-15 for doubles,
/// 1e-6 for floats.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/tessellation.hpp"

namespace signum::study {

/// For every edge between two finite faces of four sites the calls of in_circle that it answers:
/// the sites of one face, and the one across. O(n).
[[nodiscard]] std::vector<std::array<Index, 4>> inner_edges(const Tessellation& tessellation);

/// For every facet between two finite cells of sites that span space the calls of in_sphere: the
/// sites of one cell, and the one across. O(n). None of flat sites.
[[nodiscard]] std::vector<std::array<Index, 5>> inner_facets(const SpaceTessellation& tessellation);

struct Margins {
    static constexpr int least_power = -20;

    std::int64_t edges = 0;  ///< between two finite faces of four sites
    std::int64_t ties = 0;   ///< margin 0
    /// powers[k]: margins at most 10^-k and above 10^-(k+1); the last one all that are less.
    std::array<std::int64_t, -least_power + 1> powers = {};
    std::optional<double> least;  ///< the least margin but 0
};

/// Of a canonical tessellation. In rationals where doubles do not tell two digits; O(n). Threads as
/// Options::threads.
///
/// Magnitudes: in the power metric, with rows relative to the site across, the sum over the three
/// of (x² + y² + |w|)(|x'y''| + |x''y'|). In the Euclidean metric that of A - L √Γ
/// (predicates/formulas/apollonius.hpp), multiplied out, all terms positive. In the Manhattan and
/// supremum metrics, where nothing is multiplied, a margin is how far the site stays outside the
/// square over the sum of |x| + |y| + |r| of the four.
[[nodiscard]] Margins margins_of(const Tessellation& canonical, int threads = 0);

}  // namespace signum::study
