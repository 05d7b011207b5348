#include "euclidean.hpp"

#include "sphere.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

namespace signum::oracle {
namespace {

struct Disc {
    Enclosure x, y, r;
};

struct Vector {
    Enclosure x, y, r;
};

Vector operator-(const Disc& a, const Disc& b) {
    return {a.x - b.x, a.y - b.y, a.r - b.r};
}

Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.r - a.r * b.y, a.r * b.x - a.x * b.r, a.x * b.y - a.y * b.x};
}

/// x·x' + y·y' - r·r': |p-c| = R + r says that (p-c, R+r) has product 0 with itself.
Enclosure product(const Vector& a, const Vector& b) {
    return a.x * b.x + a.y * b.y - a.r * b.r;
}

/// The touching circle's centre, relative to the centre of the first disc, and its distance from
/// there.
struct Circle {
    Enclosure x, y, reach;
};

/// The circles that touch i, j, k counterclockwise. With v = c_m - c_i and s = r_m - r_i the centre
/// X obeys |X| = R, |X - v| = R + s; subtracting squares, 2 X·v + 2 R s = |v|² - s² for m = j, k.
/// These two planes meet in a line of the space (X, R), and the cone |X|² = R² cuts it twice. Which
/// of the cuts are circles, and how they touch, is then looked at.
std::vector<Circle> circles(const Disc& i, const Disc& j, const Disc& k) {
    const Vector vj = j - i;
    const Vector vk = k - i;
    const Enclosure pj = product(vj, vj) / 2;
    const Enclosure pk = product(vk, vk) / 2;
    const Vector along = cross(vj, vk);
    const Enclosure square = along.x * along.x + along.y * along.y + along.r * along.r;
    // The point of the line nearest to the origin.
    const Vector to_j = cross(vk, along);
    const Vector to_k = cross(along, vj);
    const Vector foot{(pj * to_j.x + pk * to_k.x) / square, (pj * to_j.y + pk * to_k.y) / square,
                      (pj * to_j.r + pk * to_k.r) / square};
    // product(foot + t·along, foot + t·along) = a t² + 2 b t + c = 0
    const Enclosure a = product(along, along);
    const Enclosure b = product(foot, along);
    const Enclosure c = product(foot, foot);
    const Enclosure discriminant = b * b - a * c;
    std::vector<Circle> found;
    if (discriminant.sign() < 0) return found;
    const Enclosure root = sqrt(discriminant);
    for (const Enclosure& t : {(root - b) / a, (-root - b) / a}) {
        const Circle circle{foot.x + t * along.x, foot.y + t * along.y, foot.r + t * along.r};
        // Distances of the centre from those of i, j, k; all must be positive to be distances.
        const Enclosure& di = circle.reach;
        const Enclosure dj = circle.reach + vj.r;
        const Enclosure dk = circle.reach + vk.r;
        if (di.sign() < 0 || dj.sign() < 0 || dk.sign() < 0) continue;
        // The touching points lie in the directions (c_m - X) / d_m, unit vectors; the orientation
        // of these three is the determinant of the rows (c_m - X, d_m) over the positive di·dj·dk.
        const Enclosure jx = vj.x - circle.x;
        const Enclosure jy = vj.y - circle.y;
        const Enclosure kx = vk.x - circle.x;
        const Enclosure ky = vk.y - circle.y;
        const Enclosure orientation = di * (jx * ky - jy * kx) - circle.x * (jy * dk - dj * ky) -
                                      circle.y * (dj * kx - jx * dk);
        if (orientation.sign() > 0) found.push_back(circle);
    }
    return found;
}

/// The integer and the power of two whose product a double is.
std::pair<Integer, int> split(double value) {
    if (value == 0.0) return {0, 0};
    int exponent = 0;
    auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
    exponent -= 53;
    while (mantissa % 2 == 0) {
        mantissa /= 2;
        ++exponent;
    }
    return {Integer{mantissa}, exponent};
}

/// Infinitesimals as spaced, sites' numbers as given.
Tessellation tessellate(const ShrunkenDiscs& discs) {
    const std::int32_t n = discs.size();
    std::vector<std::int32_t> visible;
    std::vector<std::int32_t> hidden;
    for (std::int32_t q = 0; q < n; ++q) {
        bool covered = false;
        for (std::int32_t i = 0; i < n; ++i) covered = covered || (i != q && discs.hides(i, q));
        (covered ? hidden : visible).push_back(q);
    }

    Tessellation result;
    for (const std::int32_t q : hidden) {
        std::int32_t by = visible.front();
        for (const std::int32_t i : visible) {
            if (i != by && discs.nearer(i, by, q)) by = i;
        }
        result.hidden.push_back({q, by});
    }

    const auto none = [&](std::initializer_list<std::int32_t> touching, auto&& conflicts) {
        return std::none_of(visible.begin(), visible.end(), [&](std::int32_t q) {
            return std::find(touching.begin(), touching.end(), q) == touching.end() && conflicts(q);
        });
    };
    for (const std::int32_t i : visible) {
        for (const std::int32_t j : visible) {
            if (j == i) continue;
            if (none({i, j}, [&](std::int32_t q) { return discs.crosses(i, j, q); })) {
                result.faces.push_back({-1, j, i});
            }
            for (const std::int32_t k : visible) {
                if (j < i || k <= i || k == j || !discs.exists(i, j, k)) continue;
                if (none({i, j, k}, [&](std::int32_t q) { return discs.conflicts(i, j, k, q); })) {
                    result.faces.push_back({i, j, k});
                }
            }
        }
    }
    std::sort(result.faces.begin(), result.faces.end());
    return result;
}

std::string text(const Tessellation& tessellation) {
    std::string result = "faces";
    for (const auto& [a, b, c] : tessellation.faces) {
        result +=
            " (" + std::to_string(a) + "," + std::to_string(b) + "," + std::to_string(c) + ")";
    }
    result += " hidden";
    for (const auto& [site, by] : tessellation.hidden) {
        result += " " + std::to_string(site) + "<" + std::to_string(by);
    }
    return result;
}

void check(const Tessellation& tessellation, std::size_t sites) {
    std::vector<bool> visible(sites, true);
    for (const auto& [site, by] : tessellation.hidden)
        visible[static_cast<std::size_t>(site)] = false;
    check_sphere(tessellation, visible);
}

}  // namespace

ShrunkenDiscs::ShrunkenDiscs(std::span<const Site> sites, Spacing spacing, int fineness)
    : spacing_(spacing) {
    int lowest = 2000;
    for (const Site& site : sites) {
        for (const double value : {site.x, site.y, site.r}) {
            if (!std::isfinite(value)) {
                throw std::invalid_argument("euclidean oracle: a number is not finite");
            }
            if (value != 0.0) lowest = std::min(lowest, split(value).second);
        }
    }
    const auto on_grid = [&](double value) -> Integer {
        const auto [mantissa, exponent] = split(value);
        return mantissa == 0 ? mantissa : Integer{mantissa << (exponent - lowest)};
    };
    std::int64_t length = 1;
    for (const Site& site : sites) {
        discs_.push_back({on_grid(site.x), on_grid(site.y), on_grid(site.r), 0});
        for (const Integer& value : {discs_.back().x, discs_.back().y, discs_.back().r}) {
            if (value != 0) {
                length = std::max(length, static_cast<std::int64_t>(msb(abs(value))) + 1);
            }
        }
    }
    scale_ = fineness * (32 * length + 64);
    start_ = 64 + 8 * length;

    std::vector<std::size_t> order(discs_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const Grid& p = discs_[a];
        const Grid& q = discs_[b];
        return std::tie(q.r, p.x, p.y, a) < std::tie(p.r, q.x, q.y, b);
    });
    for (std::size_t rank = 0; rank < order.size(); ++rank) {
        discs_[order[rank]].rank = static_cast<std::int32_t>(rank);
    }
}

ShrunkenDiscs::ShrunkenDiscs(std::span<const Site> sites, std::vector<std::int64_t> powers)
    : ShrunkenDiscs(sites, Spacing::steps) {
    powers_ = std::move(powers);
}

/// Gives the question the shrunken discs it names, again and again with more precision, until its
/// answer is certain.
template <class Question>
auto ShrunkenDiscs::ask(std::initializer_list<std::int32_t> names, Question question) const {
    constexpr std::int64_t limit = std::int64_t{1} << 22;
    for (Enclosure::precision = start_; Enclosure::precision < limit; Enclosure::precision *= 2) {
        std::array<Disc, 4> shrunken;
        std::size_t at = 0;
        for (const std::int32_t name : names) {
            const Grid& grid = discs_[static_cast<std::size_t>(name)];
            std::int64_t exponent = scale_;
            if (!powers_.empty()) {
                exponent *= powers_[static_cast<std::size_t>(name)];
            } else if (spacing_ == Spacing::steps) {
                exponent *= size() - grid.rank;
            } else {
                for (const std::int32_t other : names) {
                    if (discs_[static_cast<std::size_t>(other)].rank > grid.rank) exponent *= 8;
                }
            }
            shrunken[at] = {Enclosure{grid.x}, Enclosure{grid.y},
                            Enclosure{grid.r} - Enclosure{Integer{1}, -exponent}};
            ++at;
        }
        try {
            return question(shrunken);
        } catch (const Undecided&) {
        }
    }
    throw std::logic_error("euclidean oracle: degenerate even after shrinking");
}

bool ShrunkenDiscs::hides(std::int32_t i, std::int32_t q) const {
    return ask({i, q}, [](const std::array<Disc, 4>& discs) {
        const Vector v = discs[1] - discs[0];
        // |c_q - c_i| + r_q < r_i
        return v.r.sign() < 0 && product(v, v).sign() < 0;
    });
}

bool ShrunkenDiscs::nearer(std::int32_t a, std::int32_t b, std::int32_t q) const {
    return ask({a, b, q}, [](const std::array<Disc, 4>& discs) {
        const auto distance = [&](const Disc& disc) {
            const Vector v = disc - discs[2];
            const Enclosure square = v.x * v.x + v.y * v.y;
            return square.is_zero() ? -disc.r : sqrt(square) - disc.r;
        };
        return (distance(discs[0]) - distance(discs[1])).sign() < 0;
    });
}

bool ShrunkenDiscs::exists(std::int32_t i, std::int32_t j, std::int32_t k) const {
    return ask({i, j, k}, [](const std::array<Disc, 4>& discs) {
        const std::size_t count = circles(discs[0], discs[1], discs[2]).size();
        if (count > 1) throw std::logic_error("euclidean oracle: two circles touch the same way");
        return count == 1;
    });
}

bool ShrunkenDiscs::conflicts(std::int32_t i, std::int32_t j, std::int32_t k,
                              std::int32_t q) const {
    return ask({i, j, k, q}, [](const std::array<Disc, 4>& discs) {
        const std::vector<Circle> touching = circles(discs[0], discs[1], discs[2]);
        if (touching.size() != 1) throw std::logic_error("euclidean oracle: no such circle");
        const Circle& circle = touching.front();
        const Vector v = discs[3] - discs[0];
        // |X - v| < R + s: the right side must be positive, then squares decide.
        const Enclosure reach = circle.reach + v.r;
        if (reach.sign() < 0) return false;
        const Enclosure dx = circle.x - v.x;
        const Enclosure dy = circle.y - v.y;
        return (dx * dx + dy * dy - reach * reach).sign() < 0;
    });
}

bool ShrunkenDiscs::crosses(std::int32_t a, std::int32_t b, std::int32_t q) const {
    return ask({a, b, q}, [](const std::array<Disc, 4>& discs) {
        // A line has a and b on its left and touches both. With its unit normal n pointing left,
        // n·c - r is the same for both, so n·u = s; n turned clockwise points from a to b.
        const Vector u = discs[1] - discs[0];
        const Vector w = discs[2] - discs[0];
        const Enclosure square = u.x * u.x + u.y * u.y;
        const Enclosure forward = sqrt(square - u.r * u.r);
        const Enclosure nx = (u.r * u.x - forward * u.y) / square;
        const Enclosure ny = (u.r * u.y + forward * u.x) / square;
        return (nx * w.x + ny * w.y - w.r).sign() < 0;
    });
}

Tessellation euclidean(std::span<const Site> sites) {
    const Tessellation result = tessellate({sites, Spacing::powers});
    check(result, sites.size());
    const Tessellation again = tessellate({sites, Spacing::steps, 2});
    if (result != again) {
        throw std::logic_error("euclidean oracle: other infinitesimals, other result: " +
                               text(result) + " / " + text(again));
    }
    return result;
}

Tessellation euclidean(std::span<const Site> sites, const std::vector<std::int64_t>& powers) {
    const Tessellation result = tessellate({sites, powers});
    check(result, sites.size());
    return result;
}

}  // namespace signum::oracle
