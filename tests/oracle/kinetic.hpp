#pragma once
/// Brute force for the power triangulation of sites that move in the plane: the polynomials of all
/// pairs, triples and quadruples, their roots by Sturm's theorem, and between any two neighbouring
/// roots the triangles whose power circles are empty, all in rationals.
///
/// What is meant, where the design leaves it open:
///
/// - Time is a rational. A root is a real algebraic number: it is given by an interval that holds
///   no other root of any polynomial here, and by the double nearest to it, halves to even. Roots
///   are compared exactly, never as doubles; two different ones may have the same double.
/// - Only the open interval (begin, end) is looked at. What happens at `begin` or `end` themselves
///   is no event, and is not seen.
/// - The triangulation is the set of its triangles of three sites, counterclockwise, the smallest
///   number first, sorted: as in `Tessellation`, without the infinite faces. Three sites alone that
///   turn round thus change it. With fewer than three sites, and while all are on one line, it is
///   empty, whatever happens to the chain on that line.
/// - A triangle counts where no other site is nearer, in the power metric, to the centre of its
///   power circle than its corners are. If another one is exactly as near, four are tied. Hidden
///   sites are not listed: a site in no triangle is hidden, or on one line with all the others.
/// - Three on a line are a tie where the line bounds the hull of all centres, hidden ones included,
///   for a site that leaves the hull is no longer hidden. Such a tie leaves the set of triangles
///   determined: no power circle has a part in it.
/// - There is no tie rule here: ties are reported. A polynomial that is identically 0 is no event;
///   it is listed apart. It matters where its four sites are on one empty power circle between two
///   events; then there is no answer without a rule, and none is given. Four sites always on one
///   line, or three on a side of the hull, do not matter in this sense.
/// - What is different at an event's very time only, and the same before and after (two equal sites
///   that meet beside a heavier one that hides both, a circle that is touched) changes nothing.

#include "linear_form.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace signum::oracle::kinetic {

/// At time t the centre is (x, y) + (vx, vy)·(t - t0), plus half of g·(t - t0)² where all fall
/// alike. The weight is r² + w, exact: one of the two is meant to be given.
struct Site {
    double x = 0, y = 0, vx = 0, vy = 0;
    double t0 = 0;
    double r = 0;
    double w = 0;
};

/// What all fall with.
using Fall = std::array<double, 2>;

using Triangle = std::array<std::int32_t, 3>;
using Triangles = std::vector<Triangle>;

/// Two centres (do they coincide?), three (on which side?) or four (in the circle?), numbers
/// rising. The signs are those of ccw, and of the determinant of geometry.md with the last of the
/// four as the query and the others as they stand; for two, 0 when they coincide, else 1.
struct Certificate {
    std::vector<std::int32_t> sites;
    int before = 0, after = 0;  // 0 at the event itself
    friend bool operator==(const Certificate&, const Certificate&) = default;
};

/// A time at which something is 0 that mostly is not: low <= time <= high, and no other candidate
/// is in [low, high], which is no wider than 2^-60 of what was looked at; low == high where the
/// time itself is known as a rational.
struct Event {
    Rational low, high;
    double nearest = 0;
    std::vector<Certificate> certificates;  // all that are 0; by size, then numbers
};

struct Candidates {
    std::vector<Event> events;      // in order
    std::vector<Rational> between;  // one more: a time before, between and after them
    std::vector<std::vector<std::int32_t>> always;  // what is identically 0: pairs, triples, fours
};

/// All candidates in (begin, end): whether they change the triangulation is not asked.
Candidates events(std::span<const Site> sites, const Rational& begin, const Rational& end,
                  const Fall& g = {});

struct Snapshot {
    Triangles triangles;                               // those that are not tied
    std::vector<std::array<std::int32_t, 4>> circles;  // on one empty power circle
    std::vector<std::array<std::int32_t, 3>> lines;    // on one line that bounds the hull
    bool is_tied() const { return !circles.empty() || !lines.empty(); }
};

/// By the definition, from the positions at t; no determinant of `events` is used.
Snapshot faces_at(std::span<const Site> sites, const Rational& t, const Fall& g = {});

struct Change {
    Event event;
    bool several = false;  // more than one certificate is 0 at that time
    Triangles before, after;
};

struct Epochs {
    Triangles first;              // after `begin`
    std::vector<Change> changes;  // in order; none where something is tied for ever
    std::vector<std::array<std::int32_t, 4>> tied;  // on an empty circle all through an epoch
};

Epochs epochs(std::span<const Site> sites, const Rational& begin, const Rational& end,
              const Fall& g = {});

}  // namespace signum::oracle::kinetic
