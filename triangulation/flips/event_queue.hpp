#pragma once
/// What is to happen to edges, in an order that the user gives. An event is forgotten as soon as
/// one of the two faces at its edge has changed.

#include <cstdint>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "../../core/index.hpp"
#include "../structure/topology.hpp"

namespace signum::triangulation {

/// Compare(a, b) is below 0 where of two values of When the first comes first, and above 0 where
/// the second does; of equal ones the event that was found first comes first. The marks of the
/// faces are the queue's.
template <class When, class Compare>
class EventQueue {
 public:
    struct Event {
        When when;
        std::uint64_t number;  ///< of discovery
        HalfEdge edge;
        Index stamps[2];  ///< of the faces at the edge
    };

    EventQueue(Topology& topology, Compare compare)
        : topology_(topology), events_(Later{std::move(compare)}) {
        for (Index f = 0; f < topology_.faces(); ++f)
            if (!topology_.is_vacant(f)) stamp(f);
    }

    /// The face has changed: what is known of its edges is out of date.
    void stamp(Index f) noexcept { topology_.record(f).mark = ++stamp_; }

    /// Whether f is the face that asks what happens to the edge between f and the twin's face: of
    /// the two that which changed later, so that an edge is looked at once.
    [[nodiscard]] bool asks(Index f, HalfEdge h) const noexcept {
        return topology_.record(Topology::face(topology_.twin(h))).mark <= topology_.record(f).mark;
    }

    void push(HalfEdge h, const When& when) {
        events_.push({when, ++number_, h, {stamp_of(h), stamp_of(topology_.twin(h))}});
    }

    /// The next event that is not out of date.
    [[nodiscard]] std::optional<Event> pop() {
        while (!events_.empty()) {
            const Event event = events_.top();
            events_.pop();
            if (!topology_.is_vacant(Topology::face(event.edge)) &&
                stamp_of(event.edge) == event.stamps[0] &&
                stamp_of(topology_.twin(event.edge)) == event.stamps[1])
                return event;
        }
        return std::nullopt;
    }

 private:
    /// As std::priority_queue wants it.
    struct Later {
        Compare compare;
        bool operator()(const Event& a, const Event& b) const {
            const int order = compare(a.when, b.when);
            return order != 0 ? order > 0 : a.number > b.number;
        }
    };
    [[nodiscard]] Index stamp_of(HalfEdge h) const noexcept {
        return topology_.record(Topology::face(h)).mark;
    }

    Topology& topology_;
    Index stamp_ = 0;
    std::uint64_t number_ = 0;
    std::priority_queue<Event, std::vector<Event>, Later> events_;
};

}  // namespace signum::triangulation
