#pragma once
/// Incremental insertion: one site at a time into a tessellation of the sphere.
///
/// The faces in conflict with the new site form a disc around it. Their boundary, joined to the
/// site, replaces them; sites that the disc encloses become hidden, and stay hidden whatever comes
/// later. A site that conflicts not even with the face that contains its centre (in the additive
/// metrics: one that lies within the nearest site) is hidden itself.
///
/// In the power metric the edges are straight: a face contains the site's centre, and an edge whose
/// two faces go goes as a whole. In the others the site may take a part out of one edge and no
/// vertex, or both ends of an edge and not its middle.
/// Source: Gavrilova 1998, 4.2; Edelsbrunner and Shah 1996.

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "../../core/index.hpp"
#include "../options.hpp"
#include "../structure/topology.hpp"
#include "edge_interior.hpp"
#include "locate.hpp"

namespace signum::triangulation {

/// A stack with room for all that can ever be on it: memory is claimed as it is used, and a push is
/// a store.
template <class T>
class Stack {
 public:
    explicit Stack(std::size_t most) : items_(most), end_(items_.data()) {}

    [[nodiscard]] bool empty() const noexcept { return end_ == items_.data(); }
    [[nodiscard]] std::size_t size() const noexcept {
        return static_cast<std::size_t>(end_ - items_.data());
    }
    [[nodiscard]] T& operator[](std::size_t i) noexcept { return items_.data()[i]; }
    [[nodiscard]] const T& operator[](std::size_t i) const noexcept { return items_.data()[i]; }
    [[nodiscard]] const T* begin() const noexcept { return items_.data(); }
    [[nodiscard]] const T* end() const noexcept { return end_; }
    void clear() noexcept { end_ = items_.data(); }
    void push(const T& item) noexcept {
        SIGNUM_EXPECTS(size() < items_.size());
        *end_++ = item;
    }
    T pop() noexcept { return *--end_; }

 private:
    LargeArray<T> items_;
    T* end_;
};

template <class Kernel>
class Deletion;

template <class Kernel>
class Insertion {
 public:
    /// Starts from three sites with ccw(a, b, c) > 0. hidden_by[i] becomes the site that hid i,
    /// visible or not by now, and is -1 while i is visible; it has room for every site.
    Insertion(Topology& topology, Kernel& kernel, std::span<Index> hidden_by, Index a, Index b,
              Index c)
        : Insertion(topology, kernel, hidden_by) {
        const Index corners[3] = {a, b, c};
        const Index inner = topology_.add_face(a, b, c);
        Index outer[3];
        for (int k = 0; k < 3; ++k)
            outer[k] = topology_.add_face(corners[(k + 1) % 3], corners[k], infinite);
        for (unsigned k = 0; k < 3; ++k) {
            topology_.glue(edge(inner, k), edge(outer[k], 0));
            topology_.glue(edge(outer[k], 1), edge(outer[(k + 2) % 3], 2));
        }
        recent_ = inner;
    }

    /// Starts from two sites of which neither hides the other.
    Insertion(Topology& topology, Kernel& kernel, std::span<Index> hidden_by, Index a, Index b)
        : Insertion(topology, kernel, hidden_by) {
        const Index left = topology_.add_face(a, b, infinite);
        const Index right = topology_.add_face(b, a, infinite);
        topology_.glue(edge(left, 0), edge(right, 0));
        topology_.glue(edge(left, 1), edge(right, 2));
        topology_.glue(edge(left, 2), edge(right, 1));
        recent_ = left;
    }

    /// Goes on with the tessellation that is in the topology; from a face of it the first site is
    /// looked for.
    Insertion(Topology& topology, Kernel& kernel, std::span<Index> hidden_by, Index face)
        : Insertion(topology, kernel, hidden_by) {
        for (Index f = 0; f < topology_.faces(); ++f)
            if (topology_.is_vacant(f)) vacant_.push(f);
        recent_ = face;
    }

    /// A face at the site inserted last, if it is visible.
    [[nodiscard]] Index recent() const noexcept { return recent_; }
    /// The face from which the next site is looked for.
    void start_from(Index face) noexcept { recent_ = face; }
    /// Face slots that wait for reuse: who takes faces out by other means leaves them here.
    [[nodiscard]] Stack<Index>& vacant() noexcept { return vacant_; }
    /// The sites that the last one hid.
    [[nodiscard]] const std::vector<Index>& enclosed() const noexcept { return enclosed_; }

    /// Inserts site q; false, and nothing is done, where q hides all the others, so that no
    /// structure is left. In exact arithmetic that takes a site before all of them in the tie
    /// rule's order, in an additive metric. Throws BrokenStructure where inexact arithmetic made
    /// nonsense.
    bool insert(Index q) {
        enclosed_.clear();
        if (!find_conflicts(q)) return true;
        if (boundary_.empty()) return hides_all();
        if (boundary_.size() != removed_.size() + 2) hide_enclosed(q);
        retriangulate(q);
        return true;
    }

 private:
    friend class Deletion<Kernel>;

    Insertion(Topology& topology, Kernel& kernel, std::span<Index> hidden_by)
        : topology_(topology),
          kernel_(kernel),
          hidden_by_(hidden_by),
          // All faces may go, and each but the first adds two edges to look across.
          pending_(topology.room() + 8),
          removed_(2 * topology.room() + 12),
          boundary_(2 * topology.room() + 12),
          vacant_(topology.room() + 4) {}

    /// The mark of a face that the site at hand removes.
    static constexpr Index in_conflict = 1;
    /// Instead of a half-edge outside: the edge is a seam.
    static constexpr HalfEdge seam = ~HalfEdge{0};

    /// An edge of the disc's boundary: the half-edge outside, and the vertex where it ends outside,
    /// where it begins for one who walks around the disc counterclockwise.
    struct BoundaryEdge {
        HalfEdge outside;
        Index from;
    };

    /// An edge out of the disc as far as it is known, and whether the face outside is in conflict.
    struct Crossing {
        HalfEdge outside;
        Index from;
        bool conflict;
    };

    [[nodiscard]] static HalfEdge edge(Index f, unsigned k) noexcept {
        return Topology::first_edge(f) + k;
    }

    [[nodiscard]] bool conflicts(Index f, Index q) {
        const auto& v = topology_.vertices(f);
        if ((v[0] | v[1] | v[2]) < 0) [[unlikely]] {
            const HalfEdge h = topology_.finite_edge(f);
            return kernel_.conflicts_infinite(topology_.target(h), topology_.origin(h), q);
        }
        return kernel_.conflicts(v[0], v[1], v[2], q);
    }

    [[nodiscard]] std::array<bool, 2> conflicts(Index f, Index g, Index q) {
        const auto& v = topology_.vertices(f);
        const auto& w = topology_.vertices(g);
        if constexpr (requires { kernel_.conflicts(v, w, q); })
            if (!topology_.is_infinite(f) && !topology_.is_infinite(g)) [[likely]]
                return kernel_.conflicts(v, w, q);
        return {conflicts(f, q), conflicts(g, q)};
    }

    /// Finds the faces that q removes and their boundary; false where q is hidden.
    [[nodiscard]] bool find_conflicts(Index q) {
        if constexpr (Kernel::is_straight) {
            const Index start = locate(topology_, kernel_, recent_, q);
            if (conflicts(start, q)) {
                collect(start, q);
                return true;
            }
            hide_in(start, q);
            return false;
        } else {
            WalkStart from = nearest_corner(topology_, kernel_, recent_, q);
            for (Index steps = topology_.faces(); Kernel::is_exact || steps >= 0; --steps) {
                const Approach approach = locate_nearest(topology_, kernel_, from, q);
                recent_ = Topology::face(approach.spoke);
                const Index site = topology_.origin(approach.spoke);
                if (kernel_.hides(site, q)) {
                    hidden_by_[static_cast<std::size_t>(q)] = site;
                    return false;
                }
                if (find_conflicts_around(approach, q, from)) return true;
            }
            throw BrokenStructure("the walk to a site went in circles");
        }
    }

    /// Finds the conflicts of q at the border of the cell of a site that does not hide it.
    /// Otherwise `nearer` becomes a site that is nearer, from which the walk is to go on: false.
    ///
    /// Let v be the site, d its distance less its radius, c the centre of q. The ray from v's
    /// centre through c leaves v's cell in a point x of an edge, perhaps at infinity. Either
    ///  - x lies before c. Beyond x, v's distance grows as fast as any can, so that at c the site
    ///    across the edge is nearer. Or
    ///  - x lies beyond c. As v does not hide q, d of q at c is less than that of v; and from c to
    ///    x that of v grows as fast as any can: q takes x, and so an end of the edge, or its
    ///    middle.
    /// So it suffices to look at that edge. It is not known, but not far from where the walk came
    /// from: the search goes from there to both sides at once, and a giant with a thousand
    /// neighbours costs no more than the few between one insertion and the next along the curve.
    /// A site that q's conflict is asked with is not nearer than v; so it does not hide q either.
    [[nodiscard]] bool find_conflicts_around(const Approach& approach, Index q, WalkStart& nearer) {
        const HalfEdge first = approach.spoke;
        bool found = false;
        // Whether the search is at its end with the face of h, of which the apex is new.
        const auto ends_at = [&](HalfEdge h) {
            const Index f = Topology::face(h);
            if (!approach.is_nearest) [[unlikely]] {
                const Index apex = topology_.apex(h);
                if (apex != infinite && kernel_.is_nearer(q, apex, topology_.origin(first))) {
                    nearer = {Topology::previous(h), kernel_.distance(q, apex)};
                    return true;
                }
            }
            if (!conflicts(f, q)) return false;
            collect(f, q);
            return found = true;
        };
        // The same with the middle of an edge between two faces not in conflict.
        const auto ends_within_edge = [&](HalfEdge h) {
            if (!ends_within(topology_.about(h), kernel_, q, false)) return false;
            cut(h);
            return found = true;
        };
        if (ends_at(topology_.twin(first)) || ends_at(first) || ends_within_edge(first))
            return found;
        HalfEdge left = first;
        HalfEdge right = first;
        for (;;) {
            left = topology_.around_origin(left);
            if (left == right) break;
            if (ends_at(left) || ends_within_edge(left)) return found;
            if (approach.is_nearest) continue;
            right = Topology::next(topology_.twin(right));
            if (right == left) break;
            if (ends_at(topology_.twin(right)) || ends_within_edge(right)) return found;
        }
        throw BrokenStructure("a site that is not hidden conflicts with nothing");
    }

    /// The conflict region is a piece inside one edge: no face goes, q comes between the two.
    void cut(HalfEdge h) {
        removed_.clear();
        boundary_.clear();
        boundary_.push({h, topology_.target(h)});
        boundary_.push({topology_.twin(h), topology_.origin(h)});
    }

    /// Finds all faces in conflict, from one of them, and the boundary in counterclockwise order: a
    /// depth-first search that takes the edges of each face in that order.
    void collect(Index start, Index q) {
        boundary_.clear();
        removed_.clear();
        pending_.clear();
        take(start);
        look_across(topology_.record(start), 2, q);
        look_across(topology_.record(start), 1, 0, q);
        while (!pending_.empty()) {
            const Crossing crossing = pending_.pop();
            const Index f = Topology::face(crossing.outside);
            const Topology::Record& record = topology_.record(f);
            if (crossing.conflict) {
                if (record.mark == in_conflict) continue;
                take(f);
                look_across(record, Topology::previous(crossing.outside) & 3,
                            Topology::next(crossing.outside) & 3, q);
            } else {
                boundary_.push({crossing.outside, crossing.from});
            }
        }
        if constexpr (!Kernel::is_exact) check_boundary();
    }

    void take(Index f) {
        topology_.record(f).mark = in_conflict;
        removed_.push(f);
    }

    /// Asks the faces across edges of the disc so far, of two before it looks at either's answer.
    /// The answers wait until their turn: by then they are known, and a branch that was guessed
    /// wrong costs little.
    void look_across(const Topology::Record& record, unsigned k, Index q) {
        push(record, k, conflicts(Topology::face(record.twin[k]), q), q);
    }
    void look_across(const Topology::Record& record, unsigned k, unsigned l, Index q) {
        const auto [k_conflicts, l_conflicts] =
            conflicts(Topology::face(record.twin[k]), Topology::face(record.twin[l]), q);
        push(record, k, k_conflicts, q);
        push(record, l, l_conflicts, q);
    }
    void push(const Topology::Record& record, unsigned k, bool conflict, Index q) {
        const HalfEdge across = record.twin[k];
        if constexpr (!Kernel::is_straight)
            conflict = conflict && !ends_within(topology_.about(across), kernel_, q, true);
        pending_.push({across, record.vertex[k], conflict});
    }

    /// The boundary of a disc is one closed walk. Rounded signs can make the region an annulus or
    /// all of the sphere.
    void check_boundary() const {
        bool closed = boundary_.size() >= 2;
        for (std::size_t i = 0; closed && i < boundary_.size(); ++i)
            closed = topology_.origin(boundary_[i].outside) ==
                     boundary_[(i + 1) % boundary_.size()].from;
        if (!closed) throw BrokenStructure("the conflict region of a site is not a disc");
    }

    /// Where the middle of an edge survives between two removed faces, the boundary runs along it
    /// on both sides: those new faces will be glued to each other. As the region stays a disc, two
    /// such pairs never cross along the boundary, and the side met last is paired first.
    void find_seams() {
        seams_.clear();
        open_seams_.clear();
        for (std::size_t i = 0; i < boundary_.size(); ++i) {
            const HalfEdge outside = boundary_[i].outside;
            if (topology_.record(Topology::face(outside)).mark != in_conflict) continue;
            if (!open_seams_.empty() &&
                boundary_[open_seams_.back()].outside == topology_.twin(outside)) {
                seams_.emplace_back(open_seams_.back(), i);
                open_seams_.pop_back();
            } else {
                open_seams_.push_back(i);
            }
        }
        if (!open_seams_.empty())
            throw BrokenStructure("an edge survives on one side and not on the other");
        for (const auto& [a, b] : seams_) boundary_[a].outside = boundary_[b].outside = seam;
    }

    /// Joins q to every edge of the boundary, reusing the slots of the removed faces.
    void retriangulate(Index q) {
        const std::size_t count = boundary_.size();
        if constexpr (!Kernel::is_straight) find_seams();
        while (removed_.size() < count)
            removed_.push(vacant_.empty() ? topology_.add_face(infinite, infinite, infinite)
                                          : vacant_.pop());
        Index before = removed_[count - 1];
        Index f = removed_[0];
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t next = i + 1 < count ? i + 1 : 0;
            const Index after = removed_[next];
            const HalfEdge outside = boundary_[i].outside;
            topology_.record(f) = {{boundary_[i].from, boundary_[next].from, q},
                                   0,
                                   {outside, edge(after, 2), edge(before, 1)}};
            if (Kernel::is_straight || outside != seam)
                topology_.record(Topology::face(outside)).twin[outside & 3] = edge(f, 0);
            before = f;
            f = after;
        }
        if constexpr (!Kernel::is_straight)
            for (const auto& [a, b] : seams_)
                topology_.glue(edge(removed_[a], 0), edge(removed_[b], 0));
        recent_ = before;
        for (std::size_t i = count; i < removed_.size(); ++i) {
            topology_.vacate(removed_[i]);
            vacant_.push(removed_[i]);
        }
    }

    /// q is hidden in face f. Any finite corner will do: who hides it is settled at the end.
    void hide_in(Index f, Index q) {
        const auto& v = topology_.vertices(f);
        hidden_by_[static_cast<std::size_t>(q)] = v[0] != infinite ? v[0] : v[1];
        recent_ = f;
    }

    /// All faces were in conflict. Those that stay are unmarked.
    bool hides_all() {
        if constexpr (!Kernel::is_exact) throw BrokenStructure("the hull vanished");
        for (const Index f : removed_) topology_.record(f).mark = 0;
        return false;
    }

    /// Vertices of the removed faces that are not on the boundary vanish behind q.
    void hide_enclosed(Index q) {
        std::vector<Index> kept;
        for (const BoundaryEdge& edge : boundary_) kept.push_back(edge.from);
        std::sort(kept.begin(), kept.end());
        for (const Index f : removed_)
            for (const Index v : topology_.vertices(f)) {
                if (std::binary_search(kept.begin(), kept.end(), v)) continue;
                if (v == infinite) throw BrokenStructure("the hull vanished");
                if (hidden_by_[static_cast<std::size_t>(v)] != q) enclosed_.push_back(v);
                hidden_by_[static_cast<std::size_t>(v)] = q;
            }
    }

    Topology& topology_;
    Kernel& kernel_;
    std::span<Index> hidden_by_;
    Index recent_ = 0;
    Stack<Crossing> pending_;
    Stack<Index> removed_;
    Stack<BoundaryEdge> boundary_;
    Stack<Index> vacant_;
    std::vector<Index> enclosed_;
    std::vector<std::pair<std::size_t, std::size_t>> seams_;
    std::vector<std::size_t> open_seams_;  ///< one side of each was met
};

}  // namespace signum::triangulation
