#include "validate_finite.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "../predicates/power.hpp"
#include "../predicates/space.hpp"
#include "space/triangulate.hpp"
#include "space/validate.hpp"
#include "triangulate.hpp"

namespace signum {
namespace {

/// What differs between the plane and space.
struct Plane {
    static constexpr std::size_t corners = 3;
    static constexpr const char* face = "face";
    static constexpr const char* facet = "edge";
    static constexpr const char* ball = "circle";

    StridedSites sites;

    [[nodiscard]] Sign turn(const std::array<Index, 3>& f) const {
        return ccw(centre(f[0]), centre(f[1]), centre(f[2]));
    }
    [[nodiscard]] Sign conflict(const std::array<Index, 3>& f, Index q) const {
        const auto ask = [&]<class S>(S) {
            return power::in_circle(site<S>(f[0]), site<S>(f[1]), site<S>(f[2]), site<S>(q));
        };
        if (sites.third() == nullptr) return ask(Point{});
        return sites.third_is_weight() ? ask(power::Site{}) : ask(Site{});
    }
    /// Orders equal sites beside one another.
    [[nodiscard]] std::array<double, 4> key(std::size_t i) const {
        const Site s = sites[i];
        return {s.x, s.y, 0.0, sites.third_is_weight() ? s.r : std::fabs(s.r)};
    }
    [[nodiscard]] std::size_t size() const { return sites.size(); }
    using Sites = std::vector<Site>;
    [[nodiscard]] Sites chosen(const std::vector<Index>& numbers) const {
        Sites some;
        for (const Index i : numbers) some.push_back(sites[static_cast<std::size_t>(i)]);
        return some;
    }
    [[nodiscard]] Plane of_chosen(const Sites& some) const {
        const Site& first = some.front();
        return {{some.size(), sizeof(Site), &first.x, &first.y, &first.r, sites.third_is_weight()}};
    }

 private:
    [[nodiscard]] Point centre(Index i) const {
        const Site s = sites[static_cast<std::size_t>(i)];
        return {s.x, s.y};
    }
    template <class S>
    [[nodiscard]] S site(Index i) const {
        return power::made_of<S>(sites[static_cast<std::size_t>(i)]);
    }
};
template <class S>
struct Space {
    static constexpr std::size_t corners = 4;
    static constexpr const char* face = "cell";
    static constexpr const char* facet = "facet";
    static constexpr const char* ball = "sphere";

    std::span<const S> sites;

    [[nodiscard]] Sign turn(const std::array<Index, 4>& f) const {
        return ccw(at(f[0]), at(f[1]), at(f[2]), at(f[3]));
    }
    [[nodiscard]] Sign conflict(const std::array<Index, 4>& f, Index q) const {
        return power::in_sphere(at(f[0]), at(f[1]), at(f[2]), at(f[3]), at(q));
    }
    [[nodiscard]] std::array<double, 4> key(std::size_t i) const {
        const S& s = sites[i];
        return {s.x, s.y, s.z, power::weight_key(s)};
    }
    [[nodiscard]] std::size_t size() const { return sites.size(); }
    using Sites = std::vector<S>;
    [[nodiscard]] Sites chosen(const std::vector<Index>& numbers) const {
        Sites some;
        for (const Index i : numbers) some.push_back(at(i));
        return some;
    }
    [[nodiscard]] static Space of_chosen(const Sites& some) { return {some}; }

 private:
    [[nodiscard]] const S& at(Index i) const { return sites[static_cast<std::size_t>(i)]; }
};

/// The canonical tessellation, whose hidden sites are those of all, and its hull.
struct Reference {
    std::vector<Hidden> hidden;
    bool has_faces;                 ///< finite ones
    std::vector<Face> at_infinity;  ///< of the plane
};
Reference reference_of(const Plane& of, const ValidationOptions& options) {
    const Tessellation whole =
        triangulate(of.sites, Power{}, {.threads = options.threads, .stop = options.stop});
    Reference reference{whole.arrays().hidden, false, {}};
    for (const Face& face : whole.faces()) {
        if (face[0] == infinite) reference.at_infinity.push_back(face);
        reference.has_faces |= face[0] != infinite;
    }
    return reference;
}
template <class S>
Reference reference_of(const Space<S>& of, const ValidationOptions& options) {
    const SpaceTessellation whole =
        triangulate(of.sites, Power{}, {.threads = options.threads, .stop = options.stop});
    return {whole.hidden, whole.dimension == 3, {}};
}

/// The judgement of validate() about the faces with those at infinity, which follow them.
Validation judged(const Plane& of, std::vector<std::array<Index, 3>> faces,
                  std::vector<std::array<Index, 3>> neighbours, const ValidationOptions& options) {
    TessellationArrays arrays;
    arrays.weight_is = of.sites.third_is_weight() ? WeightIs::weight : WeightIs::radius;
    arrays.sites = static_cast<std::int64_t>(of.size());
    arrays.faces = std::move(faces);
    arrays.neighbours = std::move(neighbours);
    return validate(arrays, of.sites, options);
}
template <class S>
Validation judged(const Space<S>& of, std::vector<std::array<Index, 4>> faces,
                  std::vector<std::array<Index, 4>> neighbours, const ValidationOptions& options) {
    SpaceTessellation space;
    space.dimension = 3;
    space.sites = static_cast<std::int64_t>(of.size());
    space.cells = std::move(faces);
    space.neighbours = std::move(neighbours);
    return validate(space, of.sites, options);
}

template <class Of>
class Judge {
    static constexpr std::size_t corners = Of::corners;
    using Face = std::array<Index, corners>;

    /// A facet as one of its faces has it.
    struct Side {
        std::array<Index, corners - 1> sites;  ///< rising
        std::int64_t face;
        std::size_t corner;  ///< across from it
        bool is_even;        ///< the corner and they, as the face has them
    };

 public:
    Judge(Of of, std::span<const Face> faces, const ValidationOptions& options, int numbered_from)
        : of_(std::move(of)),
          faces_(faces.begin(), faces.end()),
          options_(options),
          first_number_(numbered_from) {}

    FiniteValidation run() {
        for (std::size_t i = 0; i < of_.size(); ++i)
            if (!std::ranges::all_of(of_.key(i), [](double x) { return std::isfinite(x); }))
                throw std::invalid_argument("site " + std::to_string(i) + " is not finite");
        for (std::size_t f = 0; f < faces_.size(); ++f) check_numbers(f);
        if (!result_.faults.empty()) return finished();
        vertices_are_said_once();
        for (std::size_t f = 0; f < faces_.size(); ++f) turn_alike(f);
        std::vector<Side> border;
        pair_up(border);
        if (has_been_glued_ && result_.message.empty() && !faces_.empty()) {
            result_.valid = are_a_triangulation(border);
            if (result_.valid) return finished();
        }
        // What is wrong is looked for beside a tessellation of ours.
        const std::string message = std::exchange(result_.message, {});
        const Reference reference = reference_of(of_, options_);
        if (faces_.empty() && !reference.has_faces) {
            result_.valid = true;
            return finished();
        }
        find_missing(reference.hidden);
        if (has_been_glued_) count_open(border, reference.at_infinity);
        if (!message.empty()) result_.message = message;
        if (result_.message.empty()) result_.message = faces_.empty() ? "there is no face" : why_;
        return finished();
    }

 private:
    /// As messages have it.
    [[nodiscard]] std::string number(std::int64_t of) const {
        return std::to_string(of + first_number_);
    }
    [[nodiscard]] std::string name(std::size_t f) const {
        return Of::face + (" " + number(static_cast<std::int64_t>(f)));
    }
    void blame(std::size_t f, FiniteFault fault, const std::string& why) {
        if (result_.message.empty()) result_.message = name(f) + ": " + why;
        result_.faults.push_back({static_cast<std::int64_t>(f), fault});
    }

    /// edge 2 5
    [[nodiscard]] std::string facet_of(const Side& side) const {
        std::string text = Of::facet;
        for (const Index site : side.sites) text += " " + number(site);
        return text;
    }

    void check_numbers(std::size_t f) {
        Face face = faces_[f];
        for (const Index site : face)
            if (site < 0 || static_cast<std::size_t>(site) >= of_.size())
                return blame(f, FiniteFault::number,
                             "there is no site " + number(site) + " of " +
                                 std::to_string(of_.size()) + ", which are numbered from " +
                                 number(0));
        std::ranges::sort(face);
        if (const auto* const twice = std::ranges::adjacent_find(face); twice != face.end())
            blame(f, FiniteFault::number, "site " + number(*twice) + " is there twice");
    }

    /// Of equal sites one alone is a vertex, and stands for all from here on.
    void vertices_are_said_once() {
        is_vertex_.assign(of_.size(), 0);
        for (const Face& face : faces_)
            for (const Index site : face) is_vertex_[static_cast<std::size_t>(site)] = 1;
        std::vector<Index> order(of_.size());
        std::iota(order.begin(), order.end(), 0);
        const auto key = [&](Index i) { return of_.key(static_cast<std::size_t>(i)); };
        std::ranges::sort(order, {}, [&](Index i) { return std::pair(key(i), i); });
        std::vector<Index> first(of_.size(), 0);  // of the sites that equal it
        for (std::size_t k = 0, end = 0; k < order.size(); k = end) {
            for (end = k; end < order.size() && key(order[end]) == key(order[k]); ++end)
                first[static_cast<std::size_t>(order[end])] = order[k];
        }
        // The first of equal ones is the canonical one.
        std::vector<char> is_first_vertex(of_.size(), 0);
        for (std::size_t i = 0; i < of_.size(); ++i) {
            if (is_vertex_[i] == 0) continue;
            char& known = is_first_vertex[static_cast<std::size_t>(first[i])];
            if (known != 0 && result_.message.empty())
                result_.message = "site " + number(static_cast<std::int64_t>(i)) +
                                  " is a vertex, and another one at the same place is, too";
            known = 1;
        }
        is_vertex_ = std::move(is_first_vertex);
        for (Face& face : faces_)
            for (Index& site : face) site = first[static_cast<std::size_t>(site)];
    }

    void turn_alike(std::size_t f) {
        Face& face = faces_[f];
        const Sign turn = of_.turn(face);
        if (turn == 0) {
            blame(f, FiniteFault::flat,
                  corners == 3 ? "its sites lie on a line" : "its sites lie in a plane");
            return;
        }
        if (turn < 0) std::swap(face[corners - 2], face[corners - 1]);
    }

    [[nodiscard]] static Side side_of(const std::vector<Face>& faces, std::size_t f,
                                      std::size_t corner) {
        Side side{{}, static_cast<std::int64_t>(f), corner, corner % 2 == 0};
        for (std::size_t k = 0, to = 0; k < corners; ++k)
            if (k != corner) side.sites[to++] = faces[f][k];
        for (std::size_t end = corners - 1; end > 1; --end)
            for (std::size_t k = 0; k + 1 < end; ++k)
                if (side.sites[k + 1] < side.sites[k]) {
                    std::swap(side.sites[k], side.sites[k + 1]);
                    side.is_even = !side.is_even;
                }
        return side;
    }
    /// All of all faces, those of one facet beside one another.
    [[nodiscard]] static std::vector<Side> sorted_sides(const std::vector<Face>& faces) {
        std::vector<Side> sides;
        sides.reserve(corners * faces.size());
        for (std::size_t f = 0; f < faces.size(); ++f)
            for (std::size_t k = 0; k < corners; ++k) sides.push_back(side_of(faces, f, k));
        std::ranges::sort(sides, {}, [](const Side& s) { return std::tuple(s.sites, s.face); });
        return sides;
    }
    /// With those at infinity; false where the border is no closed curve (surface).
    [[nodiscard]] bool find_neighbours(const std::vector<Face>& faces,
                                       std::vector<Face>& neighbours) {
        const std::vector<Side> sides = sorted_sides(faces);
        neighbours.resize(faces.size());
        for (std::size_t s = 0; s < sides.size(); s += 2) {
            const bool are_two = s + 1 < sides.size() && sides[s].sites == sides[s + 1].sites &&
                                 (s + 2 == sides.size() || sides[s + 2].sites != sides[s].sites);
            if (!are_two) {
                result_.message = "the border of the " + std::string(Of::face) +
                                  "s meets itself at site " + number(sides[s].sites[corners - 2]);
                return false;
            }
            const auto tell = [&](const Side& one, const Side& other) {
                neighbours[static_cast<std::size_t>(one.face)][one.corner] =
                    static_cast<Index>(other.face);
            };
            tell(sides[s], sides[s + 1]);
            tell(sides[s + 1], sides[s]);
        }
        return true;
    }
    /// Two faces at each facet, on different sides, and neither site beyond in the other's circle.
    void pair_up(std::vector<Side>& border) {
        const std::vector<Side> sides = sorted_sides(faces_);
        const std::size_t flat = result_.faults.size();
        for (std::size_t s = 0, end = 0; s < sides.size(); s = end) {
            for (end = s; end < sides.size() && sides[end].sites == sides[s].sites;) ++end;
            if (end - s == 1) {
                border.push_back(sides[s]);
                continue;
            }
            const auto f = static_cast<std::size_t>(sides[s].face);
            const auto g = static_cast<std::size_t>(sides[s + 1].face);
            // A flat one has no side and no circle.
            if (end - s == 2 && flat > 0 && (of_.turn(faces_[f]) == 0 || of_.turn(faces_[g]) == 0))
                continue;
            if (end - s > 2 || sides[s].is_even == sides[s + 1].is_even) {
                for (std::size_t each = s; each < end; ++each)
                    blame(static_cast<std::size_t>(sides[each].face), FiniteFault::overlap,
                          end - s > 2
                              ? std::to_string(end - s) + " " + Of::face + "s share its " +
                                    facet_of(sides[s])
                              : name(each == s ? g : f) + " lies on the same side of their " +
                                    facet_of(sides[s]));
                continue;
            }
            const Index beyond = faces_[g][sides[s + 1].corner];
            if (of_.conflict(faces_[f], beyond) > 0) {
                blame(f, FiniteFault::conflict,
                      "site " + number(beyond) + " of " + name(g) + " lies in its " + Of::ball +
                          ", across their " + facet_of(sides[s]));
                result_.faults.push_back({static_cast<std::int64_t>(g), FiniteFault::conflict});
            }
        }
        has_been_glued_ = std::ranges::none_of(
            result_.faults, [](const auto& each) { return each.fault != FiniteFault::conflict; });
    }

    /// The face at infinity beyond a facet of the border.
    [[nodiscard]] Face beyond(const Side& side) const {
        Face face = faces_[static_cast<std::size_t>(side.face)];
        face[side.corner] = infinite;
        // On the other side it turns the other way.
        std::swap(face[(side.corner + 1) % corners], face[(side.corner + 2) % corners]);
        return face;
    }

    /// Sites of no face that the canonical tessellation has.
    void find_missing(const std::vector<Hidden>& hidden) {
        std::vector<char> is_hidden(of_.size(), 0);
        for (const Hidden& each : hidden) is_hidden[static_cast<std::size_t>(each.site)] = 1;
        for (std::size_t i = 0; i < of_.size(); ++i)
            if (is_vertex_[i] == 0 && is_hidden[i] == 0)
                result_.missing.push_back(static_cast<std::int64_t>(i));
        if (!result_.missing.empty() && result_.message.empty())
            result_.message = "site " + number(result_.missing.front()) + " is no vertex of any " +
                              Of::face + ", and should be one";
    }

    /// Whether they are a regular triangulation of their vertices, and no other site comes into a
    /// circle: each of them is looked for, and a walk in such a triangulation ends.
    [[nodiscard]] bool are_a_triangulation(const std::vector<Side>& border) {
        std::vector<Face> faces = faces_;
        for (const Side& side : border) faces.push_back(beyond(side));
        std::vector<Face> neighbours;
        return find_neighbours(faces, neighbours) && is_regular(faces, neighbours) &&
               hides_the_others(faces, neighbours);
    }
    [[nodiscard]] bool is_regular(std::vector<Face> faces, const std::vector<Face>& neighbours) {
        std::vector<Index> vertices;
        std::vector<Index> number(of_.size(), infinite);
        for (std::size_t i = 0; i < of_.size(); ++i)
            if (is_vertex_[i] != 0) {
                number[i] = static_cast<Index>(vertices.size());
                vertices.push_back(static_cast<Index>(i));
            }
        for (Face& face : faces)
            for (Index& site : face)
                if (site != infinite) site = number[static_cast<std::size_t>(site)];
        const typename Of::Sites sites = of_.chosen(vertices);
        const Validation judged_ones = judged(of_.of_chosen(sites), faces, neighbours, options_);
        if (!judged_ones.valid) why_ = judged_ones.message;
        return judged_ones.valid;
    }
    [[nodiscard]] bool hides_the_others(const std::vector<Face>& faces,
                                        const std::vector<Face>& neighbours) const {
        std::size_t at = 0;
        const auto moves_towards = [&](Index site) {
            for (std::size_t k = 0; k < corners; ++k) {
                Face turned = faces[at];
                turned[k] = site;
                if (of_.turn(turned) >= 0) continue;
                at = static_cast<std::size_t>(neighbours[at][k]);
                return true;
            }
            return false;
        };
        for (std::size_t i = 0; i < of_.size(); ++i) {
            if (is_vertex_[i] != 0) continue;
            const auto site = static_cast<Index>(i);
            while (!is_infinite(faces[at]) && moves_towards(site)) {
            }
            // Beyond the hull, or a vertex that is missing.
            if (is_infinite(faces[at]) || of_.conflict(faces[at], site) > 0) return false;
        }
        return true;
    }
    [[nodiscard]] static bool is_infinite(const Face& face) {
        return std::ranges::find(face, infinite) != face.end();
    }

    void count_open(const std::vector<Side>& border, const std::vector<signum::Face>& hull) {
        if constexpr (corners == 3) {
            std::set<std::array<Index, 2>> edges;
            for (const auto& [at_infinity, b, a] : hull)
                edges.insert({std::min(a, b), std::max(a, b)});
            for (const Side& side : border)
                if (!edges.contains(side.sites)) {
                    result_.open.push_back({side.face, side.sites});
                    if (result_.message.empty())
                        result_.message = name(static_cast<std::size_t>(side.face)) + ": its " +
                                          facet_of(side) +
                                          " is on no other face, and not on the hull";
                }
        }
    }

    FiniteValidation finished() {
        std::ranges::sort(result_.open, {}, [](const FiniteValidation::OpenEdge& each) {
            return std::pair(each.face, each.between);
        });
        std::ranges::sort(result_.faults, {}, [](const FiniteValidation::Fault& each) {
            return std::pair(each.face, each.fault);
        });
        result_.faults.erase(
            std::unique(result_.faults.begin(), result_.faults.end(),
                        [](const auto& a, const auto& b) { return a.face == b.face; }),
            result_.faults.end());
        return std::move(result_);
    }

    Of of_;
    std::vector<Face> faces_;
    const ValidationOptions& options_;
    int first_number_;
    FiniteValidation result_;
    std::vector<char> is_vertex_;
    bool has_been_glued_ = false;
    std::string why_;  ///< they are no triangulation, where nothing else is at fault
};

}  // namespace

FiniteValidation validate_finite(std::span<const std::array<Index, 3>> faces, StridedSites sites,
                                 const ValidationOptions& options, int numbered_from) {
    return Judge<Plane>({sites}, faces, options, numbered_from).run();
}
FiniteValidation validate_finite(std::span<const std::array<Index, 4>> cells,
                                 std::span<const Point3> sites, const ValidationOptions& options,
                                 int numbered_from) {
    return Judge<Space<Point3>>({sites}, cells, options, numbered_from).run();
}
FiniteValidation validate_finite(std::span<const std::array<Index, 4>> cells,
                                 std::span<const Site3> sites, const ValidationOptions& options,
                                 int numbered_from) {
    return Judge<Space<Site3>>({sites}, cells, options, numbered_from).run();
}
FiniteValidation validate_finite(std::span<const std::array<Index, 4>> cells,
                                 std::span<const power::Site3> sites,
                                 const ValidationOptions& options, int numbered_from) {
    return Judge<Space<power::Site3>>({sites}, cells, options, numbered_from).run();
}

}  // namespace signum
