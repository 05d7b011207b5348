/// The predicates, for arrays of any shape.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <type_traits>
#include <vector>

#include "../../exact/sign_of_sum.hpp"
#include "../../motion/meeting_time.hpp"
#include "../../predicates/batch.hpp"
#include "../../triangulation/kernels/predicates_of.hpp"
#include "broadcast.hpp"
#include "names.hpp"
#include "parts.hpp"

namespace signum::python {
namespace {

/// A point or a site, which is nothing but its numbers.
template <class S>
S as(const Row& row) {
    std::array<double, sizeof(S) / sizeof(double)> numbers;
    for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = row[static_cast<int>(k)];
    return std::bit_cast<S>(numbers);
}

// Where a predicate says nothing, Python says so.
void require(bool holds, const char* otherwise) {
    if (!holds) throw std::invalid_argument(otherwise);
}
constexpr const char* no_circle = "no circle touches i, j and k counterclockwise (exists)";
constexpr const char* no_sphere = "no sphere touches i, j, k and l, turned positively (exists)";

/// The predicates of a metric, which refuse what they say nothing of.
template <class Predicates>
struct Signs : Predicates {
    static constexpr bool is_additive = triangulation::Additive<Predicates>;
    using Predicates::exists;
    using Predicates::hidden;
    using S = typename Predicates::SiteType;
    using S3 = typename Predicates::InSpace::SiteType;

    static int in_circle(const S& i, const S& j, const S& k, const S& q) {
        require(exists(i, j, k), no_circle);
        if constexpr (is_additive)
            require(!hidden(q, i) && !hidden(q, j) && !hidden(q, k), "q is hidden by i, j or k");
        return Predicates::in_circle(i, j, k, q);
    }
    static int in_circle_infinite(const S& a, const S& b, const S& q) {
        if constexpr (is_additive)
            require(!hidden(a, b) && !hidden(b, a), "one of a and b hides the other");
        else
            require(a.x != b.x || a.y != b.y, "a and b have one centre");
        return Predicates::in_circle_infinite(a, b, q);
    }
    static int in_sphere(const S3& i, const S3& j, const S3& k, const S3& l, const S3& q,
                         int number) {
        const int spheres = Predicates::InSpace::spheres(i, j, k, l);
        if constexpr (Predicates::InSpace::are_numbered) {
            require(spheres != triangulation::infinitely_many,
                    "infinitely many spheres touch i, j, k and l");
            require(number >= 0 && number < spheres, "so many spheres do not touch i, j, k and l");
        } else {
            require(spheres > 0, no_sphere);
        }
        return Predicates::InSpace::in_sphere_decision(i, j, k, l, q,
                                                       static_cast<std::uint8_t>(number))
            .sign;
    }
};

/// Of all rows ask(signs, rows...), with the predicates of the metric.
template <std::size_t n, class Ask>
py::object in_metric(const std::string& name, const std::string& weight_is, const Broadcast<n>& all,
                     Ask ask) {
    const Metric metric = metric_of(name);
    const WeightIs third = weight_of(weight_is);
    if (third == WeightIs::weight && !traits_of(metric).has_weights)
        throw std::invalid_argument(no_weights(metric));
    return triangulation::with_predicates(
        metric, third, [&]<class Predicates>(Predicates) -> py::object {
            return all([&](const auto& rows) {
                return std::apply(
                    [&](const auto&... row) { return ask(Signs<Predicates>{}, row...); }, rows);
            });
        });
}
/// ask(signs, sites...), with a site of each row.
template <std::size_t n, class Ask>
py::object in_plane(const std::string& metric, const std::string& weight_is,
                    const Broadcast<n>& all, Ask ask) {
    return in_metric(metric, weight_is, all, [&](auto signs, const auto&... row) {
        return ask(signs, as<typename decltype(signs)::S>(row)...);
    });
}

py::object ccw_of(const py::object& a, const py::object& b, const py::object& c,
                  const py::object& d) {
    if (d.is_none()) {
        const Broadcast<3> all({a, b, c}, operands("abc", 2, 2));
        py::object signs;
        if (all.as_batch(signs, [](const auto& s, auto to) { ccw_batch(s[0], s[1], s[2], to); }))
            return signs;
        return all(
            [](const auto& r) { return ccw(as<Point>(r[0]), as<Point>(r[1]), as<Point>(r[2])); });
    }
    return Broadcast<4>({a, b, c, d}, operands("abcd", 3, 3))([](const auto& r) {
        return ccw(as<Point3>(r[0]), as<Point3>(r[1]), as<Point3>(r[2]), as<Point3>(r[3]));
    });
}

py::object exists(const py::object& i, const py::object& j, const py::object& k,
                  const std::string& metric, const std::string& weight_is) {
    return in_plane(metric, weight_is, Broadcast<3>({i, j, k}, operands("ijk", 2, 3)),
                    [](auto signs, const auto&... s) { return signs.exists(s...); });
}

py::object in_circle(const py::object& i, const py::object& j, const py::object& k,
                     const py::object& q, const std::string& metric, const std::string& weight_is) {
    return in_plane(metric, weight_is, Broadcast<4>({i, j, k, q}, operands("ijkq", 2, 3)),
                    [](auto signs, const auto&... s) { return signs.in_circle(s...); });
}

py::object in_circle_infinite(const py::object& a, const py::object& b, const py::object& q,
                              const std::string& metric, const std::string& weight_is) {
    return in_plane(metric, weight_is, Broadcast<3>({a, b, q}, operands("abq", 2, 3)),
                    [](auto signs, const auto&... s) { return signs.in_circle_infinite(s...); });
}

py::object hidden(const py::object& q, const py::object& i, const std::string& metric,
                  const std::string& weight_is) {
    return in_plane(metric, weight_is, Broadcast<2>({q, i}, operands("qi", 2, 3)),
                    [](auto signs, const auto&... s) { return signs.hidden(s...); });
}

py::object nearer(const py::object& p, const py::object& a, const py::object& b,
                  const std::string& metric, const std::string& weight_is) {
    auto names = operands("pab", 2, 3);
    names[0].most = 2;
    return in_plane(metric, weight_is, Broadcast<3>({p, a, b}, names),
                    [](auto signs, const auto& at, const auto&... s) {
                        return signs.nearer(Point{at.x, at.y}, s...);
                    });
}

py::object in_sphere(const py::object& i, const py::object& j, const py::object& k,
                     const py::object& l, const py::object& q, const std::string& metric,
                     const std::string& weight_is, int number) {
    return in_metric(metric, weight_is, Broadcast<5>({i, j, k, l, q}, operands("ijklq", 3, 4)),
                     [number](auto signs, const auto&... row) {
                         return signs.in_sphere(as<typename decltype(signs)::S3>(row)..., number);
                     });
}

py::object sign_of_sum_along(const py::object& terms, int axis) {
    py::array array = doubles(terms);
    if (array.ndim() == 0) throw py::value_error("terms: an array of at least one axis is needed");
    if (axis < -array.ndim() || axis >= array.ndim())
        throw py::value_error("axis: there is no such axis");
    array = array.attr("swapaxes")(axis, -1);
    const py::ssize_t count = array.shape(array.ndim() - 1);
    if (count > std::numeric_limits<int>::max()) throw py::value_error("terms: too many");
    const auto most = static_cast<int>(count);
    const Broadcast<1> all({array}, {{{"terms", most, most}}});
    std::vector<double> sum(static_cast<std::size_t>(count));
    py::object result = all([&](const auto& r) {
        for (int k = 0; k < most; ++k) sum[static_cast<std::size_t>(k)] = r[0][k];
        return sign_of_sum(sum);
    });
    // The last axis has taken the place of the one that is gone.
    if (array.ndim() < 3) return result;
    const int place = axis < 0 ? axis + static_cast<int>(array.ndim()) : axis;
    if (place == array.ndim() - 1) return result;
    return py::module_::import("numpy").attr("moveaxis")(result, place, -1);
}

template <int D>
motion::GrowingBall<D> flying(const Row& row) {
    motion::GrowingBall<D> result;
    for (int k = 0; k < D; ++k) {
        result.x[k] = row[k];
        result.v[k] = row[D + 1 + k];
    }
    result.radius = row[D];
    if (result.radius < 0.0) throw std::invalid_argument("a radius is negative");
    return result;
}

/// Each box length takes time, during which no signal is looked at.
constexpr const char* too_far =
    "until then the two fly past each other's images a million times: take an earlier time";
constexpr const char* too_large =
    "the two touch millions of each other's images: take smaller radii or a larger box";
template <int D>
bool are_near(const motion::GrowingBall<D>& a, const motion::GrowingBall<D>& b,
              const motion::Effects<D>& effects, double until) {
    if (std::isinf(until)) return true;  // which the library itself refuses, or need not search
    const double time = until - std::max(a.time, b.time);
    for (int k = 0; k < D; ++k) {
        const double length = effects.box->high[k] - effects.box->low[k];
        if (!(std::fabs(a.v[k] - b.v[k]) * time <= 0x1p20 * length)) return false;
    }
    return true;
}
/// Whether the images that both touch at one time are few enough for so many times as the two fly
/// past each other's.
template <int D>
bool are_small(const motion::GrowingBall<D>& a, const motion::GrowingBall<D>& b,
               const motion::Effects<D>& effects, double until) {
    double images = 1.0;
    double turns = 1.0;
    for (int k = 0; k < D; ++k) {
        const double length = effects.box->high[k] - effects.box->low[k];
        images *= 2.0 * (a.radius / length + b.radius / length) + 2.0;
        if (std::isfinite(until))
            turns = std::max(turns, std::fabs(a.v[k] - b.v[k]) / length * until);
    }
    return images * turns <= 0x1p26;
}

template <int D>
py::object meetings(const py::object& a, const py::object& b, double until,
                    const py::object& periodic_box) {
    constexpr int columns = 2 * D + 1;
    const exact::IeeeEnvironment environment;
    motion::Effects<D> effects;
    if (!periodic_box.is_none()) {
        const Rows box(periodic_box, "periodic_box", D, D);
        if (box.size() != 2) throw py::value_error("periodic_box: two corners are needed");
        effects.periodic = true;
        effects.box.emplace();
        for (int k = 0; k < D; ++k) {
            effects.box->low[k] = box.at(0, k);
            effects.box->high[k] = box.at(1, k);
            if (!(box.at(0, k) < box.at(1, k)) || !std::isfinite(box.at(1, k) - box.at(0, k)))
                throw py::value_error(
                    "periodic_box: the first corner must be below the second, both finite");
        }
    }
    if (std::isnan(until)) throw py::value_error("until: a time is needed, not NaN");
    const Broadcast<2> all({a, b}, operands("ab", columns, columns));
    return all([&](const auto& r) {
        const motion::GrowingBall<D> first = flying<D>(r[0]);
        const motion::GrowingBall<D> second = flying<D>(r[1]);
        if (effects.periodic) {
            require(are_near(first, second, effects, until), too_far);
            require(are_small(first, second, effects, until), too_large);
        }
        return motion::meeting_time(first, second, effects, until);
    });
}

py::object meeting_time(const py::object& a, const py::object& b, double until,
                        const py::object& periodic_box) {
    const py::array balls = doubles(a);
    const bool in_space = balls.ndim() > 0 && balls.shape(balls.ndim() - 1) == 7;
    return in_space ? meetings<3>(a, b, until, periodic_box)
                    : meetings<2>(a, b, until, periodic_box);
}

}  // namespace

void bind_predicates(py::module_& module) {
    const auto metric = py::arg("metric") = "euclidean";
    const auto weight_is = py::arg("weight_is") = "radius";
    module.def("ccw", &ccw_of, py::arg("a"), py::arg("b"), py::arg("c"), py::arg("d") = py::none(),
               R"(The orientation of three points of the plane, or of four of space, exactly.

+1 where a, b, c turn counterclockwise (in space where det(b-a, c-a, d-a) > 0), 0 where they lie on one
line (in one plane), -1 otherwise. This and all predicates: the last axis of an operand is a point or a
site, the others are matched as NumPy's functions match them; the answer is an array of int8, or an int
where there is one row. Raises ValueError naming the row of a number that is not finite, or for which a
predicate has no meaning. Other threads run meanwhile.)");
    module.def(
        "exists", &exists, py::arg("i"), py::arg("j"), py::arg("k"), metric, py::kw_only(),
        weight_is,
        "Whether a circle of the metric touches i, j and k counterclockwise: bool. See ccw().");
    module.def(
        "in_circle", &in_circle, py::arg("i"), py::arg("j"), py::arg("k"), py::arg("q"), metric,
        py::kw_only(), weight_is,
        R"(Whether q is nearer to the centre of the circle around i, j and k than these, exactly.

+1 where it is, 0 where it touches the circle, -1 otherwise; sites are x, y and a radius, 0 where it is
left out. Raises ValueError where exists(i, j, k) is false and, but for the power metric, where one of
them hides q. See ccw().)");
    module.def("in_circle_infinite", &in_circle_infinite, py::arg("a"), py::arg("b"), py::arg("q"),
               metric, py::kw_only(), weight_is,
               R"(in_circle() at the hull edge from a to b, all other sites on its left.

Raises ValueError where a and b have no such edge: in the power metric those with one centre, in the others
where one hides the other. See ccw().)");
    module.def("hidden", &hidden, py::arg("q"), py::arg("i"), metric, py::kw_only(), weight_is,
               "Whether i alone hides q, the same place and size included: bool. See ccw().");
    module.def("nearer", &nearer, py::arg("p"), py::arg("a"), py::arg("b"), metric, py::kw_only(),
               weight_is,
               R"(Which of two sites is nearer to a point: +1 for a, -1 for b.

0 in the power metric where both are as near; in the others the larger radius wins, then the smaller x and
y, then a. See ccw().)");
    module.def("in_sphere", &in_sphere, py::arg("i"), py::arg("j"), py::arg("k"), py::arg("l"),
               py::arg("q"), py::arg("metric") = "power", py::kw_only(), weight_is,
               py::arg("sphere") = 0,
               R"(in_circle() of space: sites are x, y, z and a radius, 0 where it is left out.

i, j, k and l must turn positively, as in ccw(). In the Manhattan and the supremum metric several spheres
may touch four sites: sphere says which one. Raises ValueError where there is none. See ccw().)");
    module.def(
        "sign_of_sum", &sign_of_sum_along, py::arg("terms"), py::arg("axis") = -1,
        "The exact sign of sums of doubles along an axis: int8, or an int for one sum. See ccw().");
    module.def("meeting_time", &meeting_time, py::arg("a"), py::arg("b"), py::kw_only(),
               py::arg("until") = std::numeric_limits<double>::infinity(),
               py::arg("periodic_box") = py::none(),
               R"(When two balls in flight meet: float64, or a float for one pair; inf for never.

Balls are x, y, r, vx, vy, or x, y, z, r, vx, vy, vz, and fly from time 0 on. The double nearest to the
exact time at which the gap between them closes. periodic_box: two corners; then until must be finite, or
the search may not end (ValueError). Errors as those of ccw(), and for a negative radius.)");
}

}  // namespace signum::python
