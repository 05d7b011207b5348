#include "kinetic.hpp"

#include "polynomial.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <utility>

namespace signum::oracle::kinetic {
namespace {

using Numbers = std::vector<std::int32_t>;

/// The coordinates are polynomials in time, or rationals at one time.
template <class Number>
struct Weighted {
    Number x, y;
    Rational weight;
};
using Moving = Weighted<Polynomial>;
using Fixed = Weighted<Rational>;

std::vector<Moving> exactly(std::span<const Site> sites, const Fall& g) {
    std::vector<Moving> result;
    for (const Site& site : sites) {
        const Polynomial passed{-oracle::exactly(site.t0), 1};
        const auto along = [&](double x, double v, double a) {
            return Polynomial{oracle::exactly(x)} + Polynomial{oracle::exactly(v)} * passed +
                   Polynomial{oracle::exactly(a) / 2} * passed * passed;
        };
        const Rational radius = oracle::exactly(site.r);
        result.push_back({along(site.x, site.vx, g[0]), along(site.y, site.vy, g[1]),
                          radius * radius + oracle::exactly(site.w)});
    }
    return result;
}

std::vector<Fixed> at(const std::vector<Moving>& sites, const Rational& t) {
    std::vector<Fixed> result;
    for (const Moving& site : sites) result.push_back({site.x(t), site.y(t), site.weight});
    return result;
}

template <class Number>
Number turn(const Weighted<Number>& a, const Weighted<Number>& b, const Weighted<Number>& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Rows (x, y, x² + y² - w) relative to q. Positive where q is in the power circle of a, b and c
/// and these are counterclockwise.
Polynomial circle(const Moving& a, const Moving& b, const Moving& c, const Moving& q) {
    std::array<Polynomial, 3> x{a.x - q.x, b.x - q.x, c.x - q.x};
    std::array<Polynomial, 3> y{a.y - q.y, b.y - q.y, c.y - q.y};
    const std::array<Rational, 3> w{a.weight - q.weight, b.weight - q.weight, c.weight - q.weight};
    Polynomial sum{};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        sum = sum + (x[i] * x[i] + y[i] * y[i] - Polynomial{w[i]}) * (x[j] * y[k] - x[k] * y[j]);
    }
    return sum;
}

/// The distance of two centres, squared.
Polynomial distance(const Moving& a, const Moving& b) {
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

/// A root: the only one of a polynomial, of which it is a simple root, in [low, high]. Neither end
/// is a root unless both are the root itself.
class Root {
 public:
    Root(Polynomial p, Rational low, Rational high)
        : p_(std::move(p)), low_(std::move(low)), high_(std::move(high)), below_(p_.sign(low_)) {}

    const Rational& low() const { return low_; }
    const Rational& high() const { return high_; }

    void halve() {
        if (low_ == high_) return;
        const Rational middle = (low_ + high_) / 2;
        const int sign = p_.sign(middle);
        if (sign * below_ >= 0) low_ = middle;
        if (sign * below_ <= 0) high_ = middle;
    }

    double nearest() const {
        return oracle::nearest([&](const Rational& x) {
            if (low_ == high_) return low_.compare(x);
            return x <= low_ ? 1 : x >= high_ ? -1 : below_ * p_.sign(x);
        });
    }

    bool may_equal(const Root& other) const { return low_ <= other.high_ && other.low_ <= high_; }
    bool equals(const Root& other) const {
        const Rational low = std::max(low_, other.low_), high = std::min(high_, other.high_);
        if (low > high) return false;
        const Polynomial common = gcd(p_, other.p_);  // with a root here: that of both
        if (common.size() < 2) return false;
        const Roots roots(common);
        return roots.is_root(low) || roots.beyond(low) > roots.beyond(high);
    }

 private:
    Polynomial p_;
    Rational low_, high_;
    int below_;
};

/// -1, 0 or 1 as a is before, at or after b. The two are told apart afterwards unless it is 0.
int compare(Root& a, Root& b) {
    for (int i = 0; i < 40 && a.may_equal(b); ++i) a.halve(), b.halve();
    if (a.may_equal(b) && a.equals(b)) return 0;
    while (a.may_equal(b)) a.halve(), b.halve();
    return a.high() < b.low() ? -1 : 1;
}

/// The roots in the open interval (low, high).
void isolate(const Roots& roots, const Rational& low, const Rational& high,
             std::vector<Root>& found) {
    const bool ends = roots.is_root(high);
    const int number = roots.beyond(low) - roots.beyond(high) - (ends ? 1 : 0);
    if (number == 0) return;
    if (number == 1 && !ends && !roots.is_root(low)) {
        found.emplace_back(roots.square_free(), low, high);
        return;
    }
    const Rational middle = (low + high) / 2;
    isolate(roots, low, middle, found);
    if (roots.is_root(middle)) found.emplace_back(roots.square_free(), middle, middle);
    isolate(roots, middle, high, found);
}

/// A rational with a small denominator between two.
Rational between(const Rational& low, const Rational& high) {
    for (Rational scale = 1;; scale *= 2) {
        const Rational next = (floor(low * scale) + 1) / scale;
        if (next < high) return next;
    }
}

struct Certified {
    Numbers sites;
    Polynomial p;
};

std::vector<Certified> certificates(const std::vector<Moving>& s) {
    std::vector<Certified> pairs, triples, fours;
    const auto number = [](std::size_t i) { return static_cast<std::int32_t>(i); };
    for (std::size_t a = 0; a < s.size(); ++a)
        for (std::size_t b = a + 1; b < s.size(); ++b) {
            pairs.push_back({{number(a), number(b)}, distance(s[a], s[b])});
            for (std::size_t c = b + 1; c < s.size(); ++c) {
                triples.push_back({{number(a), number(b), number(c)}, turn(s[a], s[b], s[c])});
                for (std::size_t d = c + 1; d < s.size(); ++d)
                    fours.push_back({{number(a), number(b), number(c), number(d)},
                                     circle(s[a], s[b], s[c], s[d])});
            }
        }
    pairs.insert(pairs.end(), triples.begin(), triples.end());
    pairs.insert(pairs.end(), fours.begin(), fours.end());
    return pairs;
}

/// A time and which certificates are 0 then.
struct Candidate {
    Root root;
    std::vector<std::size_t> which;
};

void insert(std::vector<Candidate>& candidates, Root root, std::size_t which) {
    std::size_t first = 0, last = candidates.size();
    while (first < last) {
        const std::size_t middle = first + (last - first) / 2;
        const int order = compare(root, candidates[middle].root);
        if (order == 0) {
            candidates[middle].which.push_back(which);
            return;
        }
        (order < 0 ? last : first) = order < 0 ? middle : middle + 1;
    }
    candidates.insert(candidates.begin() + static_cast<std::ptrdiff_t>(first),
                      Candidate{std::move(root), {which}});
}

/// Its smallest number first; the order round it stays.
Triangle rotated(Triangle t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
}

/// The power distance of a point from a site.
Rational distance(const Rational& x, const Rational& y, const Fixed& site) {
    return (x - site.x) * (x - site.x) + (y - site.y) * (y - site.y) - site.weight;
}

void add_triangle(const std::vector<Fixed>& s, std::size_t a, std::size_t b, std::size_t c,
                  Snapshot& faces) {
    const Rational area = turn(s[a], s[b], s[c]);
    if (area.is_zero()) return;
    // The centre (x, y), relative to a, has the same power distance from all three:
    // 2 (p - a)·(x, y) = |p - a|² - w_p + w_a for p = b and p = c.
    const Rational bx = s[b].x - s[a].x, by = s[b].y - s[a].y;
    const Rational cx = s[c].x - s[a].x, cy = s[c].y - s[a].y;
    const Rational eb = (bx * bx + by * by - s[b].weight + s[a].weight) / 2;
    const Rational ec = (cx * cx + cy * cy - s[c].weight + s[a].weight) / 2;
    const Rational x = s[a].x + (eb * cy - ec * by) / area;
    const Rational y = s[a].y + (bx * ec - cx * eb) / area;
    const Rational radius = distance(x, y, s[a]);

    const auto number = [](std::size_t i) { return static_cast<std::int32_t>(i); };
    std::vector<std::int32_t> touching;
    for (std::size_t q = 0; q < s.size(); ++q) {
        if (q == a || q == b || q == c) continue;
        const int sign = distance(x, y, s[q]).compare(radius);
        if (sign < 0) return;
        if (sign == 0) touching.push_back(number(q));
    }
    if (touching.empty())
        faces.triangles.push_back(rotated(area > 0 ? Triangle{number(a), number(b), number(c)}
                                                   : Triangle{number(a), number(c), number(b)}));
    for (const std::int32_t q : touching) {
        std::array<std::int32_t, 4> four{number(a), number(b), number(c), q};
        std::sort(four.begin(), four.end());
        faces.circles.push_back(four);
    }
}

/// Whether a and two more are on a line beyond which, on one side, there is no centre.
bool is_on_side(const std::vector<Fixed>& s, std::size_t a, std::size_t b, std::size_t c) {
    if (turn(s[a], s[b], s[c]) != 0) return false;
    // Two different centres that give the line; three equal ones are on every line.
    const auto same = [&](std::size_t i, std::size_t j) {
        return s[i].x == s[j].x && s[i].y == s[j].y;
    };
    std::vector<std::pair<std::size_t, std::size_t>> lines;
    if (!same(a, b))
        lines.emplace_back(a, b);
    else if (!same(a, c))
        lines.emplace_back(a, c);
    else
        for (std::size_t q = 0; q < s.size(); ++q)
            if (!same(a, q)) lines.emplace_back(a, q);
    if (lines.empty()) return true;  // all in one place
    for (const auto& [from, to] : lines) {
        bool left = false, right = false;
        for (const Fixed& q : s) {
            const int side = turn(s[from], s[to], q).sign();
            if (side > 0) left = true;
            if (side < 0) right = true;
        }
        if (!left || !right) return true;
    }
    return false;
}

Snapshot faces_of(const std::vector<Fixed>& s) {
    Snapshot faces;
    for (std::size_t a = 0; a < s.size(); ++a)
        for (std::size_t b = a + 1; b < s.size(); ++b)
            for (std::size_t c = b + 1; c < s.size(); ++c) {
                add_triangle(s, a, b, c, faces);
                if (is_on_side(s, a, b, c))
                    faces.lines.push_back({static_cast<std::int32_t>(a),
                                           static_cast<std::int32_t>(b),
                                           static_cast<std::int32_t>(c)});
            }
    std::sort(faces.triangles.begin(), faces.triangles.end());
    std::sort(faces.circles.begin(), faces.circles.end());
    faces.circles.erase(std::unique(faces.circles.begin(), faces.circles.end()),
                        faces.circles.end());
    return faces;
}

}  // namespace

Candidates events(std::span<const Site> sites, const Rational& begin, const Rational& end,
                  const Fall& g) {
    if (begin >= end) throw std::invalid_argument("oracle: no time between begin and end");
    const std::vector<Certified> all = certificates(exactly(sites, g));
    Candidates result;
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].p.is_zero()) {
            result.always.push_back(all[i].sites);
            continue;
        }
        std::vector<Root> roots;
        isolate(Roots(all[i].p), begin, end, roots);
        for (Root& root : roots) insert(candidates, std::move(root), i);
    }

    const Rational width = (end - begin) * oracle::exactly(0x1p-60);
    for (Candidate& candidate : candidates)
        while (candidate.root.low() <= begin || candidate.root.high() >= end ||
               candidate.root.high() - candidate.root.low() > width)
            candidate.root.halve();
    for (std::size_t i = 0; i + 1 < candidates.size(); ++i)
        while (candidates[i].root.may_equal(candidates[i + 1].root))
            candidates[i].root.halve(), candidates[i + 1].root.halve();
    Rational since = begin;
    for (const Candidate& candidate : candidates) {
        result.between.push_back(between(since, candidate.root.low()));
        since = candidate.root.high();
    }
    result.between.push_back(between(since, end));

    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const Candidate& candidate = candidates[i];
        Event event{candidate.root.low(), candidate.root.high(), candidate.root.nearest(), {}};
        for (const std::size_t which : candidate.which)
            event.certificates.push_back({all[which].sites, all[which].p.sign(result.between[i]),
                                          all[which].p.sign(result.between[i + 1])});
        result.events.push_back(std::move(event));
    }
    return result;
}

Snapshot faces_at(std::span<const Site> sites, const Rational& t, const Fall& g) {
    return faces_of(at(exactly(sites, g), t));
}

Epochs epochs(std::span<const Site> sites, const Rational& begin, const Rational& end,
              const Fall& g) {
    const Candidates candidates = events(sites, begin, end, g);
    const std::vector<Moving> moving = exactly(sites, g);
    std::vector<Triangles> triangles;
    std::set<std::array<std::int32_t, 4>> tied;
    for (const Rational& t : candidates.between) {
        Snapshot faces = faces_of(at(moving, t));
        for (const auto& four : faces.circles) {
            const Numbers numbers(four.begin(), four.end());
            if (std::find(candidates.always.begin(), candidates.always.end(), numbers) ==
                candidates.always.end())
                throw std::logic_error("oracle: a tie between two events");
            tied.insert(four);
        }
        triangles.push_back(std::move(faces.triangles));
    }

    Epochs result;
    result.tied.assign(tied.begin(), tied.end());
    if (!tied.empty()) return result;
    result.first = triangles.front();
    for (std::size_t i = 0; i < candidates.events.size(); ++i)
        if (triangles[i] != triangles[i + 1])
            result.changes.push_back({candidates.events[i],
                                      candidates.events[i].certificates.size() > 1, triangles[i],
                                      triangles[i + 1]});
    return result;
}

}  // namespace signum::oracle::kinetic
