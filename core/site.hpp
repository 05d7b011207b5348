#pragma once
/// Points and sites: the input of every predicate and algorithm. Coordinates are IEEE doubles and
/// are taken as exact numbers; nothing is rounded on the way in.

namespace signum {

/// A point of the plane.
struct Point {
    double x = 0.0;  ///< the first coordinate
    double y = 0.0;  ///< the second
    friend bool operator==(const Point&, const Point&) = default;
};

/// A point of space.
struct Point3 {
    double x = 0.0;  ///< the first coordinate
    double y = 0.0;  ///< the second
    double z = 0.0;  ///< the third
    friend bool operator==(const Point3&, const Point3&) = default;
};

/// A disc (square, diamond) with centre (x, y) and radius r; r may be negative. In the power metric
/// the weight of the site is r², the exact product.
struct Site {
    double x = 0.0;  ///< the first coordinate of the centre
    double y = 0.0;  ///< the second
    double r = 0.0;  ///< the radius
    friend bool operator==(const Site&, const Site&) = default;
};

/// The same in space: a ball (cube, octahedron) with centre (x, y, z).
struct Site3 {
    double x = 0.0;  ///< the first coordinate of the centre
    double y = 0.0;  ///< the second
    double z = 0.0;  ///< the third
    double r = 0.0;  ///< the radius
    friend bool operator==(const Site3&, const Site3&) = default;
};

namespace power {

/// A site of the power metric that carries its weight w itself: distance |p-c|² - w.
struct Site {
    double x = 0.0;  ///< the first coordinate of the centre
    double y = 0.0;  ///< the second
    double w = 0.0;  ///< the weight
    friend bool operator==(const Site&, const Site&) = default;
};

/// The same in space.
struct Site3 {
    double x = 0.0;  ///< the first coordinate of the centre
    double y = 0.0;  ///< the second
    double z = 0.0;  ///< the third
    double w = 0.0;  ///< the weight
    friend bool operator==(const Site3&, const Site3&) = default;
};

}  // namespace power

/// Whether all numbers of points and sites are finite: what predicates take for granted, and ask
/// in debug builds.
template <class... S>
[[nodiscard]] constexpr bool are_finite(const S&... sites) noexcept {
    const auto is_finite = [](double number) { return number - number == 0.0; };
    const auto is_one = [&](const auto& site) {
        bool others = true;
        if constexpr (requires { site.z; }) others &= is_finite(site.z);
        if constexpr (requires { site.r; }) others &= is_finite(site.r);
        if constexpr (requires { site.w; }) others &= is_finite(site.w);
        return others && is_finite(site.x) && is_finite(site.y);
    };
    return (is_one(sites) && ...);
}

}  // namespace signum
