#include "sphere.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace signum::oracle {
namespace {

void demand(bool holds, const std::string& what) {
    if (!holds) throw std::logic_error("oracle: " + what);
}

/// Sets of vertices that hang together; vertex v is element v + 1.
class Joined {
 public:
    explicit Joined(std::size_t sites) : parent_(sites + 1) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }
    void join(std::int32_t a, std::int32_t b) { parent_[root(a)] = root(b); }
    bool are_joined(std::int32_t a, std::int32_t b) const { return root(a) == root(b); }

 private:
    std::size_t root(std::int32_t vertex) const {
        auto element = static_cast<std::size_t>(vertex + 1);
        while (parent_[element] != element) element = parent_[element];
        return element;
    }
    std::vector<std::size_t> parent_;
};

}  // namespace

std::array<std::int32_t, 3> canonical(std::array<std::int32_t, 3> face) {
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    return face;
}

void check_sphere(const Tessellation& tessellation, const std::vector<bool>& visible) {
    const std::size_t sites = visible.size();
    const auto n = static_cast<std::size_t>(std::count(visible.begin(), visible.end(), true));
    const auto& faces = tessellation.faces;
    demand(sites == 0 || n >= 1, "no site is visible");

    std::size_t expected_hidden = 0;
    for (const auto& [site, by] : tessellation.hidden) {
        while (expected_hidden < sites && visible[expected_hidden]) ++expected_hidden;
        demand(static_cast<std::size_t>(site) == expected_hidden++, "wrong list of hidden sites");
        demand(by >= 0 && visible[static_cast<std::size_t>(by)], "hidden by an invisible site");
    }
    demand(tessellation.hidden.size() == sites - n, "wrong number of hidden sites");

    demand(std::is_sorted(faces.begin(), faces.end()), "faces are not sorted");
    demand(faces.size() == (n <= 1 ? 0 : 2 * n - 2),
           std::to_string(faces.size()) + " faces of " + std::to_string(n) + " visible sites");
    if (n <= 1) return;

    std::map<std::pair<std::int32_t, std::int32_t>, int> directed;  // how often u -> v occurs
    Joined all(sites);
    std::vector<Joined> link(sites + 1, Joined(sites));        // of vertex v: link[v + 1]
    std::vector<std::vector<std::int32_t>> around(sites + 1);  // neighbours, repeated
    for (const auto& face : faces) {
        demand(face == canonical(face), "a face is not rotated to its smallest number");
        for (std::size_t i = 0; i < 3; ++i) {
            const std::int32_t u = face[i], v = face[(i + 1) % 3], w = face[(i + 2) % 3];
            demand(u != v, "a face names a vertex twice");
            demand(u == at_infinity || (u >= 0 && static_cast<std::size_t>(u) < sites &&
                                        visible[static_cast<std::size_t>(u)]),
                   "a face names a vertex that is not visible");
            ++directed[{u, v}];
            all.join(u, v);
            link[static_cast<std::size_t>(u + 1)].join(v, w);
            around[static_cast<std::size_t>(u + 1)].push_back(v);
        }
    }
    for (const auto& [edge, times] : directed) {
        const auto opposite = directed.find({edge.second, edge.first});
        demand(opposite != directed.end() && opposite->second == times,
               "the two sides of an edge do not match");
    }
    for (std::size_t vertex = 0; vertex <= sites; ++vertex) {
        if (vertex > 0 && !visible[vertex - 1]) continue;
        demand(!around[vertex].empty(), "a visible site is in no face");
        demand(all.are_joined(at_infinity, static_cast<std::int32_t>(vertex) - 1),
               "the faces do not hang together");
        for (const std::int32_t neighbour : around[vertex])
            demand(link[vertex].are_joined(neighbour, around[vertex].front()),
                   "the faces around a vertex do not hang together");
    }
}

}  // namespace signum::oracle
