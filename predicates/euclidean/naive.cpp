#include <signum/predicates/euclidean/naive.hpp>

#include <signum/predicates/euclidean/filter.hpp>

namespace signum::euclidean::naive {

using filter::Difference;
using filter::Triple;

bool hides(const Site& i, const Site& q) noexcept {
    return q.r <= i.r && Difference(q, i).p <= 0.0;
}

Sign nearer(Point p, const Site& a, const Site& b) noexcept {
    const auto distance = [&p](const Site& s) {
        const double x = p.x - s.x;
        const double y = p.y - s.y;
        return __builtin_sqrt(x * x + y * y) - s.r;
    };
    return sign_of(distance(b) - distance(a));
}

Sign edge_bounded(const Site& i, const Site& j, const Site& k) noexcept {
    return sign_of(Triple(i, j, k).q);
}

bool exists(const Site& i, const Site& j, const Site& k) noexcept {
    const Triple t(i, j, k);
    if (!(t.j.p > 0.0 && t.k.p > 0.0 && t.jk.p > 0.0)) return false;
    const bool left = t.xy > 0.0;
    const bool positive = t.xp() * t.xr + t.yp() * t.yr > 0.0;
    if (t.q == 0.0) return left && positive;
    return t.q < 0.0 ? left : positive;
}

Sign in_circle(const Site& i, const Site& j, const Site& k, const Site& q) noexcept {
    if (hides(i, q) || hides(j, q) || hides(k, q)) return -1;
    const Triple t(i, j, k);
    const Difference c(q, i);
    const double root = __builtin_sqrt(t.j.p * t.k.p * t.jk.p);
    const double along_x = t.xy * t.yp() - t.xr * t.rp() - t.yr * root;
    const double along_y = t.xy * t.xp() + t.yr * t.rp() - t.xr * root;
    const double radius = t.xp() * t.xr + t.yp() * t.yr - t.xy * root;
    return sign_of(t.q) * sign_of(c.x * along_x - c.y * along_y + c.r * radius - c.p * t.q);
}

Sign in_circle_infinite(const Site& a, const Site& b, const Site& q) noexcept {
    const Difference u(b, a);
    const Difference w(q, a);
    return sign_of(w.r * (u.x * u.x + u.y * u.y) - u.r * (u.x * w.x + u.y * w.y) -
                   __builtin_sqrt(u.p) * (u.x * w.y - u.y * w.x));
}

}  // namespace signum::euclidean::naive
