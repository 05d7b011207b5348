#pragma once
/// From the Delaunay triangulation of the centres to the power triangulation, by flips. For sources
/// only.
///
/// All weights grow together, from 0 to what they are (growth_order.hpp). Taken in the order of the
/// times at which edges stop being regular every event is a flip that can be made: two faces
/// against two, where their four corners are in convex position, or three against one, where a site
/// of degree 3 sinks below the face that is left. A site once hidden stays hidden: its height above
/// the others is convex in t. Of equal centres the first in the tie rule's order stands for all.
///
/// Three centres on a line are the one position that no infinitesimal resolves: a site between two
/// neighbours sinks while it has four edges. There a flip may leave a face without area, which the
/// event of the same time takes away.
///
/// In first-come order (Order::of_discovery) an edge may not be flippable: an obstruction.
/// Source: thesis, chapter 6 (Algorithm 6.5.1 is the order of discovery); the order of t is that of
/// Edelsbrunner and Shah's incremental flips, applied to one parameter for all sites.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "../../core/index.hpp"
#include "../options.hpp"
#include "../structure/flip.hpp"
#include "../structure/topology.hpp"
#include "event_queue.hpp"
#include "growth_order.hpp"

namespace signum::triangulation {

template <class Kernel>
class Inflation {
 public:
    enum class Order { of_time, of_discovery };

    /// The topology is the Delaunay triangulation of the centres of the sites that are not hidden
    /// in hidden_by, not all on one line. The kernel is that of the full weights. Nothing is
    /// copied.
    Inflation(Topology& topology, Kernel& kernel, std::span<Index> hidden_by, Order order)
        : topology_(topology),
          kernel_(kernel),
          hidden_by_(hidden_by),
          order_(order),
          growth_(kernel),
          degree_(hidden_by.size(), 0),
          events_(4 * topology.room(), growth_) {
        for (Index f = 0; f < topology_.faces(); ++f) {
            if (topology_.is_vacant(f)) continue;
            for (const Index v : topology_.vertices(f))
                if (v != infinite) ++degree(v);
        }
    }

    /// Flips until every edge is regular, and calls watch with the number of flips; false where an
    /// edge cannot be flipped, which in the order of time never happens.
    template <class Watch>
    [[nodiscard]] bool run(const Watch& watch) {
        for (Index f = 0; f < topology_.faces(); ++f)
            if (!topology_.is_vacant(f))
                for (HalfEdge h = Topology::first_edge(f); h < Topology::first_edge(f) + 3; ++h)
                    if (h < topology_.twin(h)) push(h);
        while (!events_.empty()) {
            const HalfEdge edge = events_.pop().subject;
            if (!make_regular(edge)) {
                // Waits for another flip of the same time.
                blocked_.push_back(edge);
                continue;
            }
            ++flips_;
            for (const HalfEdge h : blocked_)
                if (!topology_.is_vacant(Topology::face(h))) push(h);
            blocked_.clear();
            watch(flips_);
        }
        if (!blocked_.empty()) return obstructed(blocked_.front());
        // A face without area, left behind by a flip that came too early.
        for (Index f = 0; f < topology_.faces(); ++f)
            if (!topology_.is_vacant(f) && !topology_.is_infinite(f) && is_flat(f))
                return obstructed(Topology::first_edge(f));
        return true;
    }

    [[nodiscard]] std::uint64_t flips() const noexcept { return flips_; }
    /// The edge that could not be flipped.
    [[nodiscard]] std::array<Index, 2> obstruction() const noexcept { return obstruction_; }

 private:
    [[nodiscard]] bool obstructed(HalfEdge h) {
        obstruction_ = {topology_.origin(h), topology_.target(h)};
        return false;
    }
    [[nodiscard]] bool is_flat(Index f) {
        const auto& v = topology_.vertices(f);
        return kernel_.ccw(v[0], v[1], v[2]) == 0;
    }

    /// The edge's four sites where it is not regular in the end.
    [[nodiscard]] std::optional<Quad> failing(HalfEdge h) {
        const auto [b, c, a, d] = topology_.about(h);
        if (a == d || a == infinite || d == infinite) return std::nullopt;
        if (b == infinite || c == infinite) {
            const Index middle = b == infinite ? c : b;
            if (kernel_.ccw(a, middle, d) != 0 || kernel_.conflicts_on_line(a, d, middle))
                return std::nullopt;
            return Quad{{a, middle, d, middle}, true};
        }
        // The circle is that of a face with an area.
        if (kernel_.ccw(a, b, c) > 0) {
            if (!kernel_.conflicts(a, b, c, d)) return std::nullopt;
            return Quad{{a, b, c, d}, false};
        }
        if (kernel_.ccw(d, c, b) <= 0 || !kernel_.conflicts(d, c, b, a)) return std::nullopt;
        return Quad{{d, c, b, a}, false};
    }

    void push(HalfEdge h) {
        const auto quad = failing(h);
        if (!quad) return;
        // In the order of discovery all times are the same.
        events_.set(topology_.edge(h),
                    order_ == Order::of_time ? growth_.failure(*quad) : at_any_time(*quad));
    }
    [[nodiscard]] static Failure at_any_time(const Quad& quad) noexcept {
        return {GrowthOrder<Kernel>::before_all, quad};
    }
    /// The edges of a face that is new.
    void push_edges(Index f) {
        for (HalfEdge h = Topology::first_edge(f); h < Topology::first_edge(f) + 3; ++h) push(h);
    }
    /// The face is about to go, and with it what its edges are called.
    void forget_edges(Index f) {
        for (HalfEdge h = Topology::first_edge(f); h < Topology::first_edge(f) + 3; ++h)
            events_.erase(topology_.edge(h));
    }

    /// Degrees of sites; that of infinity is nobody's concern.
    [[nodiscard]] Index& degree(Index v) { return degree_[static_cast<std::size_t>(v)]; }
    void change_degree(Index v, Index by) {
        if (v != infinite) degree(v) += by;
    }

    /// Flips the edge, or takes away one of its ends; false where neither can be done.
    bool make_regular(HalfEdge h) {
        const HalfEdge t = topology_.twin(h);
        const auto [b, c, a, d] = topology_.about(h);
        if (b != infinite && degree(b) == 3) return hide(h);
        if (c != infinite && degree(c) == 3) return hide(t);
        // The new faces are a, b, d and d, c, a. At infinity the three are on one line.
        const bool is_convex = b == infinite || c == infinite ||
                               (kernel_.ccw(a, b, d) >= 0 && kernel_.ccw(d, c, a) >= 0);
        if (!is_convex || a == d) return false;
        const Index f = Topology::face(h);
        const Index g = Topology::face(t);
        forget_edges(f);
        forget_edges(g);
        flip(topology_, h);
        for (const Index v : {a, d}) change_degree(v, 1);
        for (const Index v : {b, c}) change_degree(v, -1);
        push_edges(g);
        push(Topology::first_edge(f));
        push(Topology::first_edge(f) + 1);
        return true;
    }

    /// The origin of h, which has degree 3, sinks below the face that is left.
    bool hide(HalfEdge h) {
        const Index v = topology_.origin(h);
        const Index f = Topology::face(h);
        for (const HalfEdge spoke : topology_.fan(h)) forget_edges(Topology::face(spoke));
        remove_vertex(topology_, h);
        const auto& corners = topology_.vertices(f);
        for (const Index u : corners) change_degree(u, -1);
        hidden_by_[static_cast<std::size_t>(v)] = corners[0] != infinite ? corners[0] : corners[1];
        push_edges(f);
        return true;
    }

    Topology& topology_;
    Kernel& kernel_;
    std::span<Index> hidden_by_;
    Order order_;
    GrowthOrder<Kernel> growth_;
    std::vector<Index> degree_;
    EventQueue<Failure, GrowthOrder<Kernel>> events_;
    std::uint64_t flips_ = 0;
    std::vector<HalfEdge> blocked_;
    std::array<Index, 2> obstruction_ = {infinite, infinite};
};

}  // namespace signum::triangulation
