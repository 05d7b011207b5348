#pragma once
/// CGAL's points and signs as ours, and ours as CGAL's.

#include <signum/core/site.hpp>
#include <signum/predicates/ccw.hpp>
#include <signum/predicates/space.hpp>

namespace signum::cgal::details {

/// One of CGAL's points, plain or weighted, of the plane or of space, as one of ours.
template <class P>
[[nodiscard, gnu::always_inline]] inline auto ours(const P& p) noexcept {
    if constexpr (HasCentre<P> || HasCentre3<P>)
        return p;
    else if constexpr (requires {
                           p.weight();
                           p.z();
                       })
        return power::Site3{p.x(), p.y(), p.z(), p.weight()};
    else if constexpr (requires { p.weight(); })
        return power::Site{p.x(), p.y(), p.weight()};
    else if constexpr (requires { p.z(); })
        return Point3{p.x(), p.y(), p.z()};
    else
        return Point{p.x(), p.y()};
}

/// And the other way.
template <class P, class S>
[[nodiscard]] P theirs(const S& s) {
    if constexpr (requires {
                      s.w;
                      s.z;
                  })
        return P({s.x, s.y, s.z}, s.w);
    else if constexpr (requires { s.w; })
        return P({s.x, s.y}, s.w);
    else if constexpr (requires { s.z; })
        return P(s.x, s.y, s.z);
    else
        return P(s.x, s.y);
}

/// CGAL's signs are enumerators from -1 to 1, whatever they are called.
template <class CgalSign>
[[nodiscard]] inline CgalSign sign_cast(Sign sign) noexcept {
    return static_cast<CgalSign>(sign);
}

}  // namespace signum::cgal::details
