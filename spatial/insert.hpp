#pragma once
/// Insertion of sites, one after the other: find the cell in which the centre lies, all cells in
/// conflict around it, and join the boundary of these to the site.
///
/// A site whose own cell is in no conflict is hidden. Of those in conflict whatever vertex is on no
/// facet of the boundary becomes hidden.
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
#include <utility>
#include <vector>

#include "../core/large_array.hpp"
#include "../triangulation/options.hpp"
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
        const Index inner = cells_.add();
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
            const Index made = cells_.add();
            cells_.vertex(made) = outer;
            cells_.neighbour(made) = neighbours;
        }
        spheres_.assign(cells_.size(), unknown_sphere);
    }

    /// `hidden(v, near)` tells of each that is hidden now, by the site or as the site itself, and
    /// of one nearby: who hides it, or the nearest vertex where it would have been.
    template <class Hidden>
    void insert(Index q, const Hidden& hidden) {
        const Index home = locate(q);
        look_from(q);
        for (const Index v : cells_.vertex(home)) static_cast<void>(see(v));
        kernel_.set_bound();
        if (!conflicts(home, kernel_.in_sphere(seen_of(home)), kernel_.bound()))
            return hidden(q, nearest_of(home));
        site_ = in_frame(kernel_.at(q), frame_);
        find_region(home);
        find_hidden([&](Index v) { hidden(v, q); });
        join(q);
    }

    [[nodiscard]] Cells release() && noexcept { return std::move(cells_); }

 private:
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
        Index cell;
        Four neighbour;
        std::array<Seen, 4> vertex;
    };
    /// A facet of the boundary, turning positively seen from the site, and the cell beyond it.
    struct Facet {
        Index outer;
        std::uint32_t place;  // of the facet there
        std::array<Seen, 3> vertex;
    };

    [[nodiscard]] Sign side(Four v, std::size_t place, Index q) const noexcept {
        v[place] = q;
        return kernel_.ccw(v[0], v[1], v[2], v[3]);
    }

    // ---- what the site sees --------------------------------------------------------------------

    void look_from(Index q) {
        // Numbers of vertices of earlier insertions are below the base.
        constexpr std::size_t enough = std::size_t{1} << 31;
        base_ += count_;
        if (base_ > enough) [[unlikely]] {
            std::ranges::fill(seen_, 0);
            base_ = 1;
        }
        seen_[0] = static_cast<Seen>(base_) + seen_infinity;
        count_ = 1;
        kernel_.look_from(q);
    }
    [[nodiscard]] Seen see(Index v) {
        Seen& known = seen_[static_cast<std::size_t>(v + 1)];
        const std::size_t base = base_;
        // Below the base it wraps around.
        if (const std::size_t number = known - base; number < count_)
            return static_cast<Seen>(number);
        known = static_cast<Seen>(base + count_);
        kernel_.see(v);
        return static_cast<Seen>(count_++);
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
        if (cells_.is_free(behind)) return true;
        if (!Kernel::is_exact && cells_.place_of_infinity(behind) < 4) return false;
        for (const Index each : cells_.vertex(behind)) static_cast<void>(see(each));
        kernel_.set_bound();
        return conflicts(behind, kernel_.in_sphere(seen_of(behind)), kernel_.bound());
    }

    // ---- the region of conflict ----------------------------------------------------------------

    /// What is taken is no cell any longer: so it is known to be in conflict.
    void take(Index c) {
        const Four& neighbour = cells_.neighbour(c);
        region_[taken_++] = {c, neighbour, seen_of(c)};
        for (const Index n : neighbour) cells_.prefetch(n);
        for (const Index n : neighbour) __builtin_prefetch(&sphere(n));
        cells_.vertex(c)[0] = Cells::free;
    }
    void find_region(Index home) {
        taken_ = facets_ = vertices_ = 0;
        take(home);
        for (const Seen v : region_[0].vertex) count_in_region(v);
        const SphereTest test(site_, frame_);
        for (std::size_t next = 0; next < taken_; ++next) {
            // Room for all that may lie beyond the facets of one.
            if (taken_ + 4 > region_.size()) region_.resize(2 * region_.size());
            if (facets_ + 4 > boundary_.size()) boundary_.resize(2 * boundary_.size());
            look_beyond(region_[next], test);
        }
    }
    void count_in_region(Seen v) {
        if (in_region_.size() <= v) [[unlikely]]
            in_region_.resize(2 * count_, -1);
        if (std::exchange(in_region_[v], kernel_.eye()) != kernel_.eye()) ++vertices_;
    }
    /// The cells beyond the facets of one: judged by their spheres, and where these tell nothing by
    /// their vertices.
    void look_beyond(const Taken& from, const SphereTest& test) {
        std::array<Told, 4> told;
        const Orthosphere* const spheres = spheres_.data();
        const auto& [a, b, c, d] = from.neighbour;
        test(spheres[a], spheres[b], spheres[c], spheres[d], told);
        if (told[0] == Told::nothing || told[1] == Told::nothing || told[2] == Told::nothing ||
            told[3] == Told::nothing) [[unlikely]]
            judge(from, told);
#pragma GCC unroll 4
        for (std::size_t k = 0; k < 4; ++k) {
            const Index n = from.neighbour[k];
            if (told[k] == Told::none) {
                const auto& facet = facet_of[k];
                boundary_[facets_++] = {
                    n,
                    static_cast<std::uint32_t>(place_of(from.cell, cells_.neighbour(n))),
                    {from.vertex[facet[0]], from.vertex[facet[1]], from.vertex[facet[2]]}};
            } else if (!cells_.is_free(n)) {
                const Seen apex = see(cells_.vertex(n)[place_of(from.cell, cells_.neighbour(n))]);
                take(n);
                count_in_region(apex);
            }
        }
    }
    /// By determinants, four at once.
    [[gnu::noinline]] void judge(const Taken& from, std::array<Told, 4>& told) {
        std::array<Seen, 4> apex = from.vertex;
        for (std::size_t k = 0; k < 4; ++k) {
            const Index n = from.neighbour[k];
            if (told[k] != Told::nothing) continue;
            if (cells_.is_free(n))
                told[k] = Told::conflict;
            else
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
        stays_.assign(count_, Stays::no);
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
        for (std::size_t i = 0; i < facets_; ++i) {
            const Facet& facet = boundary_[i];
            const auto& [a, b, c] = facet.vertex;
            const Index made = i < taken_ ? region_[i].cell : cells_.add();
            made_[i] = made;
            cells_.vertex(made) = {q, kernel_.name(a), kernel_.name(b), kernel_.name(c)};
            cells_.neighbour(made)[0] = facet.outer;
            cells_.neighbour(facet.outer)[facet.place] = made;
        }
        for (std::size_t i = facets_; i < taken_; ++i) {
            cells_.remove(region_[i].cell);
            sphere(region_[i].cell) = unknown_sphere;
        }
        make_spheres();
        last_ = made_[0];
        if (count_ <= stride)
            link_by_table();
        else
            link_by_sorting();
    }
    void make_spheres() {
        spheres_.resize(cells_.size());
        kernel_.set_bound();
        const SphereMaker maker(kernel_.rows(), site_, frame_, kernel_.reach(), kernel_.height());
        std::array<Orthosphere, 4> made;
        for (std::size_t i = 0; i < facets_; i += 4) {
            const auto facet = [&](std::size_t k) {
                return &boundary_[std::min(i + k, facets_ - 1)].vertex;
            };
            maker.make({facet(0), facet(1), facet(2), facet(3)}, made);
            for (std::size_t k = 0; k < 4 && i + k < facets_; ++k) sphere(made_[i + k]) = made[k];
        }
    }
    [[nodiscard]] Orthosphere& sphere(Index c) noexcept {
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
    LargeArray<Orthosphere> spheres_;  // of the cells
    std::array<double, 4> site_{};     // that is inserted, in the frame
    Index last_ = 0;
    std::uint32_t random_ = 1;
    LargeArray<Seen> seen_;  // by vertex, infinity first
    std::size_t base_ = 1;
    std::size_t count_ = 0;
    static constexpr std::size_t stride = 64;
    // Of one insertion; the arrays are as long as they ever had to be.
    LargeArray<Taken> region_ = LargeArray<Taken>(stride);
    std::size_t taken_ = 0;
    LargeArray<Facet> boundary_ = LargeArray<Facet>(stride);
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
