#pragma once
/// From the Delaunay triangulation of the centres to the power triangulation, by flips. For sources
/// only.
///
/// All weights grow together, w(t) = t w, from t = 0 to 1. On the way in_circle of four sites is
/// linear in t: it is D0 < 0 at first, for a face and the site across one of its edges, and D1 at
/// the end. The edge stops being regular in between where D1 > 0, at t = -D0 / (D1 - D0). Taken in
/// that order every event is a flip that can be made: two faces against two, where their four
/// corners are in convex position, or three against one, where a site of degree 3 sinks below the
/// face that is left. A site once hidden stays hidden: its height above the others is convex in t.
/// Of equal centres the first in the tie rule's order stands for all.
///
/// Ties. Every weight is thought of as reduced by its own infinitesimal all the time, as the tie
/// rule wants it at the end. Both D0 and D1 gain the same sum P of infinitesimals, and of events at
/// the same time those come first for which the terms of first order say so. Before time 0 the
/// cocircular sites are brought in order: their polygons are convex, where every flip can be made.
/// Three centres on a line are the one position that no infinitesimal resolves: a site between two
/// neighbours sinks while it has four edges. There a flip may leave a face without area, which the
/// event of the same time takes away.
///
/// In first-come order (Order::of_discovery) an edge may not be flippable: an obstruction.
/// Source: thesis, chapter 6 (Algorithm 6.5.1 is the order of discovery); the order of t is that of
/// Edelsbrunner and Shah's incremental flips, applied to one parameter for all sites.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <queue>
#include <span>
#include <type_traits>
#include <vector>

#include "../../core/index.hpp"
#include "../../exact/multiprecision.hpp"
#include "../../filters/bounded.hpp"
#include "../options.hpp"
#include "../structure/topology.hpp"

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
          degree_(hidden_by.size(), 0) {
        for (Index f = 0; f < topology_.faces(); ++f) {
            if (topology_.is_vacant(f)) continue;
            topology_.record(f).mark = ++stamp_;
            for (const Index v : topology_.vertices(f))
                if (v != infinite) ++degree_[static_cast<std::size_t>(v)];
        }
    }

    /// Flips until every edge is regular, and calls watch with the number of flips; false where an
    /// edge cannot be flipped, which in the order of time never happens.
    template <class Watch>
    [[nodiscard]] bool run(const Watch& watch) {
        for (Index f = 0; f < topology_.faces(); ++f)
            if (!topology_.is_vacant(f)) push_edges(f);
        while (!events_.empty()) {
            const Event event = events_.top();
            events_.pop();
            if (!is_current(event)) continue;
            if (!flip(event.edge)) {
                // Waits for another flip of the same time.
                blocked_.push_back(event.edge);
                continue;
            }
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

    using Rational = exact::Rational;

    /// The four sites of an edge: a counterclockwise face i, j, k and q across from it; or, where a
    /// hull edge i - k passes over j on the same line, those three and j again.
    struct Quad {
        std::array<Index, 4> sites;
        bool on_line;
    };
    /// A time in doubles, and how far it may be off.
    struct Time {
        double value;
        double error;
    };
    struct Event {
        Time time;
        std::uint64_t number;  ///< of discovery
        Quad quad;
        HalfEdge edge;
        Index stamps[2];
    };
    /// D0, D1, and the coefficients of the sites' infinitesimals.
    template <class Number>
    struct Motion {
        Number start;
        Number end;
        std::array<Number, 4> coefficients;
    };

    /// Whether event b comes before event a, as std::priority_queue wants it.
    struct Later {
        const Inflation* inflation;
        bool operator()(const Event& a, const Event& b) const {
            if (inflation->order_ == Order::of_discovery) return a.number > b.number;
            if (a.time.value - a.time.error > b.time.value + b.time.error) return true;
            if (b.time.value - b.time.error > a.time.value + a.time.error) return false;
            if (a.time.value < 0 && b.time.value < 0) return a.number > b.number;
            const int order = inflation->compare(a.quad, b.quad);
            return order != 0 ? order > 0 : a.number > b.number;
        }
    };

    [[nodiscard]] bool is_current(const Event& event) const {
        const Index f = Topology::face(event.edge);
        return topology_.record(f).mark == event.stamps[0] && !topology_.is_vacant(f) &&
               topology_.record(Topology::face(topology_.twin(event.edge))).mark == event.stamps[1];
    }

    template <class Number>
    [[nodiscard]] static Number difference(double a, double b) {
        if constexpr (std::is_same_v<Number, Rational>)
            return exact::to_rational(a) - exact::to_rational(b);
        else
            return Bounded::exactly(filters::exact_difference(a, b));
    }
    /// The difference of two weights.
    template <class Number>
    [[nodiscard]] Number weights(Index m, Index n) const {
        const auto& a = kernel_.site(m);
        const auto& b = kernel_.site(n);
        if constexpr (requires { a.w; })
            return difference<Number>(a.w, b.w);
        else
            return difference<Number>(a.r, b.r) * difference<Number>(a.r, -b.r);
    }

    template <class Number>
    [[nodiscard]] Motion<Number> motion_of(const Quad& quad) const {
        struct Row {
            Number x, y, start, end;  // start and end: the height, relative to the last site's
        };
        const Index q = quad.sites[3];
        const auto row = [&](Index m) -> Row {
            const Point p = kernel_.centre(m);
            const Point o = kernel_.centre(q);
            const Number x = difference<Number>(p.x, o.x);
            const Number y = difference<Number>(p.y, o.y);
            const Number start = x * x + y * y;
            return {x, y, start, start - weights<Number>(m, q)};
        };
        const Row i = row(quad.sites[0]);
        const Row k = row(quad.sites[2]);
        if (quad.on_line) {
            // The height of the chord from i to k above q, negative while q is below.
            const Point first = kernel_.centre(quad.sites[0]);
            const Point last = kernel_.centre(quad.sites[2]);
            const bool along_x = first.x != last.x;
            const bool rises = along_x ? first.x < last.x : first.y < last.y;
            const Number& at_i = along_x ? i.x : i.y;
            const Number& at_k = along_x ? k.x : k.y;
            const Number to_k = rises ? at_k : Number(-at_k);
            const Number to_i = rises ? Number(-at_i) : at_i;
            return {-(to_k * i.start + to_i * k.start),
                    -(to_k * i.end + to_i * k.end),
                    {-to_k, to_k - to_k, -to_i, to_k + to_i}};
        }
        const Row j = row(quad.sites[1]);
        const Number a = j.x * k.y - j.y * k.x;
        const Number b = k.x * i.y - k.y * i.x;
        const Number c = i.x * j.y - i.y * j.x;
        return {i.start * a + j.start * b + k.start * c,
                i.end * a + j.end * b + k.end * c,
                {a, b, c, -(a + b + c)}};
    }

    /// When the edge stops being regular, for one that is not regular in the end. Where it is not
    /// regular at the start, either, that is before all times. Mostly doubles with bounds will do.
    [[nodiscard]] Time time_of(const Quad& quad) const {
        const auto fast = motion_of<Bounded>(quad);
        if (fast.start.is_positive()) return {-1.0, 0.0};
        if ((-fast.start).is_positive() && fast.end.is_positive()) {
            const Bounded time = fast.start / (fast.start - fast.end);
            const double error = 2 * time.error + 0x1p-52 * time.size();
            if (error < 1.0) return {time.value.high, error};
        }
        const auto m = motion_of<Rational>(quad);
        if (m.start > 0 || (m.start == 0 && first_sign(quad, m.coefficients) > 0))
            return {-1.0, 0.0};
        const double time = exact::round_to_double(Rational(m.start / (m.start - m.end)));
        return {time, 0x1p-52 * time + 0x1p-1074};
    }

    /// The sign of a sum of infinitesimals.
    [[nodiscard]] int first_sign(const Quad& quad,
                                 const std::array<Rational, 4>& coefficients) const {
        std::array<std::size_t, 4> order = {0, 1, 2, 3};
        std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
            return quad.sites[a] != quad.sites[b] && kernel_.precedes(quad.sites[b], quad.sites[a]);
        });
        for (const std::size_t m : order)
            if (coefficients[m] != 0) return coefficients[m] > 0 ? 1 : -1;
        return 0;
    }

    /// Of two events whose times are too near for doubles: below 0 where the first comes first.
    [[nodiscard]] int compare(const Quad& one, const Quad& other) const {
        // The three edges of a site that sinks have the same sites around them.
        if (std::is_permutation(one.sites.begin(), one.sites.end(), other.sites.begin())) return 0;
        const Motion<Rational> a = motion_of<Rational>(one);
        const Motion<Rational> b = motion_of<Rational>(other);
        // The earlier one has the larger quotient of end and -start.
        const Rational difference = b.end * a.start - a.end * b.start;
        if (difference != 0) return difference > 0 ? -1 : 1;
        // P_a (b.end - b.start) - P_b (a.end - a.start), the last site's infinitesimal first.
        const Rational of_a = b.end - b.start;
        const Rational of_b = a.end - a.start;
        std::vector<Index> sites(one.sites.begin(), one.sites.end());
        sites.insert(sites.end(), other.sites.begin(), other.sites.end());
        std::ranges::sort(sites);
        sites.erase(std::unique(sites.begin(), sites.end()), sites.end());
        std::ranges::sort(sites,
                          [&](Index m, Index n) { return m != n && kernel_.precedes(n, m); });
        const auto coefficient = [](const Quad& quad, const Motion<Rational>& motion, Index site) {
            Rational sum = 0;
            for (std::size_t k = 0; k < 4; ++k)
                if (quad.sites[k] == site) sum += motion.coefficients[k];
            return sum;
        };
        for (const Index site : sites) {
            const Rational sum =
                coefficient(one, a, site) * of_a - coefficient(other, b, site) * of_b;
            if (sum != 0) return sum > 0 ? -1 : 1;
        }
        return 0;
    }

    /// The edge's four sites where it is not regular in the end.
    [[nodiscard]] std::optional<Quad> failing(HalfEdge h) {
        const HalfEdge t = topology_.twin(h);
        const Index a = topology_.apex(h);
        const Index b = topology_.origin(h);
        const Index c = topology_.target(h);
        const Index d = topology_.apex(t);
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
        const Time time = order_ == Order::of_time ? time_of(*quad) : Time{0.0, 0.0};
        events_.push({time,
                      ++number_,
                      *quad,
                      h,
                      {topology_.record(Topology::face(h)).mark,
                       topology_.record(Topology::face(topology_.twin(h))).mark}});
    }
    void push_edges(Index f) {
        for (HalfEdge h = Topology::first_edge(f); h < Topology::first_edge(f) + 3; ++h) {
            const Index g = Topology::face(topology_.twin(h));
            // Once an edge: of the two faces the later changed one asks.
            if (topology_.record(g).mark <= topology_.record(f).mark) push(h);
        }
    }

    [[nodiscard]] Index& degree(Index v) { return degree_[static_cast<std::size_t>(v)]; }

    /// Flips the edge, or takes away one of its ends; false where neither can be done.
    bool flip(HalfEdge h) {
        const HalfEdge t = topology_.twin(h);
        const Index a = topology_.apex(h);
        const Index b = topology_.origin(h);
        const Index c = topology_.target(h);
        const Index d = topology_.apex(t);
        if (b != infinite && degree(b) == 3) return remove(h);
        if (c != infinite && degree(c) == 3) return remove(t);
        // The new faces are a, b, d and d, c, a. At infinity the three are on one line.
        const bool is_convex = b == infinite || c == infinite ||
                               (kernel_.ccw(a, b, d) >= 0 && kernel_.ccw(d, c, a) >= 0);
        if (!is_convex || a == d) return false;
        const HalfEdge ab = topology_.twin(Topology::previous(h));
        const HalfEdge ca = topology_.twin(Topology::next(h));
        const HalfEdge dc = topology_.twin(Topology::previous(t));
        const HalfEdge bd = topology_.twin(Topology::next(t));
        const Index f = Topology::face(h);
        const Index g = Topology::face(t);
        const HalfEdge in_f = Topology::first_edge(f);
        const HalfEdge in_g = Topology::first_edge(g);
        // Where two of the four sides are each other's twins, they move along.
        const auto moved = [&](HalfEdge side) {
            if (side == Topology::previous(h)) return in_f;  // a b
            if (side == Topology::next(t)) return in_f + 1;  // b d
            if (side == Topology::previous(t)) return in_g;  // d c
            if (side == Topology::next(h)) return in_g + 1;  // c a
            return side;
        };
        const std::array<HalfEdge, 4> outer = {moved(ab), moved(bd), moved(dc), moved(ca)};
        topology_.record(f) = {{a, b, d}, ++stamp_, {0, 0, 0}};
        topology_.record(g) = {{d, c, a}, ++stamp_, {0, 0, 0}};
        topology_.glue(in_f, outer[0]);
        topology_.glue(in_f + 1, outer[1]);
        topology_.glue(in_g, outer[2]);
        topology_.glue(in_g + 1, outer[3]);
        topology_.glue(in_f + 2, in_g + 2);
        ++degree(a);
        ++degree(d);
        if (b != infinite) --degree(b);
        if (c != infinite) --degree(c);
        ++flips_;
        push_edges(g);
        push_edges(f);
        return true;
    }

    /// Takes away the origin of h, which has degree 3.
    bool remove(HalfEdge h) {
        const Index v = topology_.origin(h);
        std::array<HalfEdge, 3> spokes = {h, topology_.around_origin(h), 0};
        spokes[2] = topology_.around_origin(spokes[1]);
        std::array<Index, 3> ring{};
        std::array<HalfEdge, 3> outer{};
        for (std::size_t k = 0; k < 3; ++k) {
            ring[k] = topology_.target(spokes[k]);
            outer[k] = topology_.twin(Topology::next(spokes[k]));
        }
        const Index f = Topology::face(h);
        for (std::size_t k = 1; k < 3; ++k)
            topology_.record(Topology::face(spokes[k])) = {
                {Topology::vacant, Topology::vacant, Topology::vacant}, ++stamp_, {0, 0, 0}};
        topology_.record(f) = {{ring[0], ring[1], ring[2]}, ++stamp_, {0, 0, 0}};
        for (unsigned k = 0; k < 3; ++k) topology_.glue(Topology::first_edge(f) + k, outer[k]);
        for (const Index u : ring)
            if (u != infinite) --degree(u);
        hidden_by_[static_cast<std::size_t>(v)] = ring[0] != infinite ? ring[0] : ring[1];
        ++flips_;
        push_edges(f);
        return true;
    }

    Topology& topology_;
    Kernel& kernel_;
    std::span<Index> hidden_by_;
    Order order_;
    std::vector<Index> degree_;
    Index stamp_ = 0;
    std::uint64_t number_ = 0;
    std::uint64_t flips_ = 0;
    std::priority_queue<Event, std::vector<Event>, Later> events_{Later{this}};
    std::vector<HalfEdge> blocked_;
    std::array<Index, 2> obstruction_ = {infinite, infinite};
};

}  // namespace signum::triangulation
