#pragma once
/// A tessellation from those of parts of its sites, which several threads build.
///
/// Sites are cut in two, and these in two, as often as makes work for all; each leaf is built by
/// insertion, and two parts side by side are joined. Let B be the sites of both which sites beyond
/// the cut may reach (reach.hpp), N their neighbours, and T(B+N) the tessellation of these alone.
/// The others, N too, are *settled*.
///
/// Theorem. The faces of the whole are those of the parts whose sites are all settled, and those of
/// T(B+N) that have a site of B.
///
///  1. The star of a settled site in its part is its star in the whole: no site beyond the cut
///     comes as near to a point of its closed cell.
///  2. The star of a site s of B that is visible in the whole is that in T(B+N). For a neighbour t
///     of s in the whole is in B, or settled; then by 1 they are neighbours in their part, and t is
///     in N. So T(B+N) has all neighbours of s, and a cell is what its neighbours leave of the
///     plane.
///  3. A site q of B that is hidden in the whole is hidden in T(B+N). Where weights are additive,
///     the site of the other part that is nearest to q's centre hides it, and is in B, as are all
///     whose cells hold a point beyond the cut. In the power metric suppose that q has a point p in
///     T(B+N), and so in its part, for q's neighbours there are in B+N. In the whole p is in the
///     cell of a site of the other part that is in neither B nor N, and so has no neighbour in B.
///     Go from p towards q's side, at a right angle to the cut, through the cells of that other
///     part. At the end q is nearer than all of its sites, and takes points of the last cell, whose
///     site is in B. So the way leads through a cell of N. There q is not nearer than that site,
///     which is settled; at p it was; but on the way it has gained on all sites of that part.
///
/// A face of the first kind and one of the second meet in an edge between two settled sites. In the
/// part there is the face across that edge, by 1 the same three sites; so these and the direction
/// of the edge tell which faces meet: an oriented triple of sites has one face at most. T(B+N) need
/// not have an end of its edge there: between two curved edges of the same sites lie others, which
/// it may not know. Where no face that stays is across, T(B+N) has the edge as it is, for a face of
/// its own ends it there.
///
/// It helps where few sites are not settled. Where half of them are not (all on one circle, or
/// around one giant), a part is not joined but handed on as sites to be inserted, in the end by one
/// thread.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "../../core/large_array.hpp"
#include "../../core/parallel.hpp"
#include "../../exact/floating_environment.hpp"
#include "../insertion/insert_all.hpp"
#include "../structure/spatial_order.hpp"
#include "joining.hpp"
#include "plan.hpp"
#include "reach.hpp"

namespace signum::triangulation {

/// Kernel: without a tally. Sites are named by their places in plan.numbers. Reach: PowerReach or
/// AdditiveReach.
template <class Kernel, class Reach>
class PartsConstruction {
 public:
    /// Nothing is copied.
    PartsConstruction(const Plan& plan, const Workers& workers, Kernel& kernel, const Reach& reach,
                      std::span<Index> hidden_by, std::uint64_t seed, const Watch& watch)
        : plan_(plan),
          workers_(workers),
          kernel_(kernel),
          reach_(reach),
          hidden_by_(hidden_by),
          seed_(seed),
          watch_(watch),
          marks_(made<std::uint8_t>(workers, hidden_by.size(),
                                    [](std::size_t) { return is_elsewhere; })) {}

    /// Fills a structure with room for all sites. False, and it has no faces, where the sites have
    /// no structure (insert_all.hpp) or nothing is gained by parts; hidden_by then says who is
    /// hidden so far.
    /// `share`: parts are joined where one of so many of their visible sites, or fewer, are to be
    /// inserted anew.
    [[nodiscard]] bool run(Topology& topology, std::size_t share = 2) {
        topology_ = &topology;
        share_ = share;
        topology.use_all();
        boxes_ = boxes_of<2>(plan_, workers_, [this](std::size_t leaf) { return box_of(leaf); });
        Part whole;
        watch_.guard_all([&] {
            whole = triangulation::built<Part>(
                plan_, workers_, watch_, [this](std::size_t number) { return leaf(number); },
                [this](std::array<Part, 2>& parts, std::size_t k) { return join(parts, k); });
        });
        if (!whole.loose.empty()) return false;
        for (const Index f : whole.vacant) topology.vacate(f);
        return true;
    }

 private:
    /// A part that is built.
    struct Part {
        std::size_t first = 0;  ///< its sites, by place
        std::size_t last = 0;
        std::size_t visible = 0;    ///< how many of them are
        Index outer = -1;           ///< a face at infinity; -1 where there are no faces, and then
        std::vector<Index> loose;   ///< its visible sites
        std::vector<Index> vacant;  ///< room for faces
    };
    /// The mark of a face that a joining takes out.
    static constexpr Index goes = 1;
    /// What a joining knows of a site.
    enum Mark : std::uint8_t { is_elsewhere, is_reached, is_neighbour };

    [[nodiscard]] std::uint8_t& mark(Index v) noexcept {
        return marks_[static_cast<std::size_t>(v)];
    }

    [[nodiscard]] bool is_visible(Index v) const noexcept {
        return hidden_by_[static_cast<std::size_t>(v)] < 0;
    }
    [[nodiscard]] std::size_t count_visible(std::span<const Index> sites) const {
        return static_cast<std::size_t>(
            std::ranges::count_if(sites, [this](Index v) { return is_visible(v); }));
    }

    [[nodiscard]] Box<2> box_of(std::size_t leaf) const {
        Box<2> box;
        for (std::size_t i = plan_.begins[leaf]; i < plan_.begins[leaf + 1]; ++i) {
            const Point p = kernel_.centre(static_cast<Index>(i));
            box.include({{p.x, p.y}, {p.x, p.y}, reach_.third(static_cast<Index>(i))});
        }
        return box;
    }

    [[nodiscard]] Part leaf(std::size_t number) {
        Part part;
        part.first = plan_.begins[number];
        part.last = plan_.begins[number + 1];
        LargeArray<Index> sites(part.last - part.first);
        std::iota(sites.begin(), sites.end(), static_cast<Index>(part.first));
        Topology window = topology_->window(2 * part.first, sites.size());
        if (!insert_all(window, kernel_, hidden_by_, sites, watch_)) {
            give_up(part);
            return part;
        }
        for (Index f = window.faces(); f < slot(part.last) - 2; ++f) topology_->vacate(f);
        part.visible = count_visible(sites);
        part.outer = slot(part.first);
        while (topology_->is_vacant(part.outer) || !topology_->is_infinite(part.outer))
            ++part.outer;
        return part;
    }
    /// Where the room for the faces of the sites from here on begins.
    [[nodiscard]] static Index slot(std::size_t site) noexcept {
        return static_cast<Index>(2 * site);
    }

    /// The part has no faces: its visible sites are to be inserted.
    void give_up(Part& part) {
        part.outer = -1;
        part.vacant.clear();
        for (Index f = slot(part.first); f < slot(part.last) - 2; ++f) {
            topology_->vacate(f);
            part.vacant.push_back(f);
        }
        part.loose.clear();
        for (auto i = static_cast<Index>(part.first); i < static_cast<Index>(part.last); ++i)
            if (is_visible(i)) part.loose.push_back(i);
        part.visible = part.loose.size();
    }

    /// The parts below and above the cut of node k.
    [[nodiscard]] Part join(std::array<Part, 2>& parts, std::size_t k) {
        auto& [below, above] = parts;
        if (below.first == below.last) return std::move(above);
        if (above.first == above.last) return std::move(below);
        Part joined;
        joined.first = below.first;
        joined.last = above.last;
        joined.vacant = {slot(below.last) - 2, slot(below.last) - 1};
        for (const Part& part : parts)
            joined.vacant.insert(joined.vacant.end(), part.vacant.begin(), part.vacant.end());

        // B first, then N; and the faces at B, which go.
        std::vector<Index> sites;
        std::vector<Index> going;
        for (std::size_t side = 0; side < 2; ++side)
            find_reached(
                parts[side],
                {plan_.cuts[k].axis, side == 0, boxes_[2 * k + 1 + side], boxes_[2 * k + 2 - side]},
                sites, going);
        for (const Index f : going)
            for (const Index v : topology_->vertices(f)) {
                if (v < 0 || mark(v) != is_elsewhere) continue;
                mark(v) = is_neighbour;
                sites.push_back(v);
            }

        joined.visible = below.visible + above.visible;
        if (share_ * sites.size() <= joined.visible) {
            Topology patch(sites.size());
            order_spatially(view_of(std::span(&kernel_.site(0), hidden_by_.size())), sites, seed_);
            if (insert_all(patch, kernel_, hidden_by_, sites, watch_))
                replace(going, patch, joined);
            joined.visible -= sites.size() - count_visible(sites);
        }
        for (const Index v : sites) mark(v) = is_elsewhere;
        if (joined.outer < 0) give_up(joined);
        return joined;
    }

    /// Finds the sites of a part that may be reached from beyond a cut, all that have no faces
    /// among them, and the faces at them: from the faces around infinity on, from site to site by
    /// faces that may be reached (reach.hpp).
    void find_reached(const Part& part, const Crossing& crossing, std::vector<Index>& sites,
                      std::vector<Index>& faces) {
        struct Reached {
            Index site;
            Index face;  // one of those at the site
        };
        std::vector<Reached> reached;
        const auto take = [&](Index v, Index f) {
            if (v < 0 || mark(v) == is_reached) return;
            mark(v) = is_reached;
            sites.push_back(v);
            reached.push_back({v, f});
        };
        for (const Index v : part.loose) take(v, -1);
        if (part.outer < 0) return;
        const auto look_at = [&](Index f) {
            const auto& v = topology_->vertices(f);
            if (reach_.may_be_reached({v[0], v[1], v[2]}, crossing))
                for (const Index each : v) take(each, f);
        };
        for (const HalfEdge h : topology_->fan(topology_->spoke(part.outer, infinite)))
            look_at(Topology::face(h));
        for (std::size_t i = 0; i < reached.size(); ++i) {
            const auto [site, face] = reached[i];
            for (const HalfEdge h : topology_->fan(topology_->spoke(face, site))) {
                const Index f = Topology::face(h);
                if (topology_->record(f).mark == goes) continue;
                topology_->record(f).mark = goes;
                faces.push_back(f);
                look_at(f);
            }
        }
    }

    /// An edge between two settled sites, u and v, and a site x of B: the half-edge u -> v of a
    /// face that stays, across which x is.
    struct Seam {
        Index u;
        Index v;
        Index x;
        HalfEdge edge;
        [[nodiscard]] auto key() const noexcept { return std::array{u, v, x}; }
    };
    /// Puts the faces of the patch that have a site of B in the place of those that go.
    void replace(const std::vector<Index>& going, const Topology& patch, Part& joined) {
        std::vector<Seam> outer;
        for (const Index f : going)
            for (unsigned k = 0; k < 3; ++k) {
                const HalfEdge h = topology_->twin(Topology::first_edge(f) + k);
                if (topology_->record(Topology::face(h)).mark == goes) continue;
                outer.push_back({topology_->origin(h), topology_->target(h),
                                 topology_->apex(topology_->twin(h)), h});
            }
        for (const Index f : going) topology_->vacate(f);
        joined.vacant.insert(joined.vacant.end(), going.begin(), going.end());

        std::ranges::sort(outer, {}, &Seam::key);
        const auto is_settled = [&](Index v) { return v < 0 || mark(v) != is_reached; };
        constexpr Index is_left_out = -1;
        std::vector<Index> place(static_cast<std::size_t>(patch.faces()), is_left_out);
        const auto place_of = [&](Index f) -> Index& { return place[static_cast<std::size_t>(f)]; };
        for (Index f = 0; f < patch.faces(); ++f) {
            if (patch.is_vacant(f) || std::ranges::all_of(patch.vertices(f), is_settled)) continue;
            if (joined.vacant.empty()) throw_no_fit();
            place_of(f) = joined.vacant.back();
            joined.vacant.pop_back();
        }
        std::size_t met = 0;
        for (Index f = 0; f < patch.faces(); ++f) {
            const Index to = place_of(f);
            if (to == is_left_out) continue;
            topology_->record(to) = patch.record(f);
            for (unsigned k = 0; k < 3; ++k) {
                const HalfEdge h = Topology::first_edge(f) + k;
                const HalfEdge own = Topology::first_edge(to) + k;
                if (is_settled(patch.origin(h)) && is_settled(patch.target(h))) {
                    const Seam seam = {patch.target(h), patch.origin(h), patch.apex(h), own};
                    const auto found = std::ranges::lower_bound(outer, seam.key(), {}, &Seam::key);
                    if (found != outer.end() && found->key() == seam.key()) {
                        topology_->glue(found->edge, own);
                        ++met;
                        continue;
                    }
                }
                const HalfEdge twin = patch.twin(h);
                const Index across = place_of(Topology::face(twin));
                if (across == is_left_out) throw_no_fit();
                topology_->record(to).twin[k] = Topology::first_edge(across) + (twin & 3);
            }
        }
        if (met != outer.size()) throw_no_fit();
        for (const Index to : place)
            if (to != is_left_out && topology_->is_infinite(to)) joined.outer = to;
    }
    [[noreturn]] static void throw_no_fit() {
        throw std::logic_error("two parts of a tessellation do not fit together");
    }

    Topology* topology_ = nullptr;
    std::size_t share_ = 2;
    const Plan& plan_;
    const Workers& workers_;
    Kernel& kernel_;
    const Reach& reach_;
    std::span<Index> hidden_by_;
    std::uint64_t seed_;
    const Watch& watch_;
    LargeArray<std::uint8_t> marks_;  // of the sites
    std::vector<Box<2>> boxes_;       // around the sites of each node
};

}  // namespace signum::triangulation
