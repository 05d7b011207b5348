#include "flip_graph.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace signum {
namespace {

[[noreturn]] void refuse(const char* why) {
    throw std::invalid_argument(why);
}

}  // namespace

ExtendedTessellation::ExtendedTessellation(const TessellationArrays& arrays) : origin_(arrays) {
    origin_.faces.clear();
    origin_.neighbours.clear();
    const std::size_t faces = arrays.faces.size();
    if (arrays.neighbours.size() != faces) refuse("there are as many neighbours as faces");
    corner_.resize(3 * faces);
    twin_.assign(3 * faces, 3 * faces);
    edge_.assign(3 * faces, -1);
    for (std::size_t f = 0; f < faces; ++f)
        for (std::size_t k = 0; k < 3; ++k) corner_[3 * f + k] = arrays.faces[f][k];
    for (Half h = 0; h < corner_.size(); ++h) {
        if (corner_[h] == corner_[next(h)]) refuse("the corners of a face differ");
        if (twin_[h] < corner_.size()) continue;
        const Index g = arrays.neighbours[h / 3][h % 3];
        if (g < 0 || static_cast<std::size_t>(g) >= faces) refuse("a neighbour is no face");
        for (std::size_t k = 0; k < 3; ++k) {
            const Half t = 3 * static_cast<std::size_t>(g) + k;
            if (t == h || twin_[t] < corner_.size() ||
                arrays.neighbours[t / 3][t % 3] != static_cast<Index>(h / 3) ||
                corner_[next(t)] != corner_[previous(h)] ||
                corner_[previous(t)] != corner_[next(h)])
                continue;
            twin_[h] = t;
            twin_[t] = h;
            edge_[h] = edge_[t] = static_cast<Index>(half_of_.size());
            half_of_.push_back(h);
            break;
        }
        if (twin_[h] == corner_.size()) refuse("neighbours do not know each other");
    }
}

Edge ExtendedTessellation::ends(Index e) const {
    const Half h = half_of(e);
    return {corner_[next(h)], corner_[previous(h)]};
}

Edge ExtendedTessellation::corners(Index e) const {
    const Half h = half_of(e);
    return {corner_[h], corner_[twin_[h]]};
}

Face ExtendedTessellation::corners_of(Index f) const {
    const Half h = first_of(f);
    return {corner_[h], corner_[h + 1], corner_[h + 2]};
}

Face ExtendedTessellation::edges_of(Index f) const {
    const Half h = first_of(f);
    return {edge_[h], edge_[h + 1], edge_[h + 2]};
}

bool ExtendedTessellation::can_swap(Index e) const {
    const auto [a, d] = corners(e);
    return a != d;
}

void ExtendedTessellation::put(Half h, Index corner, Half twin, Index edge) noexcept {
    corner_[h] = corner;
    twin_[h] = twin;
    twin_[twin] = h;
    edge_[h] = edge;
    half_of_[static_cast<std::size_t>(edge)] = h;
}

/// Of the faces (a, b, c) and (d, c, b) become (a, b, d) and (d, c, a).
void ExtendedTessellation::swap(Index e) {
    if (!can_swap(e)) refuse("swapping this edge would join a vertex to itself");
    const Half h = half_of(e);
    const Half t = twin_[h];
    const Index a = corner_[h];
    const Index b = corner_[next(h)];
    const Index c = corner_[previous(h)];
    const Index d = corner_[t];
    // What lies across from b, c in the first face, and from c, b in the second. Two of these may
    // be twins, and move together.
    struct Side {
        Half twin;
        Index edge;
    };
    const auto side = [this](Half of) { return Side{twin_[of], edge_[of]}; };
    Side ca = side(next(h));
    Side ab = side(previous(h));
    Side bd = side(next(t));
    Side dc = side(previous(t));
    const auto moved = [&](Half old) -> Half {
        if (old == next(h)) return t;                // c a
        if (old == previous(h)) return previous(h);  // a b
        if (old == next(t)) return h;                // b d
        if (old == previous(t)) return previous(t);  // d c
        return old;
    };
    for (Side* each : {&ca, &ab, &bd, &dc}) each->twin = moved(each->twin);
    put(h, a, bd.twin, bd.edge);
    put(previous(h), d, ab.twin, ab.edge);
    put(t, d, ca.twin, ca.edge);
    put(previous(t), a, dc.twin, dc.edge);
    put(next(h), b, next(t), e);
    put(next(t), c, next(h), e);
}

TessellationArrays ExtendedTessellation::arrays() const {
    TessellationArrays result = origin_;
    const std::size_t faces = corner_.size() / 3;
    std::vector<std::size_t> first(faces);  // of each face the half with the smallest corner
    for (std::size_t f = 0; f < faces; ++f) {
        first[f] = 3 * f;
        for (const Half h : {3 * f + 1, 3 * f + 2})
            if (corner_[h] < corner_[first[f]]) first[f] = h;
    }
    const auto triple = [&](std::size_t f) -> Face {
        const Half h = first[f];
        return {corner_[h], corner_[next(h)], corner_[previous(h)]};
    };
    std::vector<std::size_t> order(faces);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, triple);
    std::vector<Index> place(faces);
    for (std::size_t i = 0; i < faces; ++i) place[order[i]] = static_cast<Index>(i);
    for (const std::size_t f : order) {
        result.faces.push_back(triple(f));
        const Half h = first[f];
        result.neighbours.push_back(
            {place[twin_[h] / 3], place[twin_[next(h)] / 3], place[twin_[previous(h)] / 3]});
    }
    return result;
}

/// Swaps, and remembers them.
///
/// Once infinity z is in every face, the other edges are a tree, and every face (z, b, c) is a step
/// b -> c of a walk around it. Two steps b -> c -> d that are no way back let an edge slide: the
/// swap of the edge between their faces joins b and d, and z returns by swapping b c or c d away.
class SwapPath {
 public:
    using Half = ExtendedTessellation::Half;

    explicit SwapPath(ExtendedTessellation& tessellation)
        : t_(tessellation), sites_(tessellation.corner_) {
        std::ranges::sort(sites_);
        sites_.erase(std::unique(sites_.begin(), sites_.end()), sites_.end());
        if (!sites_.empty()) {
            if (sites_.front() != infinite) refuse("infinity is no vertex");
            sites_.erase(sites_.begin());
        }
        if (t_.corner_.size() != (sites_.empty() ? 0 : 6 * (sites_.size() - 1)))
            refuse("n vertices beside infinity have 2n - 2 faces");
    }

    [[nodiscard]] const std::vector<Index>& sites() const noexcept { return sites_; }
    [[nodiscard]] const std::vector<Index>& swaps() const noexcept { return swaps_; }

    /// Every swap gives infinity an edge more, of 2n - 2.
    void make_tree() {
        std::vector<Half> pending;
        for (Half h = 0; h < t_.corner_.size(); ++h)
            if (t_.corner_[h] == infinite) pending.push_back(h);
        while (!pending.empty()) {
            const Half h = pending.back();
            pending.pop_back();
            if (!t_.can_swap(t_.edge_[h])) continue;
            const Half t = t_.twin_[h];
            swap(t_.edge_[h]);
            pending.push_back(h);
            pending.push_back(ExtendedTessellation::previous(t));
        }
    }

    /// Makes the tree a star around the first site. Precondition: make_tree() was called, and there
    /// are two sites at least.
    void make_star() {
        Half spoke = 0;  // the step from the first site to another one
        while (t_.corner_[spoke] != infinite || begin_of(spoke) != sites_.front()) ++spoke;
        while (star_.size() + 1 < sites_.size()) {
            // Steps b -> x -> first site: b becomes the next one around it.
            for (Half b = before(t_.twin_[spoke]); b != spoke; b = before(t_.twin_[spoke]))
                slide(b, t_.edge_[b]);
            star_.push_back({end_of(spoke), t_.edge_[spoke]});
            spoke = after(t_.twin_[spoke]);
        }
    }

    /// Exchanges the sites at places i and i + 1 of the star.
    void exchange(std::size_t i) {
        Ray& x = star_[i];
        Ray& y = star_[i + 1];
        // ... x -> first -> y ...: y's edge slides to x, and over x to the other side.
        slide(t_.twin_[step_to(x)], y.edge);
        const Half to_x = step_to(x);
        const Index over = t_.edge_[ExtendedTessellation::next(to_x)];
        slide(to_x, t_.edge_[after(to_x)]);
        y.edge = over;
        std::swap(x, y);
    }

    /// Brings the star into the order of another one of the same sites, from the first place on.
    void sort_star(const SwapPath& other) {
        std::map<Index, std::size_t> place;
        for (std::size_t i = 0; i < other.star_.size(); ++i) place[other.star_[i].site] = i;
        for (std::size_t i = 1; i < star_.size(); ++i)
            for (std::size_t k = i; k > 0 && place[star_[k].site] < place[star_[k - 1].site]; --k)
                exchange(k - 1);
    }

    /// The places of the star.
    [[nodiscard]] std::size_t place_of(Index site) const {
        return static_cast<std::size_t>(
            std::ranges::find(star_, site, [](const Ray& ray) { return ray.site; }) -
            star_.begin());
    }

    /// Swaps the edge from the first site to infinity that comes behind place i of the star.
    void swap_behind(std::size_t i) { swap(edges_at(i)[2]); }

    /// At a place of the star: the edges to the site, from it to infinity, and from the first site
    /// to infinity behind it.
    [[nodiscard]] std::array<Index, 3> edges_at(std::size_t i) const {
        const Half to = step_to(star_[i]);
        return {star_[i].edge, t_.edge_[ExtendedTessellation::next(to)],
                t_.edge_[ExtendedTessellation::next(t_.twin_[to])]};
    }
    [[nodiscard]] std::size_t places() const noexcept { return star_.size(); }

 private:
    /// A site of the star and its edge to the first one.
    struct Ray {
        Index site;
        Index edge;
    };

    // A step is the half that lies across from infinity.
    [[nodiscard]] Index begin_of(Half step) const {
        return t_.corner_[ExtendedTessellation::next(step)];
    }
    [[nodiscard]] Index end_of(Half step) const {
        return t_.corner_[ExtendedTessellation::previous(step)];
    }
    [[nodiscard]] Half after(Half step) const {
        return ExtendedTessellation::next(t_.twin_[ExtendedTessellation::next(step)]);
    }
    [[nodiscard]] Half before(Half step) const {
        return ExtendedTessellation::previous(t_.twin_[ExtendedTessellation::previous(step)]);
    }
    [[nodiscard]] Half step_to(const Ray& ray) const {
        const Half h = t_.half_of_[static_cast<std::size_t>(ray.edge)];
        return end_of(h) == ray.site ? h : t_.twin_[h];
    }

    void swap(Index edge) {
        t_.swap(edge);
        swaps_.push_back(edge);
    }
    /// Of the steps b -> c -> d, from the first one on, joins b and d and takes away one edge.
    void slide(Half step, Index away) {
        swap(t_.edge_[ExtendedTessellation::next(step)]);
        swap(away);
    }

    ExtendedTessellation& t_;
    std::vector<Index> sites_;
    std::vector<Index> swaps_;
    std::vector<Ray> star_;
};

std::vector<Index> reduced_form(ExtendedTessellation& tessellation) {
    SwapPath way(tessellation);
    if (way.sites().size() < 3) return {};
    way.make_tree();
    way.make_star();
    // The last site goes behind the second, or in front of it.
    std::size_t last = way.place_of(way.sites().back());
    const std::size_t second = way.place_of(way.sites()[1]);
    for (; last + 1 < second; ++last) way.exchange(last);
    for (; last > second + 1; --last) way.exchange(last - 1);
    way.swap_behind(std::min(last, second));
    return way.swaps();
}

std::vector<Index> path(const TessellationArrays& from, const TessellationArrays& to) {
    ExtendedTessellation first(from);
    ExtendedTessellation second(to);
    SwapPath there(first);
    SwapPath back(second);
    if (there.sites() != back.sites()) refuse("the tessellations have different visible sites");
    if (there.sites().size() < 3) return {};
    for (SwapPath* way : {&there, &back}) {
        way->make_tree();
        way->make_star();
    }
    back.sort_star(there);
    // Both are the same star now, with edges of other numbers.
    std::vector<Index> number(static_cast<std::size_t>(second.edges()));
    for (std::size_t i = 0; i < there.places(); ++i) {
        const std::array<Index, 3> in_first = there.edges_at(i);
        const std::array<Index, 3> in_second = back.edges_at(i);
        for (std::size_t k = 0; k < 3; ++k)
            number[static_cast<std::size_t>(in_second[k])] = in_first[k];
    }
    std::vector<Index> result = there.swaps();
    for (auto swap = back.swaps().rbegin(); swap != back.swaps().rend(); ++swap)
        result.push_back(number[static_cast<std::size_t>(*swap)]);
    return result;
}

TessellationArrays replay(const TessellationArrays& from, std::span<const Index> swaps) {
    ExtendedTessellation tessellation(from);
    for (const Index edge : swaps) tessellation.swap(edge);
    return tessellation.arrays();
}

}  // namespace signum
