#include "valid_power.hpp"

#include "linear_form.hpp"
#include "sphere.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

namespace signum::oracle {
namespace {

using Triple = std::array<std::int32_t, 3>;
using DirectedEdge = std::array<std::int32_t, 2>;

struct Weighted {
    Rational x;
    Rational y;
    Rational weight;
};

struct Wrong {
    std::string why;
};
void demand(bool holds, const char* why) {
    if (!holds) throw Wrong{why};
}

std::size_t at(std::int32_t i) {
    return static_cast<std::size_t>(i);
}
/// From the vertex after the k-th to the one before it.
DirectedEdge edge_across(const Triple& face, std::size_t k) {
    return {face[(k + 1) % 3], face[(k + 2) % 3]};
}

class Judge {
 public:
    Judge(const Tessellation& tessellation, const Neighbours& neighbours,
          std::vector<Weighted> sites)
        : faces_(tessellation.faces),
          neighbours_(neighbours),
          hidden_(tessellation.hidden),
          sites_(std::move(sites)) {}

    void judge() {
        judge_numbers();
        for (const Weighted& site : sites_)
            height_.push_back(site.x * site.x + site.y * site.y - site.weight);
        if (spans_plane())
            judge_plane();
        else
            judge_line();
        for (const auto& [q, by] : hidden_)
            for (std::size_t v = 0; v < sites_.size(); ++v)
                demand(!visible_[v] || distance(at(q), at(by)) <= distance(at(q), v),
                       "hidden by one that is not the nearest");
    }

 private:
    // ---- numbers ------------------------------------------------------------------------------

    void judge_numbers() {
        const auto n = static_cast<std::int32_t>(sites_.size());
        std::set<std::int32_t> in_faces;
        for (const Triple& face : faces_)
            for (std::size_t k = 0; k < 3; ++k) {
                demand(face[k] >= at_infinity && face[k] < n, "no such site");
                demand(face[k] != face[(k + 1) % 3], "a face has a vertex twice");
                in_faces.insert(face[k]);
            }
        visible_.assign(sites_.size(), true);
        for (const auto& [q, by] : hidden_) {
            demand(q >= 0 && q < n && by >= 0 && by < n, "hidden: no such site");
            demand(visible_[at(q)], "hidden twice");
            visible_[at(q)] = false;
        }
        for (const auto& [q, by] : hidden_) demand(visible_[at(by)], "hidden by a hidden one");
        const auto count = std::count(visible_.begin(), visible_.end(), true);
        demand(n == 0 || count > 0, "no site is visible");
        if (count >= 2 || !faces_.empty())
            for (std::int32_t i = 0; i < n; ++i)
                demand(visible_[at(i)] == (in_faces.count(i) != 0),
                       "hidden sites have no face, others have one");
        demand(neighbours_.empty() || neighbours_.size() == faces_.size(), "so many neighbours");
    }

    // ---- the plane ----------------------------------------------------------------------------

    [[nodiscard]] bool spans_plane() const {
        for (std::size_t b = 1; b < sites_.size(); ++b)
            for (std::size_t c = b + 1; c < sites_.size(); ++c)
                if (ccw(0, b, c) != 0) return true;
        return false;
    }
    void judge_plane() {
        judge_edges();
        std::vector<Triple> finite;
        Rational area;
        for (const Triple& face : faces_) {
            if (is_infinite(face)) continue;
            const Rational its = ccw(at(face[0]), at(face[1]), at(face[2]));
            demand(its > 0, "a face is not counterclockwise");
            area += its;
            finite.push_back(face);
        }
        demand(area == area_of_hull(), "the areas of faces are not that of the hull");
        for (const Triple& face : faces_) {
            for (std::size_t k = 0; k < 3; ++k)
                demand(face[k] != at_infinity ||
                           !have_one_centre(at(face[(k + 1) % 3]), at(face[(k + 2) % 3])),
                       "an edge of the hull has both ends in one place");
            for (std::size_t q = 0; q < sites_.size(); ++q)
                demand(!is_in_conflict(face, q), "a site is in conflict with a face");
        }
        for (std::size_t f = 0; f < finite.size(); ++f)
            for (std::size_t g = 0; g < f; ++g)
                demand(has_edge_between(finite[f], finite[g]) ||
                           has_edge_between(finite[g], finite[f]),
                       "two faces overlap");
    }
    /// Each edge is one of two faces, which name each other.
    void judge_edges() const {
        std::map<DirectedEdge, std::size_t> face_of;
        for (std::size_t f = 0; f < faces_.size(); ++f)
            for (std::size_t k = 0; k < 3; ++k)
                demand(face_of.emplace(edge_across(faces_[f], k), f).second,
                       "two faces have an edge on the same side");
        for (std::size_t f = 0; f < faces_.size(); ++f)
            for (std::size_t k = 0; k < 3; ++k) {
                const auto [from, to] = edge_across(faces_[f], k);
                const auto other = face_of.find({to, from});
                demand(other != face_of.end(), "an edge is one of a single face");
                demand(neighbours_.empty() ||
                           neighbours_[f][k] == static_cast<std::int32_t>(other->second),
                       "a neighbour does not share the edge");
            }
    }
    [[nodiscard]] static bool is_infinite(const Triple& face) {
        return std::count(face.begin(), face.end(), at_infinity) != 0;
    }
    /// Twice the area of the hull: of its edges, each from end to end.
    [[nodiscard]] Rational area_of_hull() const {
        Rational area;
        std::set<std::pair<Rational, Rational>> starts;
        for (std::size_t a = 0; a < sites_.size(); ++a)
            for (std::size_t b = 0; b < sites_.size(); ++b) {
                if (have_one_centre(a, b)) continue;
                bool is_edge = true;
                for (std::size_t q = 0; q < sites_.size() && is_edge; ++q) {
                    const Rational side = ccw(a, b, q);
                    is_edge = side > 0 || (side == 0 && is_between(a, b, q));
                }
                if (is_edge && starts.emplace(sites_[a].x, sites_[a].y).second)
                    area += sites_[a].x * sites_[b].y - sites_[a].y * sites_[b].x;
            }
        return area;
    }
    /// A site is in conflict with a finite face where it is below the plane of the lifted vertices,
    /// with an infinite one where it is beyond the edge, or on its line and below that of the
    /// lifted ends.
    [[nodiscard]] bool is_in_conflict(Triple face, std::size_t q) const {
        std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
        const std::size_t b = at(face[1]);
        const std::size_t c = at(face[2]);
        if (face[0] == at_infinity) {
            const Rational side = ccw(b, c, q);
            return side > 0 || (side == 0 && is_below_line(b, c, q));
        }
        const std::size_t a = at(face[0]);
        return height_[q] * ccw(a, b, c) <
               height_[a] * ccw(q, b, c) + height_[b] * ccw(a, q, c) + height_[c] * ccw(a, b, q);
    }
    /// Whether the line of an edge of the one face has the other one on its far side.
    [[nodiscard]] bool has_edge_between(const Triple& face, const Triple& other) const {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [from, to] = edge_across(face, k);
            if (std::all_of(other.begin(), other.end(), [&, from = from, to = to](std::int32_t v) {
                    return ccw(at(from), at(to), at(v)) <= 0;
                }))
                return true;
        }
        return false;
    }

    // ---- a line, one place, none --------------------------------------------------------------

    void judge_line() const {
        std::vector<std::int32_t> line;
        for (std::size_t i = 0; i < sites_.size(); ++i)
            if (visible_[i]) line.push_back(static_cast<std::int32_t>(i));
        const auto place = [&](std::int32_t i) {
            return std::pair(sites_[at(i)].x, sites_[at(i)].y);
        };
        std::sort(line.begin(), line.end(),
                  [&](std::int32_t i, std::int32_t j) { return place(i) < place(j); });
        for (std::size_t q = 0; q < sites_.size(); ++q) {
            const auto here = place(static_cast<std::int32_t>(q));
            demand(place(line.front()) <= here && here <= place(line.back()),
                   "a hidden site is beyond the ends");
            demand(line.size() > 1 || sites_[q].weight <= sites_[at(line[0])].weight,
                   "the visible site is not the largest");
        }
        const std::size_t segments = line.empty() ? 0 : line.size() - 1;
        demand(faces_.size() == 2 * segments, "segments have two faces each");
        for (std::size_t i = 0; i < segments; ++i) {
            demand(place(line[i]) < place(line[i + 1]), "two visible sites are in one place");
            for (std::size_t q = 0; q < sites_.size(); ++q)
                demand(!is_below_line(at(line[i]), at(line[i + 1]), q),
                       "a site is in conflict with a segment");
            // The faces at infinity on either side, by which one goes there and back.
            const std::int32_t there = face_along(line[i], line[i + 1]);
            const std::int32_t back = face_along(line[i + 1], line[i]);
            const bool is_first = i == 0;
            const bool is_last = i + 1 == segments;
            judge_neighbour(there, at_infinity, back);
            judge_neighbour(back, at_infinity, there);
            judge_neighbour(there, line[i], is_last ? back : face_along(line[i + 1], line[i + 2]));
            judge_neighbour(there, line[i + 1], is_first ? back : face_along(line[i - 1], line[i]));
            judge_neighbour(back, line[i], is_last ? there : face_along(line[i + 2], line[i + 1]));
            judge_neighbour(back, line[i + 1], is_first ? there : face_along(line[i], line[i - 1]));
        }
    }
    [[nodiscard]] std::int32_t face_along(std::int32_t from, std::int32_t to) const {
        std::int32_t result = -1;
        for (std::size_t f = 0; f < faces_.size(); ++f) {
            if (canonical(faces_[f]) != Triple{at_infinity, from, to}) continue;
            demand(result == -1, "a face occurs twice");
            result = static_cast<std::int32_t>(f);
        }
        demand(result != -1, "a face is missing");
        return result;
    }
    void judge_neighbour(std::int32_t face, std::int32_t across_from, std::int32_t expected) const {
        if (neighbours_.empty()) return;
        for (std::size_t k = 0; k < 3; ++k)
            if (faces_[at(face)][k] == across_from)
                demand(neighbours_[at(face)][k] == expected, "another neighbour on a line");
    }

    // ---- places -------------------------------------------------------------------------------

    [[nodiscard]] Rational ccw(std::size_t a, std::size_t b, std::size_t c) const {
        const Weighted &p = sites_[a], &q = sites_[b], &r = sites_[c];
        return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    }
    [[nodiscard]] bool have_one_centre(std::size_t a, std::size_t b) const {
        return sites_[a].x == sites_[b].x && sites_[a].y == sites_[b].y;
    }
    /// (q - a)·(b - a)
    [[nodiscard]] Rational dot(std::size_t a, std::size_t b, std::size_t q) const {
        return (sites_[q].x - sites_[a].x) * (sites_[b].x - sites_[a].x) +
               (sites_[q].y - sites_[a].y) * (sites_[b].y - sites_[a].y);
    }
    /// Of a centre on the line through those of a and b.
    [[nodiscard]] bool is_between(std::size_t a, std::size_t b, std::size_t q) const {
        const Rational part = dot(a, b, q);
        return part >= 0 && part <= dot(a, b, b);
    }
    [[nodiscard]] bool is_below_line(std::size_t a, std::size_t b, std::size_t q) const {
        const Rational whole = dot(a, b, b);
        const Rational part = dot(a, b, q);
        return height_[q] * whole < height_[a] * (whole - part) + height_[b] * part;
    }
    /// The power distance from the centre of q.
    [[nodiscard]] Rational distance(std::size_t q, std::size_t site) const {
        const Rational x = sites_[q].x - sites_[site].x;
        const Rational y = sites_[q].y - sites_[site].y;
        return x * x + y * y - sites_[site].weight;
    }

    const std::vector<Triple>& faces_;
    const Neighbours& neighbours_;
    const std::vector<DirectedEdge>& hidden_;
    std::vector<Weighted> sites_;
    std::vector<bool> visible_;
    std::vector<Rational> height_;
};

std::string judged(const Tessellation& tessellation, const Neighbours& neighbours,
                   std::vector<Weighted> sites) {
    try {
        Judge(tessellation, neighbours, std::move(sites)).judge();
    } catch (const Wrong& wrong) {
        return wrong.why;
    }
    return "";
}

}  // namespace

std::string what_is_wrong(const Tessellation& tessellation, const Neighbours& neighbours,
                          std::span<const signum::Site> sites) {
    std::vector<Weighted> exact;
    for (const signum::Site& site : sites) {
        const Rational radius = exactly(site.r);
        exact.push_back({exactly(site.x), exactly(site.y), radius * radius});
    }
    return judged(tessellation, neighbours, std::move(exact));
}

std::string what_is_wrong(const Tessellation& tessellation, const Neighbours& neighbours,
                          std::span<const signum::power::Site> sites) {
    std::vector<Weighted> exact;
    for (const signum::power::Site& site : sites)
        exact.push_back({exactly(site.x), exactly(site.y), exactly(site.w)});
    return judged(tessellation, neighbours, std::move(exact));
}

}  // namespace signum::oracle
