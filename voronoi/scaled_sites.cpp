#include "scaled_sites.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "../core/error_free.hpp"
#include "../exact/multiprecision.hpp"
#include "../predicates/ccw.hpp"
#include "../predicates/space/ccw.hpp"
#include "../triangulation/space/cramer.hpp"

namespace signum {
namespace {

using exact::Rational;

/// Below it a product of three differences of coordinates and two squares is a double.
constexpr double largest = 0x1p200;

[[nodiscard]] bool is_usual(const Point3& p) noexcept {
    // A NaN fails.
    return std::fabs(p.x) <= largest && std::fabs(p.y) <= largest && std::fabs(p.z) <= largest;
}

[[nodiscard]] Point3 divided(const Point3& p, int exponent) noexcept {
    return {std::ldexp(p.x, -exponent), std::ldexp(p.y, -exponent), std::ldexp(p.z, -exponent)};
}

[[nodiscard]] int exponent_of(const Box3& box) {
    // Halves, whose difference is a double.
    const auto side = [&](double Point3::*axis) { return box.high.*axis / 2 - box.low.*axis / 2; };
    const double longest = std::max({side(&Point3::x), side(&Point3::y), side(&Point3::z)});
    int exponent = 0;
    std::frexp(longest, &exponent);
    return exponent;
}

template <class S>
[[nodiscard]] ScaledSite scaled(const S& site, int exponent) noexcept {
    const Point3 centre = divided({site.x, site.y, site.z}, exponent);
    if constexpr (requires { site.r; }) {
        const double r = std::ldexp(site.r, -exponent);
        // What is below 2^-400 nobody sees beside the box.
        if (std::fabs(r) < 0x1p-400 || !(std::fabs(r) <= largest)) return {centre, r * r, 0.0};
        const auto [high, low] = two_product(r, r);
        return {centre, high, low};
    } else if constexpr (requires { site.w; }) {
        return {centre, std::ldexp(site.w, -2 * exponent), 0.0};
    } else {
        return {centre, 0.0, 0.0};
    }
}

struct ExactSite {
    std::array<Rational, 3> x;
    Rational weight;
};
template <class S>
[[nodiscard]] ExactSite exact_site(const S& site) {
    using exact::to_rational;
    ExactSite result = {{to_rational(site.x), to_rational(site.y), to_rational(site.z)}, 0};
    if constexpr (requires { site.r; }) result.weight = to_rational(site.r) * to_rational(site.r);
    if constexpr (requires { site.w; }) result.weight = to_rational(site.w);
    return result;
}
[[nodiscard]] ExactSite exact_site(const AnySites3& sites, Index i) {
    return std::visit([&](const auto& all) { return exact_site(all[static_cast<std::size_t>(i)]); },
                      sites);
}

/// A double of a number over 2^exponent, less another, at most 2^1000 in magnitude.
[[nodiscard]] double rounded(Rational number, int exponent, double less) {
    constexpr double most = 0x1p1000;
    number = exact::scaled(std::move(number), -exponent) - exact::to_rational(less);
    const double nearest = exact::round_to_double(number);
    if (std::isnan(nearest)) return number.sign() < 0 ? -most : most;
    return std::clamp(nearest, -most, most);
}

}  // namespace

ScaledSites::ScaledSites(const AnySites3& sites, const Box3& box)
    : given_(sites), given_box_(box), box_(box) {
    if (!(box.low.x < box.high.x && box.low.y < box.high.y && box.low.z < box.high.z))
        throw std::invalid_argument("a box needs low < high along all axes");
    if (!are_finite(box.low, box.high))
        throw std::invalid_argument("the corners of a box are to be finite");
    exponent_ = exponent_of(box);
    box_ = {divided(box.low, exponent_), divided(box.high, exponent_)};
    if (!is_usual(box_.low) || !is_usual(box_.high))
        throw std::invalid_argument("the box is too small beside its coordinates");
    std::visit(
        [&](const auto& all) {
            scaled_.reserve(all.size());
            for (const auto& site : all) {
                scaled_.push_back(scaled(site, exponent_));
                const ScaledSite& made = scaled_.back();
                if (!is_usual(made.centre) || !(std::fabs(made.weight) <= largest * largest))
                    throw std::invalid_argument("site " + std::to_string(scaled_.size() - 1) +
                                                " is not finite, or too large beside the box");
            }
        },
        sites);
}

Point3 ScaledSites::direction(Index i, Index j) const noexcept {
    Point3 way = offset(i, j);
    double distance = length(way);
    if (distance < 0x1p-200) [[unlikely]] {
        // Their squares may be none, and beside the box they themselves may be: as they were given.
        way = minus(given(j), given(i));
        way = divided(way,
                      std::ilogb(std::max({std::fabs(way.x), std::fabs(way.y), std::fabs(way.z)})));
        distance = length(way);
    }
    return plus({}, way, 1.0 / distance);
}

// ---- where planes meet -------------------------------------------------------------------------

/// In rationals, in the sites' own unit of length.
class ScaledSites::Exact {
 public:
    /// Of planes m.v = h; from site i.
    Exact(const ScaledSites& all, Index i, const ThreePlanes& planes)
        : all_(all), site_(exact_site(all.given_, i)) {
        std::array<std::array<Rational, 3>, 3> m;
        std::array<Rational, 3> h;
        for (std::size_t k = 0; k < 3; ++k) {
            if (is_box_side(planes[k])) {
                const Side side = Side::named(planes[k]);
                const auto axis = static_cast<std::size_t>(side.axis_number());
                m[k] = {0, 0, 0};
                m[k][axis] = 1;
                h[k] = exact::to_rational(side.of(all.given_box_)) - site_.x[axis];
                continue;
            }
            const ExactSite other = exact_site(all.given_, planes[k]);
            h[k] = site_.weight - other.weight;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                m[k][axis] = other.x[axis] - site_.x[axis];
                h[k] += m[k][axis] * m[k][axis];
            }
            h[k] /= 2;
        }
        const auto plane = [&](std::size_t k) -> spatial::Plane<Rational> {
            return {m[k][0], m[k][1], m[k][2], h[k]};
        };
        spatial::Meeting<Rational> meeting;
        spatial::meet(meeting, plane(0), plane(1), plane(2));
        place_ = {meeting.x / meeting.determinant, meeting.y / meeting.determinant,
                  meeting.z / meeting.determinant};
    }
    /// From the eye.
    [[nodiscard]] Point3 place(const Point3& eye) const {
        Point3 result;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto x = axes_of_space[axis];
            result.*x = rounded(place_[axis] + site_.x[axis], all_.exponent_, eye.*x);
        }
        return result;
    }
    [[nodiscard]] bool is_outside(Side side) const {
        const auto axis = static_cast<std::size_t>(side.axis_number());
        const Rational over =
            place_[axis] + site_.x[axis] - exact::to_rational(side.of(all_.given_box_));
        return side.is_high() ? over >= 0 : over <= 0;
    }

 private:
    const ScaledSites& all_;
    ExactSite site_;
    std::array<Rational, 3> place_;
};

ScaledSites::Rows ScaledSites::rows(Index i, const ThreePlanes& planes) const noexcept {
    Rows result{};
    const Point3 eye_of_site = eye(i);
    const Point3 site = minus((*this)[i].centre, eye_of_site);
    double largest_square = dot(site, site);
    for (std::size_t k = 0; k < 3; ++k) {
        Point3& m = result.m[k];
        if (is_box_side(planes[k])) [[unlikely]] {
            const Side side = Side::named(planes[k]);
            m.*side.axis() = 1.0;
            result.h[k] = side.of(box_) - eye_of_site.*side.axis();
            largest_square = std::max(largest_square, result.h[k] * result.h[k]);
            continue;
        }
        m = offset(i, planes[k]);
        const double square = dot(m, m);
        result.h[k] = (square - weight_difference(i, planes[k])) / 2 + dot(m, site);
        largest_square = std::max(largest_square, square);
    }
    result.size = std::sqrt(largest_square);
    return result;
}

/// Where planes of a site are nearly parallel, those of the shortest edges that join the sites say
/// it better.
ScaledSites::Rows ScaledSites::shortest_rows(Index i, const ThreePlanes& planes) const noexcept {
    Rows result = rows(i, planes);
    std::array<Index, 4> sites = {i};
    std::size_t count = 1;
    std::size_t size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        if (is_box_side(planes[k])) {
            std::swap(result.m[size], result.m[k]);
            std::swap(result.h[size++], result.h[k]);
        } else {
            sites[count++] = planes[k];
        }
    }
    struct Edge {
        std::size_t from;
        std::size_t to;
        double square;
    };
    std::array<Edge, 6> edges{};
    std::size_t found = 0;
    for (std::size_t from = 0; from < count; ++from)
        for (std::size_t to = from + 1; to < count; ++to) {
            const Point3 way = offset(sites[from], sites[to]);
            edges[found++] = {from, to, dot(way, way)};
        }
    // Those that there are not come last.
    for (std::size_t e = found; e < edges.size(); ++e) edges[e].square = HUGE_VAL;
    std::ranges::sort(edges, {}, &Edge::square);
    std::array<std::size_t, 4> part = {0, 1, 2, 3};
    for (std::size_t e = 0; e < found; ++e) {
        const auto& [from, to, square] = edges[e];
        if (part[from] == part[to]) continue;
        std::ranges::replace(part, std::size_t{part[to]}, std::size_t{part[from]});
        const Point3 m = offset(sites[from], sites[to]);
        const Point3 begin = minus((*this)[sites[from]].centre, eye(i));
        result.m[size] = m;
        result.h[size] = (square - weight_difference(sites[from], sites[to])) / 2 + dot(m, begin);
        ++size;
        result.size = std::max(result.size, length(begin));
    }
    return result;
}

/// By Cramer's rule, and one step of refinement. A row of length m is known to within a few
/// roundings of m (size + |v|), and so is the remainder that the step begins with; of these the
/// corner has sqrt(squares) / |determinant| for each row at most. 2^-46 is 128 roundings, more than
/// all operations in it. False where that is more than 2^-37 of the distance.
bool ScaledSites::meet(const Rows& rows, Corner& corner) noexcept {
    const auto& [m, h, size] = rows;
    const Point3 bc = cross(m[1], m[2]);
    const Point3 ca = cross(m[2], m[0]);
    const Point3 ab = cross(m[0], m[1]);
    const double determinant = dot(m[0], bc);
    const double squares = dot(m[0], m[0]) * dot(m[1], m[1]) * dot(m[2], m[2]);
    // Neither an overflow nor a NaN gets through, nor what underflow may have touched.
    constexpr double least = 0x1p-16;
    if (!(determinant * determinant > least * squares) || !(squares > 0x1p-900) ||
        !(squares < 0x1p900)) [[unlikely]]
        return false;
    const double inverse = 1.0 / determinant;
    const auto solve = [&](double i, double j, double k) -> Point3 {
        return {(i * bc.x + j * ca.x + k * ab.x) * inverse,
                (i * bc.y + j * ca.y + k * ab.y) * inverse,
                (i * bc.z + j * ca.z + k * ab.z) * inverse};
    };
    const Point3 first = solve(h[0], h[1], h[2]);
    corner.place = plus(
        first, solve(h[0] - dot(m[0], first), h[1] - dot(m[1], first), h[2] - dot(m[2], first)));
    const double distance = length(corner.place);
    corner.error = 0x1p-46 * std::sqrt(squares) * std::fabs(inverse) * (size + distance) + 0x1p-900;
    return corner.error <= 0x1p-37 * distance;
}

Corner ScaledSites::corner(Index i, const ThreePlanes& planes) const {
    Corner result;
    if (meet(rows(i, planes), result)) [[likely]]
        return result;
    if (meet(shortest_rows(i, planes), result)) return result;
    result.place = Exact(*this, i, planes).place(eye(i));
    result.error = 0x1p-52 * length(result.place) + 0x1p-1000;
    return result;
}

bool ScaledSites::is_outside(Index i, const ThreePlanes& planes, const Corner& corner,
                             Side side) const {
    const double at = side.of(box_) - eye(i).*side.axis();
    const double over = (corner.place.*side.axis() - at) * (side.is_high() ? 1.0 : -1.0);
    const double slack = corner.error + 0x1p-51 * std::fabs(at);
    if (over > slack) return true;
    if (over < -slack) return false;
    return Exact(*this, i, planes).is_outside(side);
}

std::uint32_t ScaledSites::sides_beyond(Index i, const ThreePlanes& planes,
                                        const Corner& corner) const {
    const Point3 from = eye(i);
    std::uint32_t result = 0;
    bool is_certain = true;
    for (int axis = 0; axis < 3; ++axis) {
        const auto x = axes_of_space[axis];
        const double low = box_.low.*x - from.*x;
        const double high = box_.high.*x - from.*x;
        const double slack = corner.error + 0x1p-50 * std::max(std::fabs(low), std::fabs(high));
        const double place = corner.place.*x;
        is_certain &= std::fabs(place - low) > slack && std::fabs(place - high) > slack;
        result |= static_cast<std::uint32_t>(place < low) << 2 * axis;
        result |= static_cast<std::uint32_t>(place > high) << (2 * axis + 1);
    }
    if (is_certain) [[likely]]
        return result;
    const Exact exact(*this, i, planes);
    result = 0;
    for (int number = 0; number < 6; ++number)
        result |= static_cast<std::uint32_t>(exact.is_outside(Side(number))) << number;
    return result;
}

Point3 ScaledSites::given(Index i) const noexcept {
    return std::visit([&](const auto& all) { return centre3(all[static_cast<std::size_t>(i)]); },
                      given_);
}

Sign ScaledSites::sign_of_offset(Index i, Index j, int axis) const {
    const double a = given(i).*axes_of_space[axis];
    const double b = given(j).*axes_of_space[axis];
    return b > a ? 1 : b < a ? -1 : 0;
}

Sign ScaledSites::sign_of_cross(Index i, Index j, Index k, int axis) const {
    const auto projected = [&](Index each) -> Point {
        const Point3 p = given(each);
        return {p.*axes_of_space[(axis + 1) % 3], p.*axes_of_space[(axis + 2) % 3]};
    };
    return ccw(projected(i), projected(j), projected(k));
}

bool ScaledSites::is_middle_nearer(Index i, Index j) const {
    const Point3 middle = plus(plus({}, box_.low, 0.5), box_.high, 0.5);
    const Point3 way = offset(i, j);
    const Point3 to_middle = minus(middle, (*this)[i].centre);
    const double square = dot(way, way);
    const double difference = weight_difference(i, j);
    const double over = 2 * dot(way, to_middle) - square + difference;
    const double bound = 0x1p-48 * (length(way) * (length(to_middle) + length(middle)) + square +
                                    std::fabs(difference)) +
                         0x1p-900;
    if (std::fabs(over) > bound) return over > 0.0;
    const ExactSite s = exact_site(given_, i);
    const ExactSite t = exact_site(given_, j);
    Rational exact = t.weight - s.weight;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto x = axes_of_space[axis];
        const Rational ends =
            exact::to_rational(given_box_.low.*x) + exact::to_rational(given_box_.high.*x);
        exact += (t.x[axis] - s.x[axis]) * (ends - t.x[axis] - s.x[axis]);
    }
    return exact > 0;
}

}  // namespace signum
