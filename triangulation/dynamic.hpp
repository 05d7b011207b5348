#pragma once
/// A tessellation that changes: sites come, go, grow and move, and at any time it is the canonical
/// one of the sites that are there.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "../core/index.hpp"
#include "../core/site.hpp"
#include "tessellation.hpp"

namespace signum {

/// How many moves, of one site or all, came to what.
struct Moves {
    std::uint64_t kept = 0;    ///< all was as right as before
    std::uint64_t mended = 0;  ///< what was not has been changed
    std::uint64_t built = 0;   ///< all was built anew

    friend bool operator==(const Moves&, const Moves&) = default;
};

/// Laws:
///  1. tessellation() depends on the sites alone, not on how they came together: it is
///     triangulate() of the live sites in the order of their handles.
///  2. A handle names its site until that is erased; afterwards it may be given to another one.
///  3. What a site hid reappears when it goes, or shrinks.
///  4. Where std::bad_alloc leaves a change, the sites are those before it. The next one costs as
///     much as triangulate() beside its own work.
class DynamicTessellation {
 public:
    /// Weights instead of radii exist in the power metric alone (std::invalid_argument).
    explicit DynamicTessellation(Metric metric, WeightIs weight_is = WeightIs::radius);
    /// What was moved from is empty.
    DynamicTessellation(DynamicTessellation&&) noexcept;
    /// Likewise.
    DynamicTessellation& operator=(DynamicTessellation&&) noexcept;
    ~DynamicTessellation();

    /// Adds a site and gives its handle, the least that is free. Throws std::invalid_argument
    /// unless its numbers are finite. Expected O(√n) for sites in no order, and less near the last
    /// change; beside it O(degree), for each neighbour of the new site is an edge to be made, and
    /// in the power metric a test of each hidden site that these keep. In an order along a curve
    /// the degree may be O(n): in the supremum and Manhattan metrics the last one of sites along a
    /// circle, or a square's outline, is often a neighbour of a constant share of them. Who has
    /// such sites at once shuffles them. Where all is on
    /// one line (power metric), or one site hides all the others, O(log n).
    Index insert(const Site& site);
    /// Takes a site away. Throws std::out_of_range unless contains(handle). O(degree log degree)
    /// expected, O(degree²) at most, and an insertion for each site that it hid and that nobody
    /// else is known to hide.
    void erase(Index handle);
    /// Gives a site another radius (or weight), and keeps its handle. As erase and insert.
    void change(Index handle, double third);

    /// Gives a site another centre; its third number and its handle stay. Throws
    /// std::invalid_argument unless the centre is finite. O(degree) and nothing more where its
    /// neighbours stay and it is not on the hull; elsewhere as erase and insert.
    void move(Index handle, Point centre);
    /// Gives every site another centre: one for each, in the order of their handles. Throws
    /// std::invalid_argument unless there are size() of them, all finite; then nothing has changed.
    ///
    /// Every face and edge is asked whether it is right for the new centres, exactly; what is not
    /// is mended, and where too much is not, or there is no structure, all is built anew. So it is
    /// O(n), and the less sites move, the faster it is; at worst as triangulate(). Of more than
    /// 16 384 sites that came one by one, the first time all is built anew, so that neighbours lie
    /// near one another in memory; and again after some dozens of moves of a hundredth of the
    /// sites' distance, as neighbours change.
    void move_all(std::span<const Point> centres);

    /// Whether the handle names a site.
    [[nodiscard]] bool contains(Index handle) const noexcept;
    /// How many sites are there.
    [[nodiscard]] std::size_t size() const noexcept;
    /// Throws std::out_of_range unless contains(handle).
    [[nodiscard]] Site site(Index handle) const;

    /// The result of the live sites, numbered from 0 in the order of their handles. O(n log n).
    [[nodiscard]] Tessellation tessellation() const;

    /// How many insertions all changes took up to now: one each, and one for each hidden site that
    /// had to be looked at again.
    [[nodiscard]] std::uint64_t insertions() const noexcept;
    /// How often all had to be built anew: where a gap that a site left could not be closed in
    /// one way alone. No input is known that does it.
    [[nodiscard]] std::size_t rebuilds() const noexcept;
    /// What move() and move_all() did up to now.
    [[nodiscard]] Moves moves() const noexcept;

 private:
    class State;
    void require(Index handle) const;

    Metric metric_;
    WeightIs weight_is_;
    std::unique_ptr<State> state_;  ///< none before the first site
};

}  // namespace signum
