#pragma once
/// Insertion of sites, one after the other: find a cell in conflict, all others around it, and join
/// the boundary of these to the site.
///
/// A site is hidden where the cell in which its centre lies is in no conflict. Of those in conflict
/// whatever vertex is on no facet of the boundary becomes hidden.
///
/// A cell with the vertex at infinity is in conflict with a site that lies beyond its facet's
/// plane. In the plane of the facet it is where the finite cell behind the facet is, under the tie
/// rule, too: there the sphere of that cell and the circle of the facet are one, and the fourth
/// vertex has the coefficient 0.
///
/// Arithmetic that rounds may tell of regions that are no balls. What then could not be joined, or
/// walked through to an end, is BrokenStructure; exact kernels are not asked for that.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "../../core/large_array.hpp"
#include "../options.hpp"
#include "cells.hpp"
#include "kernel.hpp"
#include "orthospheres.hpp"

namespace signum::spatial {

template <class Kernel>
class Insertion {
 public:
    /// The first four sites turn positively. `sites`: how many there will be.
    Insertion(Kernel& kernel, const Frame& frame, std::size_t sites)
        : kernel_(kernel), frame_(frame), seen_(sites + 1, 0) {
        cells_.reserve(7 * sites + 64);
        spheres_.reserve(7 * sites + 64);
        // A cell and those across its facets, which have the vertex at infinity.
        constexpr std::array<Index, 4> first = {0, 1, 2, 3};
        constexpr Index inner = 0;
        std::array<Index, 5> made;
        cells_.add(made);
        cells_.vertex(inner) = first;
        cells_.neighbour(inner) = {1, 2, 3, 4};
        for (std::size_t k = 0; k < 4; ++k) {
            Four outer = first;
            outer[k] = infinite;
            // Seen from beyond the facet the other three turn the other way.
            std::swap(outer[(k + 1) % 4], outer[(k + 2) % 4]);
            Four neighbours;
            for (std::size_t m = 0; m < 4; ++m)
                neighbours[m] = outer[m] == infinite ? inner : outer[m] + 1;
            cells_.vertex(made[k + 1]) = outer;
            cells_.neighbour(made[k + 1]) = neighbours;
        }
        spheres_.assign(cells_.size(), unknown_sphere);
    }

    /// `hidden(v, near)` tells of each that is hidden now, by the site or as the site itself, and
    /// of one nearby: who hides it, or the nearest vertex where it would have been.
    template <class Hidden>
    void insert(Index q, const Hidden& hidden) {
        look_from(q);
        site_ = in_frame(kernel_.at(q), frame_);
        if (!is_in(frame_, site_)) [[unlikely]]
            site_.fill(std::numeric_limits<double>::quiet_NaN());
        const SphereTest test(site_, frame_);
        Index home = descend(test);
        if (home == unset) {
            home = locate(q);
            for (const Index v : cells_.vertex(home)) static_cast<void>(see(v));
            kernel_.set_bound();
            if (!conflicts(home, kernel_.in_sphere(seen_of(home)), kernel_.bound()))
                return hidden(q, nearest_of(home));
        }
        find_region(home, test);
        find_hidden([&](Index v) { hidden(v, q); });
        join(q);
    }

    /// How many sites there will be, after all. Those that lie outside the frame, or weigh more,
    /// are judged without spheres.
    void expect(std::size_t sites) { seen_.resize(sites + 1, 0); }
    [[nodiscard]] const Cells& cells() const noexcept { return cells_; }

    /// The cells, and memory for as many fours, in which their spheres were.
    struct Built {
        Cells cells;
        std::vector<Four> room;
    };
    [[nodiscard]] Built release() && noexcept { return {std::move(cells_), std::move(spheres_)}; }

 private:
    /// A cell that is in conflict, as its sphere tells; unset where no sphere does. From cell to
    /// cell, always to the neighbour of which the sphere is the nearest: across a facet toward the
    /// site, for the points that are as far from two spheres as from one another lie in its plane.
    [[nodiscard]] Index descend(const SphereTest& test) noexcept {
        const Orthosphere* const spheres = spheres_.data();
        std::array<std::int32_t, 4> distances;
        const auto nearest = [&] {
            return std::min(std::min(distances[0], distances[1]),
                            std::min(distances[2], distances[3]));
        };
        for (std::int32_t before = std::numeric_limits<std::int32_t>::max();;) {
            const auto& [a, b, c, d] = cells_.neighbour(last_);
            test.distances(spheres[a], spheres[b], spheres[c], spheres[d], distances);
            const std::int32_t now = nearest();
            if (now >= before) return unset;
            last_ = cells_.neighbour(last_)[now & 3];
            if (now < 0) return last_;
            before = now;
        }
    }
    /// The cell in which a site's centre lies, or one with the vertex at infinity that is in
    /// conflict with it. A walk: across any facet that has the site on its other side. To ask them
    /// in a random order keeps it from going around in rounded arithmetic; an exact one ends
    /// anyway, for what the tie rule chooses is regular.
    [[nodiscard]] Index locate(Index q) noexcept(Kernel::is_exact) {
        Index c = last_;
        if (const std::size_t infinity = cells_.place_of_infinity(c); infinity < 4)
            c = cells_.neighbour(c)[infinity];
        Index from = unset;
        for (std::size_t step = 0;; ++step) {
            if constexpr (!Kernel::is_exact) {
                if (step > cells_.size())
                    throw BrokenStructure("the walk to a site went in circles");
            }
            const Four& neighbour = cells_.neighbour(c);
            random_ = random_ * 1664525U + 1013904223U;
            const std::size_t first = random_ >> 30;
            std::size_t k = 0;
            for (; k < 4; ++k) {
                const std::size_t place = (first + k) & 3U;
                if (neighbour[place] == from || side(cells_.vertex(c), place, q) >= 0) continue;
                from = c;
                c = neighbour[place];
                break;
            }
            if (k == 4 || cells_.place_of_infinity(c) < 4) return last_ = c;
        }
    }

    /// A cell in conflict: what is left of it.
    struct Taken {
        Four neighbour;
        std::array<Seen, 4> vertex;  // once it has been looked beyond
        Index cell;
        std::uint32_t apex;  // the place of the vertex that the one before it does not have
    };

    [[nodiscard]] Sign side(Four v, std::size_t place, Index q) const noexcept {
        v[place] = q;
        return kernel_.ccw(v[0], v[1], v[2], v[3]);
    }

    // ---- what the site sees --------------------------------------------------------------------

    void look_from(Index q) {
        // Numbers of vertices of earlier insertions are below the base.
        constexpr std::size_t enough = std::size_t{1} << 31;
        base_ += kernel_.count();
        if (base_ > enough) [[unlikely]] {
            std::ranges::fill(seen_, 0);
            base_ = 1;
        }
        seen_[0] = static_cast<Seen>(base_) + seen_infinity;
        kernel_.look_from(q);
    }
    /// Without a branch, for nobody could foretell it.
    [[nodiscard]] Seen see(Index v) noexcept {
        Seen& known = seen_[static_cast<std::size_t>(v + 1)];
        const std::size_t count = kernel_.count();
        // Below the base it wraps around.
        const std::size_t number = known - base_;
        const bool is_new = number >= count;
        const std::size_t result = is_new ? count : number;
        known = static_cast<Seen>(base_ + result);
        kernel_.see(v, is_new);
        return static_cast<Seen>(result);
    }
    /// The vertices of a cell, all of which have been seen.
    [[nodiscard]] std::array<Seen, 4> seen_of(Index c) const noexcept {
        const Four& v = cells_.vertex(c);
        const Seen* const seen = seen_.data();
        const auto base = static_cast<Seen>(base_);
        const auto number = [=](Index each) { return seen[each + 1] - base; };
        return {number(v[0]), number(v[1]), number(v[2]), number(v[3])};
    }
    /// The vertex that is nearest to the site, as rounded heights have it.
    [[nodiscard]] Index nearest_of(Index c) const noexcept {
        const std::array<Seen, 4> seen = seen_of(c);
        Seen nearest = seen_infinity;
        for (const Seen v : seen)
            if (v != seen_infinity &&
                (nearest == seen_infinity || kernel_.row(v).lift < kernel_.row(nearest).lift))
                nearest = v;
        return kernel_.name(nearest);
    }
    /// Whether a cell is in conflict, of which the determinant is known.
    [[nodiscard]] bool conflicts(Index c, double determinant, double bound) {
        if (filters::magnitude(determinant) > bound) [[likely]]
            return determinant > 0.0;
        return conflicts_closely(c, determinant, bound);
    }
    [[nodiscard, gnu::noinline]] bool conflicts_closely(Index c, double determinant, double error) {
        const std::size_t place = cells_.place_of_infinity(c);
        if (place == 4) return kernel_.conflicts(seen_of(c), determinant, error);
        const auto& facet = facet_of[place];
        const std::array<Seen, 4> v = seen_of(c);
        const Sign sign = kernel_.side(v[facet[0]], v[facet[1]], v[facet[2]]);
        if (sign != 0) return sign > 0;
        const Index behind = cells_.neighbour(c)[place];
        if (is_taken(behind)) return true;
        if (!Kernel::is_exact && cells_.place_of_infinity(behind) < 4) return false;
        for (const Index each : cells_.vertex(behind)) static_cast<void>(see(each));
        kernel_.set_bound();
        return conflicts(behind, kernel_.in_sphere(seen_of(behind)), kernel_.bound());
    }

    // ---- the region of conflict ----------------------------------------------------------------

    [[nodiscard]] bool is_taken(Index c) const noexcept {
        return sphere_of(c)[3] == orthospheres::taken;
    }
    void find_region(Index home, const SphereTest& test) {
        taken_ = 1;
        facets_ = vertices_ = 0;
        region_[0] = {cells_.neighbour(home), {}, home, 0};
        sphere_of(home) = taken_sphere;
        for (const Index v : cells_.vertex(home)) count_in_region(see(v));
        for (std::size_t next = 0; next < taken_; ++next) {
            make_room();
            look_beyond(region_[next], test);
        }
    }
    /// For all that may lie beyond the facets of a cell.
    void make_room() {
        if (taken_ + 4 > region_.size()) [[unlikely]]
            region_.resize(2 * region_.size());
        if (facets_ + 4 > boundary_.size()) [[unlikely]] {
            boundary_.resize(2 * boundary_.size());
            outer_.resize(boundary_.size());
        }
        constexpr std::size_t vertices = 32;
        kernel_.make_room(vertices);
        if (kernel_.count() + vertices > in_region_.size()) [[unlikely]]
            in_region_.resize(2 * (kernel_.count() + vertices), -1);
    }
    void count_in_region(Seen v) noexcept {
        vertices_ +=
            static_cast<std::size_t>(std::exchange(in_region_[v], kernel_.eye()) != kernel_.eye());
    }
    /// The cells beyond the facets of one: judged by their spheres, and where these tell nothing by
    /// their vertices. Without a branch, for nobody could foretell it: what follows the last facet
    /// and the last cell is written, and then counted or not.
    void look_beyond(Taken& from, const SphereTest& test) {
        const Index cell = from.cell;
        count_in_region(see(cells_.vertex(cell)[from.apex]));
        from.vertex = seen_of(cell);
        Orthosphere* const spheres = spheres_.data();
        const Four beyond = from.neighbour;
        const auto& [a, b, c, d] = beyond;
        std::array<Told, 4> told;
        if (!test(spheres[a], spheres[b], spheres[c], spheres[d], told)) [[unlikely]]
            judge(from, told);
        const std::array<Seen, 4> vertex = from.vertex;
        std::size_t facets = facets_;
        std::size_t taken = taken_;
        Orthosphere nobody;
#pragma GCC unroll 4
        for (std::size_t k = 0; k < 4; ++k) {
            const Index n = beyond[k];
            const Four neighbour = cells_.neighbour(n);
            const auto place = static_cast<std::uint32_t>(place_of(cell, neighbour));
            const auto& facet = facet_of[k];
            boundary_[facets] = {{vertex[facet[0]], vertex[facet[1]], vertex[facet[2]]}, place};
            outer_[facets] = n;
            facets += static_cast<std::size_t>(told[k] == Told::none);
            Taken& next = region_[taken];
            next.neighbour = neighbour;
            next.cell = n;
            next.apex = place;
            bool is_taken_now = told[k] == Told::conflict;
            // A broken structure may have the same cell beyond two facets.
            if constexpr (!Kernel::is_exact) is_taken_now = is_taken_now && !is_taken(n);
            taken += static_cast<std::size_t>(is_taken_now);
            Orthosphere* const marked = is_taken_now ? &spheres[n] : &nobody;
            (*marked)[3] = orthospheres::taken;
        }
        facets_ = facets;
        taken_ = taken;
        // The last two, of which most are new.
        for (const std::size_t last : {taken - 1, std::max(taken, std::size_t{2}) - 2})
            for (const Index n : region_[last].neighbour) {
                __builtin_prefetch(&spheres[n]);
                cells_.prefetch(n);
            }
    }
    /// By determinants, four at once.
    [[gnu::noinline]] void judge(const Taken& from, std::array<Told, 4>& told) {
        std::array<Seen, 4> apex = from.vertex;
        for (std::size_t k = 0; k < 4; ++k) {
            const Index n = from.neighbour[k];
            if (told[k] == Told::nothing)
                apex[k] = see(cells_.vertex(n)[place_of(from.cell, cells_.neighbour(n))]);
        }
        kernel_.set_bound();
        std::array<double, 4> determinants;
        double bound = kernel_.in_spheres(from.vertex, apex, determinants);
        if constexpr (Kernel::is_exact) {
            bool are_certain = true;
            for (std::size_t k = 0; k < 4; ++k)
                are_certain &=
                    told[k] != Told::nothing || filters::magnitude(determinants[k]) > bound;
            if (!are_certain && bound > 0.0)
                bound = kernel_.refine(from.vertex, apex, determinants);
        }
        for (std::size_t k = 0; k < 4; ++k)
            if (told[k] == Told::nothing)
                told[k] = conflicts(from.neighbour[k], determinants[k], bound) ? Told::conflict
                                                                               : Told::none;
    }
    /// Vertices of the region that are on no facet of its boundary, a sphere: with half as many
    /// vertices as facets, and two.
    template <class Hidden>
    void find_hidden(const Hidden& hidden) {
        if (2 * vertices_ == facets_ + 4) [[likely]]
            return;
        stays_.assign(kernel_.count(), Stays::no);
        for (std::size_t i = 0; i < facets_; ++i)
            for (const Seen v : boundary_[i].vertex) stays_[v] = Stays::yes;
        for (std::size_t i = 0; i < taken_; ++i)
            for (const Seen v : region_[i].vertex)
                if (stays_[v] == Stays::no) {
                    if (!Kernel::is_exact && v == seen_infinity)
                        throw BrokenStructure("a site lies beyond all facets of the hull");
                    stays_[v] = Stays::yes;
                    hidden(kernel_.name(v));
                }
    }

    // ---- the new cells -------------------------------------------------------------------------

    /// A new cell over each facet of the boundary, the site first, in the places of those in
    /// conflict. Two of them are neighbours across what an edge of the boundary spans with the
    /// site: one of their facets turns along the edge, the other against it.
    void join(Index q) {
        if (!Kernel::is_exact && facets_ == 0) throw BrokenStructure("a site conflicts with all");
        if (made_.size() < facets_) made_.resize(boundary_.size());
        Index* const made = made_.data();
        const std::size_t replaced = std::min(facets_, taken_);
        for (std::size_t i = 0; i < replaced; ++i) made[i] = region_[i].cell;
        for (std::size_t i = replaced; i < taken_; ++i) cells_.remove(region_[i].cell);
        cells_.add(std::span(made + replaced, facets_ - replaced));
        sphere_pages_.grow(spheres_, cells_.size());
        spheres_.resize(cells_.size());
        for (std::size_t i = 0; i < facets_; ++i) {
            const auto& [a, b, c] = boundary_[i].vertex;
            const Index outer = outer_[i];
            cells_.vertex(made[i]) = {q, kernel_.name(a), kernel_.name(b), kernel_.name(c)};
            cells_.neighbour(made[i])[0] = outer;
            cells_.neighbour(outer)[boundary_[i].place] = made[i];
        }
        kernel_.set_bound();
        SphereMaker(kernel_.rows(), site_, frame_, kernel_.reach(), kernel_.height())
            .make(std::span(boundary_.data(), facets_), made, spheres_.data());
        last_ = made[0];
        if (kernel_.count() <= stride)
            link_by_table();
        else
            link_by_sorting();
    }
    [[nodiscard]] Orthosphere& sphere_of(Index c) noexcept {
        return spheres_[static_cast<std::size_t>(c)];
    }
    [[nodiscard]] const Orthosphere& sphere_of(Index c) const noexcept {
        return spheres_[static_cast<std::size_t>(c)];
    }
    void link_by_table() {
        Index* const along = along_.data();
        if constexpr (!Kernel::is_exact) check_edges();
        for (std::size_t i = 0; i < facets_; ++i) {
            const auto& [a, b, c] = boundary_[i].vertex;
            along[b * stride + c] = along[c * stride + a] = along[a * stride + b] = made_[i];
        }
        for (std::size_t i = 0; i < facets_; ++i) {
            const auto& [a, b, c] = boundary_[i].vertex;
            Four& neighbour = cells_.neighbour(made_[i]);
            neighbour[1] = along[c * stride + b];
            neighbour[2] = along[a * stride + c];
            neighbour[3] = along[b * stride + a];
        }
    }
    /// Whether each edge of the boundary lies on two facets that turn alike.
    void check_edges() {
        Index* const along = along_.data();
        const auto for_each_edge = [&](const auto& visit) {
            for (std::size_t i = 0; i < facets_; ++i) {
                const auto& [a, b, c] = boundary_[i].vertex;
                visit(a, b);
                visit(b, c);
                visit(c, a);
            }
        };
        for_each_edge([&](Seen a, Seen b) { along[a * stride + b] = along[b * stride + a] = 0; });
        for_each_edge([&](Seen a, Seen b) { ++along[a * stride + b]; });
        for_each_edge([&](Seen a, Seen b) {
            if (along[a * stride + b] != 1 || along[b * stride + a] != 1) throw_no_sphere();
        });
    }
    [[noreturn]] static void throw_no_sphere() {
        throw BrokenStructure("the conflict region of a site is not a ball");
    }
    void link_by_sorting() {
        edges_.clear();
        for (std::size_t i = 0; i < facets_; ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const Seen a = boundary_[i].vertex[(k + 1) % 3];
                const Seen b = boundary_[i].vertex[(k + 2) % 3];
                edges_.push_back({std::min(a, b), std::max(a, b), made_[i], k + 1});
            }
        std::ranges::sort(edges_, {}, [](const Edge& e) { return std::pair(e.least, e.greatest); });
        for (std::size_t e = 0; e + 1 < edges_.size(); e += 2) {
            const Edge& one = edges_[e];
            const Edge& other = edges_[e + 1];
            if (!Kernel::is_exact && (one.least != other.least || one.greatest != other.greatest ||
                                      edges_.size() % 2 != 0))
                throw_no_sphere();
            cells_.neighbour(one.cell)[one.place] = other.cell;
            cells_.neighbour(other.cell)[other.place] = one.cell;
        }
    }
    struct Edge {
        Seen least;
        Seen greatest;
        Index cell;
        std::size_t place;
    };
    enum class Stays : std::uint8_t { no, yes };

    Kernel& kernel_;
    Frame frame_;
    Cells cells_;
    std::vector<Orthosphere> spheres_;  // of the cells
    PagesAhead sphere_pages_;
    std::array<double, 4> site_{};  // that is inserted, in the frame
    Index last_ = 0;
    std::uint32_t random_ = 1;
    LargeArray<Seen> seen_;  // by vertex, infinity first
    std::size_t base_ = 1;
    static constexpr std::size_t stride = 64;
    // Of one insertion; the arrays are as long as they ever had to be.
    LargeArray<Taken> region_ = LargeArray<Taken>(stride);
    std::size_t taken_ = 0;
    LargeArray<Facet> boundary_ = LargeArray<Facet>(stride);
    LargeArray<Index> outer_ = LargeArray<Index>(stride);  // the cells beyond the facets
    std::size_t facets_ = 0;
    LargeArray<Index> in_region_ = LargeArray<Index>(
        stride, -1);            // the last site that had this vertex, as it saw it, in its region
    std::size_t vertices_ = 0;  // of the region
    LargeArray<Index> made_;
    std::vector<Stays> stays_;
    LargeArray<Index> along_ = LargeArray<Index>(stride * stride);
    std::vector<Edge> edges_;
};

}  // namespace signum::spatial
