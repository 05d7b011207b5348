#include "power.hpp"

#include "linear_form.hpp"
#include "sphere.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace signum::oracle {
namespace {

struct Weighted {
    Rational x;
    Rational y;
    Rational weight;
};

/// The sites as points of space: (x, y, x² + y² - w + e), e the infinitesimal by which the weight
/// is reduced. Their lower hull is the tessellation. Centres are never perturbed, so heights enter
/// every determinant below linearly.
class Lifting {
 public:
    Lifting(const std::vector<Weighted>& sites, const Ranks& ranks) : sites_(sites) {
        std::vector<TieKey> keys;
        for (const Weighted& site : sites) keys.push_back({site.weight, site.x, site.y});
        ranks_ = ranks.empty() ? tie_ranks(keys) : ranks;
        for (std::size_t i = 0; i < size(); ++i) {
            const Weighted& p = sites[i];
            height_.push_back(LinearForm(p.x * p.x + p.y * p.y - p.weight) +
                              LinearForm::infinitesimal(ranks_[i]));
        }
        for (std::size_t a = 0; a < size(); ++a)
            for (std::size_t b = 0; b < size(); ++b)
                for (std::size_t c = 0; c < size(); ++c) turn_.push_back(turn(a, b, c));
    }

    std::size_t size() const { return sites_.size(); }

    /// Three sites are a face when the plane through them has every other site above it.
    bool is_face(std::size_t a, std::size_t b, std::size_t c) const {
        if (ccw(a, b, c).sign() <= 0) return false;
        for (std::size_t q = 0; q < size(); ++q)
            if (q != a && q != b && q != c && !is_above_plane(a, b, c, q)) return false;
        return true;
    }

    /// a -> b bounds the hull when every other site is on its left, or on the same line and above
    /// the line through a and b in the vertical plane that holds them.
    bool is_hull_edge(std::size_t a, std::size_t b) const {
        if (same_centre(a, b)) return false;
        for (std::size_t q = 0; q < size(); ++q) {
            if (q == a || q == b) continue;
            const int side = ccw(a, b, q).sign();
            if (side < 0 || (side == 0 && !is_above_line(a, b, q))) return false;
        }
        return true;
    }

    /// The cell of q is empty when some point, segment or triangle of other sites passes below q.
    bool is_covered(std::size_t q) const {
        for (std::size_t a = 0; a < size(); ++a) {
            if (a == q) continue;
            if (same_centre(a, q) && less(height_[a], height_[q])) return true;
            for (std::size_t b = 0; b < size(); ++b) {
                if (b == q || b == a) continue;
                if (!same_centre(a, b) && ccw(a, b, q).is_zero()) {
                    const Rational along = dot(a, b, q);
                    if (along >= 0 && along <= dot(a, b, b) && is_above_line(a, b, q)) return true;
                }
                for (std::size_t c = 0; c < size(); ++c) {
                    if (c == q || c == a || c == b || ccw(a, b, c).sign() <= 0) continue;
                    if (ccw(a, b, q).sign() >= 0 && ccw(b, c, q).sign() >= 0 &&
                        ccw(c, a, q).sign() >= 0 && is_above_plane(a, b, c, q))
                        return true;
                }
            }
        }
        return false;
    }

    /// The power distance from the centre of q to a site with its reduced weight.
    LinearForm distance(std::size_t q, std::size_t site) const {
        const Rational x = sites_[q].x - sites_[site].x;
        const Rational y = sites_[q].y - sites_[site].y;
        return LinearForm(x * x + y * y - sites_[site].weight) +
               LinearForm::infinitesimal(ranks_[site]);
    }

 private:
    Rational turn(std::size_t a, std::size_t b, std::size_t c) const {
        const Weighted &p = sites_[a], &q = sites_[b], &r = sites_[c];
        return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    }
    const Rational& ccw(std::size_t a, std::size_t b, std::size_t c) const {
        return turn_[(a * size() + b) * size() + c];
    }
    bool same_centre(std::size_t a, std::size_t b) const {
        return sites_[a].x == sites_[b].x && sites_[a].y == sites_[b].y;
    }
    /// (q - a)·(b - a)
    Rational dot(std::size_t a, std::size_t b, std::size_t q) const {
        return (sites_[q].x - sites_[a].x) * (sites_[b].x - sites_[a].x) +
               (sites_[q].y - sites_[a].y) * (sites_[b].y - sites_[a].y);
    }

    /// Barycentric coordinates of the centre of q weigh the heights of a, b and c. (ccw(a,b,c) > 0)
    bool is_above_plane(std::size_t a, std::size_t b, std::size_t c, std::size_t q) const {
        return less(
            height_[a] * ccw(q, b, c) + height_[b] * ccw(a, q, c) + height_[c] * ccw(a, b, q),
            height_[q] * ccw(a, b, c));
    }
    /// The same for q on the line through the different centres of a and b.
    bool is_above_line(std::size_t a, std::size_t b, std::size_t q) const {
        const Rational whole = dot(a, b, b);
        const Rational part = dot(a, b, q);
        return less(height_[a] * (whole - part) + height_[b] * part, height_[q] * whole);
    }

    std::vector<Weighted> sites_;
    std::vector<std::size_t> ranks_;
    std::vector<LinearForm> height_;
    std::vector<Rational> turn_;
};

Tessellation tessellate(const std::vector<Weighted>& sites, const Ranks& ranks) {
    const Lifting lifting(sites, ranks);
    const auto number = [](std::size_t i) { return static_cast<std::int32_t>(i); };
    Tessellation result;
    std::vector<bool> visible;
    for (std::size_t q = 0; q < sites.size(); ++q) visible.push_back(!lifting.is_covered(q));

    for (std::size_t a = 0; a < sites.size(); ++a) {
        for (std::size_t b = 0; b < sites.size(); ++b) {
            if (a == b) continue;
            if (lifting.is_hull_edge(a, b))
                result.faces.push_back(canonical({number(b), number(a), at_infinity}));
            for (std::size_t c = 0; c < sites.size(); ++c)  // the smallest first: each face once
                if (a < b && a < c && b != c && lifting.is_face(a, b, c))
                    result.faces.push_back({number(a), number(b), number(c)});
        }
    }
    std::sort(result.faces.begin(), result.faces.end());

    for (std::size_t q = 0; q < sites.size(); ++q) {
        if (visible[q]) continue;
        std::size_t by = sites.size();
        for (std::size_t i = 0; i < sites.size(); ++i)
            if (visible[i] &&
                (by == sites.size() || less(lifting.distance(q, i), lifting.distance(q, by))))
                by = i;
        result.hidden.push_back({number(q), number(by)});
    }
    check_sphere(result, visible);
    return result;
}

}  // namespace

Tessellation power(std::span<const signum::Site> sites, const Ranks& ranks) {
    std::vector<Weighted> exact;
    for (const signum::Site& site : sites) {
        const Rational radius = exactly(site.r);
        exact.push_back({exactly(site.x), exactly(site.y), radius * radius});
    }
    return tessellate(exact, ranks);
}

Tessellation power_weights(std::span<const signum::power::Site> sites, const Ranks& ranks) {
    std::vector<Weighted> exact;
    for (const signum::power::Site& site : sites)
        exact.push_back({exactly(site.x), exactly(site.y), exactly(site.w)});
    return tessellate(exact, ranks);
}

}  // namespace signum::oracle
