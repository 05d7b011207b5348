/// Contacts in the Euclidean metric. The cell of a visible site has an inside; that of a disc that
/// touches its container from inside, which the tie rule hides, is a stretch of a ray away from the
/// container's centre. The ray and where it leaves the container's cell are rational.

#include <algorithm>
#include <optional>

#include "../exact/multiprecision.hpp"
#include "../predicates/euclidean.hpp"
#include "of_metric.hpp"

namespace signum {
namespace {

using exact::Rational;

struct Disc {
    Rational x;
    Rational y;
    Rational r;

    explicit Disc(const Site& s)
        : x(exact::to_rational(s.x)), y(exact::to_rational(s.y)), r(exact::to_rational(s.r)) {}
};

/// Positive where neither hides the other, 0 where one touches the other from inside.
Rational power_of(const Disc& a, const Disc& b) {
    const Rational x = a.x - b.x;
    const Rational y = a.y - b.y;
    const Rational r = a.r - b.r;
    return x * x + y * y - r * r;
}

/// The ray on which a disc that touches its container from inside is as near as that one: from the
/// disc's centre away from the container's. A point of it has the container's centre at distance s.
class Ray {
 public:
    Ray(const Disc& container, const Disc& disc)
        : from_(container),
          start_(container.r - disc.r),
          x_((disc.x - container.x) / start_),
          y_((disc.y - container.y) / start_) {}

    /// How much farther m reaches in the ray's direction.
    [[nodiscard]] Rational excess(const Disc& m) const {
        return x_ * (m.x - from_.x) + y_ * (m.y - from_.y) + (m.r - from_.r);
    }
    /// Where m is as near as the container; nothing where that is nowhere on the line.
    [[nodiscard]] std::optional<Rational> meets(const Disc& m) const {
        const Rational reach = excess(m);
        if (reach <= 0) return std::nullopt;
        Rational s = power_of(from_, m) / (2 * reach);
        if (s < start_) return std::nullopt;
        return s;
    }
    /// Whether m is nearer than the container at s (-1), as near (0), or farther (+1).
    [[nodiscard]] Sign compare(const Rational& s, const Disc& m) const {
        const Rational radius = s - from_.r + m.r;
        if (radius < 0) return 1;
        const Rational x = from_.x + s * x_ - m.x;
        const Rational y = from_.y + s * y_ - m.y;
        return Rational(x * x + y * y - radius * radius).sign();
    }

 private:
    Disc from_;
    Rational start_;
    Rational x_;
    Rational y_;
};

class EuclideanContacts {
 public:
    explicit EuclideanContacts(const Canonical& canonical) : canonical_(canonical) {}

    bool operator()(Index i, Index j) const {
        i = first_of_equals(i);
        j = first_of_equals(j);
        if (canonical_.site(i) == canonical_.site(j)) return false;
        const bool i_hidden = canonical_.hidden_by(i) >= 0;
        const bool j_hidden = canonical_.hidden_by(j) >= 0;
        if (!i_hidden && !j_hidden) {
            const Index at = canonical_.lesser(i, j);
            const Index other = at == i ? j : i;
            return canonical_.any_face_at(at, [&](const Face& f) { return touches(f, other); });
        }
        return touches_hider(i) && touches_hider(j) && (j_hidden ? meet(j, i) : meet(i, j));
    }

 private:
    /// The visible site of the same place and size, where there is one.
    [[nodiscard]] Index first_of_equals(Index i) const {
        const Index by = canonical_.shown_for(i);
        return canonical_.site(by) == canonical_.site(i) ? by : i;
    }

    /// Whether nothing but a tie hides i.
    [[nodiscard]] bool touches_hider(Index i) const {
        const Index by = canonical_.hidden_by(i);
        return by < 0 || power_of(Disc(canonical_.site(by)), Disc(canonical_.site(i))) == 0;
    }

    /// Whether a visible q touches the circle of the face, of an infinite one the line.
    [[nodiscard]] bool touches(const Face& face, Index q_index) const {
        if (std::find(face.begin(), face.end(), q_index) != face.end()) return true;
        const Site& q = canonical_.site(q_index);
        const Site& j = canonical_.site(face[1]);
        const Site& k = canonical_.site(face[2]);
        if (face[0] == infinite) return euclidean::in_circle_infinite(k, j, q) == 0;
        const Site& i = canonical_.site(face[0]);
        const auto ranks =
            additive::ranks_of<4>({&i, &j, &k, &q}, {face[0], face[1], face[2], q_index});
        return euclidean::in_circle_decision(i, j, k, q, ranks).sign == 0;
    }

    /// Whether the stretch of the hidden disc j and the cell of i, which may be one, too, meet.
    [[nodiscard]] bool meet(Index j, Index i) const {
        const Disc disc(canonical_.site(j));
        const Disc other(canonical_.site(i));
        if (power_of(other, disc) == 0) return true;  // at the centre of the smaller
        const Index container = canonical_.hidden_by(j);
        const Index rival = canonical_.shown_for(i);
        if (rival == container) return false;  // rays of different directions
        const Ray ray(Disc(canonical_.site(container)), disc);
        const Disc rival_disc(canonical_.site(rival));
        const auto around = canonical_.tessellation().neighbours(container);
        const auto none_nearer = [&](auto nearer) {
            return std::none_of(around.begin(), around.end(), [&](Index k) {
                return k != infinite && nearer(Disc(canonical_.site(k)));
            });
        };
        if (ray.excess(rival_disc) == 0 && ray.excess(other) == 0)  // a line touches all of them
            return none_nearer([&](const Disc& k) { return ray.excess(k) > 0; });
        const auto s = ray.meets(rival_disc);
        return s && ray.compare(*s, rival_disc) == 0 && ray.compare(*s, other) == 0 &&
               none_nearer([&](const Disc& k) { return ray.compare(*s, k) < 0; });
    }

    const Canonical& canonical_;
};

}  // namespace

template <>
Contacts contacts_in<Euclidean>(const Canonical& canonical) {
    return in_any_environment(EuclideanContacts(canonical));
}

}  // namespace signum
