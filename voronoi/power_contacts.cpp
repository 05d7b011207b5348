/// Contacts in the power metric. Lifted to a paraboloid the sites have a lower hull, whose faces
/// the tessellation divides into triangles; two sites may share an edge where they lie on one face
/// of it, hidden or not, and not above each other.

#include <algorithm>

#include "../predicates/power.hpp"
#include "of_metric.hpp"

namespace signum {
namespace {

template <power::PowerSite S>
class PowerContacts {
 public:
    explicit PowerContacts(const Canonical& canonical) : canonical_(canonical) {}

    bool operator()(Index i, Index j) const {
        if (same_centre(i, j)) return false;
        const bool i_hidden = canonical_.hidden_by(i) >= 0;
        const bool j_hidden = canonical_.hidden_by(j) >= 0;
        if (i_hidden && j_hidden) return both_hidden(i, j);
        const Index at = i_hidden ? j : j_hidden ? i : canonical_.lesser(i, j);
        const Index other = at == i ? j : i;
        return canonical_.any_face_at(at, [&](const Face& f) { return touches(f, other); });
    }

 private:
    [[nodiscard]] S site(Index i) const {
        const Site& s = canonical_.site(i);
        return {s.x, s.y, s.r};
    }
    [[nodiscard]] Point centre(Index i) const { return power::centre(canonical_.site(i)); }
    [[nodiscard]] bool same_centre(Index i, Index j) const { return centre(i) == centre(j); }

    /// Whether q lies in the plane of the face, of an infinite one on the line of its hull edge.
    [[nodiscard]] bool touches(const Face& face, Index q) const {
        if (std::find(face.begin(), face.end(), q) != face.end()) return true;
        if (face[0] == infinite)
            return power::in_circle_infinite(site(face[2]), site(face[1]), site(q)) == 0;
        return power::in_circle(site(face[0]), site(face[1]), site(face[2]), site(q)) == 0;
    }

    /// A hidden i that lies on the hull lies on the face below it, on the one across where it is on
    /// an edge, and on all faces at a site of the same place and weight.
    [[nodiscard]] bool both_hidden(Index i, Index j) const {
        const Index below = canonical_.tessellation().locate(centre(i));
        if (below < 0) return false;
        const auto touches_both = [&](const Face& f) { return touches(f, i) && touches(f, j); };
        for (const Index v : canonical_.face(below))
            if (v != infinite && same_centre(i, v))
                return power::nearer(centre(i), site(i), site(v)) == 0 &&
                       canonical_.any_face_at(v, [&](const Face& f) { return touches(f, j); });
        const Face& across =
            canonical_.tessellation().neighbours()[static_cast<std::size_t>(below)];
        return touches_both(canonical_.face(below)) ||
               std::any_of(across.begin(), across.end(),
                           [&](Index f) { return touches_both(canonical_.face(f)); });
    }

    const Canonical& canonical_;
};

}  // namespace

template <>
Contacts contacts_in<Power>(const Canonical& canonical) {
    if (canonical.tessellation().weight_is() == WeightIs::weight)
        return in_any_environment(PowerContacts<power::Site>(canonical));
    return in_any_environment(PowerContacts<Site>(canonical));
}

}  // namespace signum
