#pragma once
/// The power triangulation of sites that move, kept up from event to event. For sources only.
///
/// The structure is that of the moment right after a time, when nothing is tied but what is tied
/// for ever (moving_kernel.hpp). It is a triangulation of the sphere with infinity for a site, and
/// every edge has a certificate (certificate.hpp) that is above 0 as long as the edge is right:
///  - between two faces of three sites each, that the far site of one is not in conflict with the
///    other;
///  - of the hull, that the face behind it turns left;
///  - from infinity to a site, that the hull turns left there, or, where three are on one line for
///    ever, that the middle one is in conflict with the stretch between the others.
/// A hidden site lies in a face; it has the certificates that it is not in conflict with it and
/// left of its three edges. An event is the first root of a certificate, of whatever multiplicity.
/// All events of one time are looked at together.
///
/// Laws:
///  1. Right after the time all faces turn left, all certificates are above 0, and the hull winds
///     once. So the structure is the power triangulation: faces that turn left, inside a convex
///     polygon that winds once, cover it once, and one that is regular across every edge is
///     regular.
///  2. What is above 0 right before a time and has no root there is above 0 right after. An edge
///     with a root that changes its sign fails; then it is flipped, or an end of it that has three
///     edges is hidden. Either takes the lifted surface down, by a volume that counts as the faces
///     turn. So no structure comes back, and this ends.
///  3. Faces have no certificates of their own: from the edges with a root all flat faces are
///     found, and these are asked once the flips are through. For a flat face lies in a patch of
///     flat faces of which some edge has a root. Make all weights less by infinitesimals: then the
///     sites at the time itself have a triangulation in which no face is flat. In the patch it is
///     another one than that at hand, so that there some edge is not regular at the time; right
///     before it was.
///  4. Where the flips of a time do not lead there (an edge cannot be flipped, a face is turned
///     over, the hull winds twice), all is built anew. That takes two sites of one weight that are
///     at one place, or three on a line at the hull, or a hull that turns over.
///  5. All sites on one line for ever: there is no face. They stand in a row (line_), whose events
///     are found, and which is made, anew each time: O(n log n) an event.
///
/// Sources: thesis, 9.3; Guibas and Russel on kinetic Delaunay triangulations; Edelsbrunner and
/// Shah on flips of weighted sites.

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "../../core/index.hpp"
#include "../dynamic/lists.hpp"
#include "../flips/event_queue.hpp"
#include "../insertion/insert.hpp"
#include "../structure/topology.hpp"
#include "kinetic_tessellation.hpp"
#include "moment.hpp"
#include "moving_kernel.hpp"
#include "moving_site.hpp"

namespace signum::kinetic {

using triangulation::HalfEdge;
using triangulation::Topology;

/// But for the questions about polynomials.
using Work = KineticStatistics;

class MovingTriangulation {
 public:
    /// Told of every edge between two sites that comes or goes.
    using Watch = std::function<void(Index a, Index b, bool comes)>;

    MovingTriangulation(double start, Fall fall);
    MovingTriangulation(const MovingTriangulation&) = delete;
    MovingTriangulation& operator=(const MovingTriangulation&) = delete;
    ~MovingTriangulation();

    void watch(Watch watch) { watch_ = std::move(watch); }

    /// Many at once, built together. Their numbers are the next ones.
    void insert(std::span<const MovingSite> sites);
    Index insert(const MovingSite& site);
    // Preconditions: contains(i).
    void erase(Index i);
    void change(Index i, const MovingSite& site);

    [[nodiscard]] bool contains(Index i) const noexcept {
        return i >= 0 && at(i) < live_.size() && live_[at(i)];
    }
    [[nodiscard]] std::size_t size() const noexcept { return count_; }
    [[nodiscard]] std::size_t numbers() const noexcept { return live_.size(); }
    [[nodiscard]] const MovingSite& site(Index i) const noexcept { return moving_[at(i)]; }

    /// Up to right after t. Precondition: not before the moment at hand.
    void advance(double t);
    /// Up to right after the next event. Precondition: there is one.
    void step();
    [[nodiscard]] const Event* next_event() const noexcept {
        return queue_.empty() ? nullptr : &queue_.top().when;
    }
    /// The least double not before the next event, infinity where that is beyond the doubles; none
    /// where there is no event. What it takes is not counted, for several threads may ask at once.
    [[nodiscard]] std::optional<double> next_time() const;

    [[nodiscard]] bool is_line() const noexcept { return is_line_; }
    /// The visible sites in their order. Precondition: is_line().
    [[nodiscard]] std::span<const Index> line() const noexcept { return line_; }
    /// Precondition: not is_line().
    [[nodiscard]] const Topology& topology() const noexcept { return topology_; }
    [[nodiscard]] bool is_hidden(Index i) const noexcept { return is_hidden_[at(i)]; }
    /// A face at a visible site, -1 at others and on a line.
    [[nodiscard]] Index face_of(Index i) const noexcept { return face_of_[at(i)]; }

    /// A visible site not far from a hidden one.
    [[nodiscard]] Index beside(Index hidden) const noexcept {
        const auto& v = topology_.vertices(home_[at(hidden)]);
        return v[0] != infinite ? v[0] : v[1];
    }
    /// Precondition: not is_line().
    [[nodiscard]] Index infinite_face() const noexcept { return infinite_face_; }
    [[nodiscard]] const Fall& fall() const noexcept { return sites_.fall; }

    [[nodiscard]] const Work& work() const noexcept { return work_; }
    [[nodiscard]] const roots::Tally& tally() const noexcept { return tally_; }

 private:
    struct Order {
        const Sites* sites;
        roots::Tally* tally;
        int operator()(const Event& a, const Event& b) const {
            return kinetic::compare(*sites, a, b, tally);
        }
    };
    using Queue = triangulation::EventQueue<Event, Order>;
    using Insertion = triangulation::Insertion<MovingKernel>;
    /// A face as it was.
    struct Face {
        Index face;
        Index vertex[3];
    };

    [[nodiscard]] static std::size_t at(Index i) noexcept { return static_cast<std::size_t>(i); }
    /// Half-edges are subjects by their number; sites by the numbers between those.
    [[nodiscard]] static Queue::Subject subject(Index site) noexcept {
        return (static_cast<Queue::Subject>(site) << 2) + 3;
    }

    /// Whether the next event is not after t. Precondition: there is one.
    [[nodiscard]] bool is_next_by(double t);

    [[nodiscard]] Index put(const MovingSite& site);
    void make_room(std::size_t sites);
    [[nodiscard]] bool take_out(Index i);
    [[nodiscard]] bool keeps_star(Index i);

    void note_flat(std::span<const HalfEdge> edges);
    /// False where all has to be built anew.
    [[nodiscard]] bool settle();
    void settle_or_build() {
        if (settle())
            tell_all();
        else
            build();
    }
    /// Whether the edge is right; then its next event is in the queue.
    [[nodiscard]] bool is_right(HalfEdge h);
    [[nodiscard]] bool make_right(HalfEdge h);
    [[nodiscard]] bool hide(HalfEdge h);
    void place(Index q);
    void appear(Index face, Index q);
    void schedule_hidden(Index q);
    [[nodiscard]] bool hull_winds_once();
    [[nodiscard]] bool has_three_edges(HalfEdge spoke) const noexcept;
    /// Whether a face that is to come turns left or is flat, and then suspect; infinite ones do.
    [[nodiscard]] bool may_be(Index a, Index b, Index c);
    void suspect(Index face);
    /// Whether it is no longer there, or turns left.
    [[nodiscard]] bool is_cleared(const Face& suspect);

    void forget_edges(Index face);
    void release_hidden(Index face);
    void note_corner(Index v, Index face);
    void note_corners(Index face);
    void tell(Index a, Index b, bool comes) {
        if (watch_ && a != infinite && b != infinite)
            changed_edges_.push_back({std::min(a, b), std::max(a, b), comes ? 1 : -1});
    }
    void tell_all();
    template <class Visit>
    void for_each_edge(const Visit& visit) const;

    void build();
    void build_faces(std::vector<Index> order, std::size_t second, std::size_t third);
    void build_line(std::vector<Index> along);
    [[nodiscard]] Index face_near(Index q) const;
    [[nodiscard]] std::array<double, 2> roughly(Index i) const noexcept;

    std::vector<MovingSite> moving_;
    Sites sites_;
    std::vector<bool> live_;
    std::set<Index> free_;
    std::size_t count_ = 0;
    Moment moment_;
    roots::Tally tally_;
    MovingKernel kernel_;
    Watch watch_;

    bool is_line_ = true;
    std::vector<Index> line_;
    std::size_t room_ = 0;
    Topology topology_{0};
    std::vector<Index> hidden_by_;  ///< the insertion's
    std::vector<Index> none_hidden_;
    std::unique_ptr<Insertion> insertion_;
    std::vector<bool> is_hidden_;
    std::vector<Index> face_of_;
    std::vector<Index> home_;  ///< of a hidden site the face in which it lies
    triangulation::Lists lodgers_;
    Queue queue_;
    /// What next_time() told, and of which event, by its number: who asks goes there next. The
    /// number is written last and read first.
    mutable std::atomic<double> told_time_ = 0.0;
    mutable std::atomic<std::uint64_t> told_event_ = 0;

    std::vector<HalfEdge> pending_;  ///< edges to be looked at
    std::vector<HalfEdge> blocked_;  ///< edges that fail and cannot be flipped yet
    std::vector<Index> homeless_;    ///< hidden sites; home_ is a face not far away
    std::vector<Face> suspects_;     ///< faces that may not turn left
    bool suspects_flat_ = false;     ///< whether may_be saw a flat one
    bool hull_is_suspect_ = false;
    Index recent_ = 0;                                 ///< a face that is not vacant
    Index infinite_face_ = 0;                          ///< one of them
    std::vector<std::array<Index, 3>> changed_edges_;  ///< edges of which the watch is to hear: ±1
    Work work_;
};

}  // namespace signum::kinetic
