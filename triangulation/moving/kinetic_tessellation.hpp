#pragma once
/// A power tessellation whose sites move: kept up exactly, from one change to the next.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "../../core/index.hpp"
#include "../tessellation.hpp"
#include "moving_site.hpp"

namespace signum {

/// What keeping a tessellation up took.
struct KineticStatistics {
    std::uint64_t times = 0;     ///< at which something was looked at
    std::uint64_t events = 0;    ///< roots of certificates, those that change nothing too
    std::uint64_t flips = 0;     ///< edges swapped
    std::uint64_t hidden = 0;    ///< sites that became hidden
    std::uint64_t appeared = 0;  ///< sites that became visible
    std::uint64_t rebuilds = 0;  ///< how often all was built, the first time included
    std::uint64_t filtered = 0;  ///< questions about polynomials that the filter decided
    std::uint64_t exact = 0;     ///< ... and those decided in integers
};

/// Laws:
///  1. The faces are those right after time(): of the power triangulation of the exact places, as
///     it stays until the next event. Where sites are tied for ever, the rule of ties decides, with
///     the order by falling weight and then rising handle. So faces are a function of the sites and
///     the time: neither of the way there nor of the steps of advance().
///  2. At a time at which nothing is tied, and places are doubles, they are the finite ones of
///     triangulate().
///  3. Sites may meet, overlap and pass through one another.
///  4. A handle names its site until that is erased; afterwards it may be given to another one.
///  5. Whoever is left by std::bad_alloc, or by what on_edge throws (watch), may only be destroyed
///     or given a new value.
///
/// An event, a root of one of its polynomials in time, costs O(log n) beside O(1) such roots
/// expected; one at which two sites of one weight are at one place, the hull turns over, or three
/// sites of it are on one line and one of them is hidden may cost a new build, O(n log n) expected,
/// and so does each event while all sites are on one line. Memory is O(n), however long it runs.
///
/// Sources: thesis, 9.3; Guibas and Russel 2004.
class KineticTessellation {
 public:
    /// Without sites, at that time. Throws std::invalid_argument unless the numbers are finite.
    explicit KineticTessellation(double start = 0.0, Fall fall = {});
    /// With sites of handles 0, 1, 2 …; their own times may be before or after the start.
    explicit KineticTessellation(std::span<const MovingSite> sites, double start = 0.0,
                                 Fall fall = {});
    /// What was moved from is to be destroyed or given a new value.
    KineticTessellation(KineticTessellation&&) noexcept;
    /// Likewise.
    KineticTessellation& operator=(KineticTessellation&&) noexcept;
    ~KineticTessellation();

    /// Adds a site at time() and gives its handle, the least that is free. Throws
    /// std::invalid_argument unless its numbers are finite, and beyond max_sites. O(n^(1/3))
    /// expected; while all sites are on one line O(n log n), so that many at once are for the
    /// constructor.
    Index insert(const MovingSite& site);
    /// Takes a site away. Throws std::out_of_range unless contains(handle). O(degree log degree)
    /// expected, O(degree²) at most, and a search for each hidden site around it.
    void erase(Index handle);
    /// From now on the site moves otherwise, or has another weight. Where its neighbours stay,
    /// O(degree); else as erase and insert.
    void change(Index handle, const MovingSite& site);

    /// Whether the handle names a site.
    [[nodiscard]] bool contains(Index handle) const noexcept;
    /// How many sites are there.
    [[nodiscard]] std::size_t size() const noexcept;
    /// Throws std::out_of_range unless contains(handle).
    [[nodiscard]] MovingSite site(Index handle) const;

    /// Up to when it has gone on.
    [[nodiscard]] double time() const noexcept;
    /// A time at which faces may change: the least double that is not before the next event.
    /// Nothing where there is none. O(1); what it finds out is kept, for the next call and for
    /// advance().
    [[nodiscard]] std::optional<double> next_event() const;
    /// Goes on to a time, all that happens until then and at it included. Throws
    /// std::invalid_argument unless it is finite and not before time().
    void advance(double time);

    /// Counterclockwise triples of handles, the smallest first, sorted: the finite faces alone, and
    /// none while all sites are on one line. Law 1. O(n log n).
    [[nodiscard]] std::vector<Face> faces() const;
    /// The result of the sites as they are at time(), numbered from 0 in the order of their
    /// handles (so that number and handle are the same as long as no site has been erased), at the
    /// doubles nearest to their places. It has the faces of law 1 where those are faces of a power
    /// triangulation of these doubles. Where they are not (three on a line right then, or so near
    /// that rounding counts) it is that of triangulate(). Throws std::overflow_error where a site
    /// is beyond the doubles. O(n log n).
    [[nodiscard]] Tessellation tessellation() const;

    /// Calls on_edge(a, b, comes) with a < b for every edge between two sites that comes or goes
    /// from now on, while advance() and the other functions are at work; from it those that change
    /// something throw std::logic_error. All that happens at one time is told at once, and nothing
    /// of what comes and goes within it.
    void watch(std::function<void(Index a, Index b, bool comes)> on_edge);

    /// What was done up to now.
    [[nodiscard]] KineticStatistics statistics() const noexcept;

 private:
    class State;
    void require(Index handle) const;
    void require_quiet() const;

    std::unique_ptr<State> state_;
};

}  // namespace signum
