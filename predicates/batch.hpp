#pragma once
/// Batches: the signs of ccw and of the power metric's in_circle for many questions at once.
///
/// Laws:
///  1. The signs are those of ccw and power::in_circle, one by one, for all finite doubles and in
///     every environment (ccw.hpp, laws 1 to 5).
///  2. The filter of several questions is computed by one instruction each, where the library is
///     built with Highway (SIGNUM_WITH_HIGHWAY) and the processor has vectors of doubles; what it
///     leaves open, and everything elsewhere, is asked one by one.
///
/// An operand is any view of sites (core/strided_sites.hpp): a vector of Point, Site or
/// power::Site, columns, a matrix. Sites one behind another and columns are read fastest. One site
/// alone serves for all questions: a view of one site, or of a stride of 0.

#include <array>
#include <cstdint>
#include <span>

#include "../core/index.hpp"
#include "../core/strided_sites.hpp"

namespace signum {

/// signs[i] = ccw(a[i], b[i], c[i]), of the centres. O(n); no memory but for signs that the filter
/// leaves open.
/// Preconditions: each operand has signs.size() sites or one, finite coordinates.
void ccw_batch(const StridedSites& a, const StridedSites& b, const StridedSites& c,
               std::span<std::int8_t> signs) noexcept;

/// The same of sites that are named by their places in one array: signs[t] is ccw of the sites at
/// triples[t]. Preconditions: as many triples as signs, each index in [0, sites.size()).
void ccw_batch(const StridedSites& sites, std::span<const std::array<Index, 3>> triples,
               std::span<std::int8_t> signs) noexcept;

namespace power {

/// signs[m] = in_circle(i[m], j[m], k[m], q[m]): points where no operand has a third number, else
/// sites with radii or with weights. O(n), as above.
/// Preconditions: each operand has signs.size() sites or one, operands with a third number agree
/// on what it is, exists(i[m], j[m], k[m]), finite numbers.
void in_circle_batch(const StridedSites& i, const StridedSites& j, const StridedSites& k,
                     const StridedSites& q, std::span<std::int8_t> signs) noexcept;

/// The same of sites that are named by their places in one array: signs[t] is in_circle of the
/// sites at quadruples[t], the last of which is q. Preconditions: as many quadruples as signs, each
/// index in [0, sites.size()).
void in_circle_batch(const StridedSites& sites, std::span<const std::array<Index, 4>> quadruples,
                     std::span<std::int8_t> signs) noexcept;

}  // namespace power
}  // namespace signum
