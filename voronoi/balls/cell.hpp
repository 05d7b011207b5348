#pragma once
/// Who may bound the cell of a ball, and in which directions: the search from ball to ball. For
/// sources only.
///
/// From the centre of ball i one goes in a direction u (a unit vector) up to the distance t at
/// which ball j takes over: |t u - X| = t + R, with X = c_j - c_i, R = r_j - r_i and P = X·X - R² >
/// 0 (none hides the other). Squared,
///     1/t = f_j(u) = (2 X·u + 2 R) / P,
/// where that is positive; else never. So the cell is what lies below the greatest of linear
/// functions, 0 among them for infinity; and the balls that touch the sphere around a point of its
/// boundary are those whose f is the greatest in that direction.
///
/// All directions are covered by patches, and each has a list of balls; one is left out where on
/// all of the patch it is certainly less than another, which may be left out in its turn: the
/// greatest is always in. Patches are divided as long as more balls are in than meet in a vertex.
///
/// At first only those are looked at that are near, with |X| - R no more than a reach: the f of the
/// others is at most 2 / (|X| - R), so that they are left out where the greatest f is certainly
/// more than 2 / reach. In the other patches the tree is asked. There, toward the outside, near
/// ones keep far ones out by F = f / |a| = (X·u + R) / |X|: where F_q < F_j and |a_q| <= |a_j|
/// either f_q < 0 or f_q < f_j, in each direction.
///
/// Where quarters of a patch keep having all of a long list, it is divided as bands.hpp says:
/// along a circle in bands, around one direction in a chart, with numbers of a hundred bits.
///
/// Laws:
///  1. for each direction some leaf's list has all balls whose f is the greatest there, if it is
///     positive;
///  2. where `may_be_unbounded` says no, the greatest is positive everywhere.
///
/// The bounds. u of a patch with centre v is v + w, |w| <= δ. With a = 2X/P, b = 2R/P the greatest
/// of f_q - f_j is at most (a_q - a_j)·v + b_q - b_j + δ |a_q - a_j|. X and R are each rounded
/// once, so that P errs by a part of 6 e (X·X + R²) / P = 6 e k, with e = 2^-53, and a and b by one
/// of (6 k + 4) e; the difference of f commits eight roundings or fewer of numbers that are below 3
/// (|a| + |b|): together (|a| + |b|) (32 + 16 k) e for each of the two balls. Where P is not
/// certain (k > 2^40), or unknown, the ball is in all lists and keeps nobody out.
/// Within a box
///     P (f - f_least) <= 2 X·v - f_least X·X + 2 δ |X| + 2 R + f_least R²
/// has its greatest value coordinate by coordinate (f_least may be that of the best ball in the
/// middle, and then changes by w·(2 X - P a) instead of 2 δ |X|), and commits twenty roundings or
/// fewer. Numbers are scaled, so that the largest is about 1, and of the others what lies below
/// 2^-1074 is lost, which is nothing beside |X| + |R| >= 2^-960; where P is small for a double, X
/// and R are multiplied by a power of two.
///
/// Of balls that are near one another and far from ball i these bounds tell nothing. Let D and E be
/// their differences in centre and radius, each rounded once. With h = (P_q - P_j) / 2 =
/// (D·(X_q + X_j) - E (R_q + R_j)) / 2
///     P_q (f_q - f_j) / 2 = (D - h a_j)·u + E - h b_j,
/// where every term is small as they are. h commits eight roundings or fewer of terms that together
/// are at most (|D| + |E|) s, s the sum of all |X| and |R|, and a and b the part e' = (32 + 16 k) e
/// at most: together (|D| + |E|) (1 + s (|a_j| + |b_j|)) e' for all of the patch. What underflows
/// is less than 2^-1000, which is added.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "../../core/index.hpp"
#include "../../core/site.hpp"
#include "../../predicates/space/ccw.hpp"
#include "../vector3.hpp"
#include "bands.hpp"
#include "patch.hpp"
#include "tree.hpp"

namespace signum::balls {

class CellSearch {
 public:
    /// The place in the tree of a ball that the search has met.
    using Place = std::uint32_t;

    /// `kinds` by place: balls of one kind, but 0, need no list where they are among themselves.
    /// `line`: that of all centres, if there is one, within 2^-49.
    CellSearch(const BallTree& tree, std::vector<std::uint32_t> kinds, std::optional<Point3> line)
        : tree_(tree), kinds_(std::move(kinds)), line_(line), slot_of_(tree.size(), no_slot) {}
    CellSearch(const CellSearch&) = delete;
    CellSearch& operator=(const CellSearch&) = delete;

    /// Calls leaf(places) with the list of each leaf, in which those balls come first whose name is
    /// greater than that of the ball; only those lists that have two such, not both of its kind.
    template <class Leaf>
    void run(Place ball, const Leaf& leaf) {
        start(ball);
        if (line_) return divide(Patch(*line_, 0.0, 1.0), near_, 0, 0, false, leaf);
        for (const Patch& patch : first_patches()) divide(patch, near_, 0, 0, false, leaf);
    }
    [[nodiscard]] bool may_be_unbounded() const noexcept { return may_be_unbounded_; }
    /// All that are in a list, whether that has been passed on or not: law 1 holds of these, too.
    [[nodiscard]] std::span<const Place> neighbours() const noexcept { return neighbours_; }

 private:
    /// a·u + b, with a bound on the error of this.
    struct Linear {
        Point3 a;
        double b;
        double length;  // of a
        double error;
    };
    struct Seen : Linear {
        // a and b, divided by that length: F
        Point3 n;
        double c;
        Place place;
        bool is_wild;
        bool is_later;
        bool is_of_its_kind;
        bool is_listed;
    };
    using Slot = std::uint32_t;
    static constexpr Slot no_slot = std::numeric_limits<Slot>::max();
    static constexpr std::size_t most_gathered = 60;
    static constexpr Place most_beside = 40;
    static constexpr int most_depth_of_near = 2;
    static constexpr std::size_t most_high = 12;
    static constexpr int most_depth = 14;

    void start(Place ball) {
        for (const Place place : places_) slot_of_[place] = no_slot;
        places_.clear();
        neighbours_.clear();
        near_.clear();
        seen_.clear();
        ball_ = ball;
        failures_ = 0;
        may_be_unbounded_ = false;
        // As far as half of those reach that are near in the tree.
        distances_.clear();
        const auto size = static_cast<Place>(tree_.size());
        const Place first = ball < most_beside ? 0 : ball - most_beside;
        const Place last = std::min(size, ball + most_beside + 1);
        for (Place place = first; place < last; ++place)
            if (place != ball) distances_.push_back(distance(tree_.ball(place)));
        reach_ = std::numeric_limits<double>::infinity();
        if (distances_.size() + 1 < size) {
            const auto middle =
                distances_.begin() + static_cast<std::ptrdiff_t>(distances_.size() / 2);
            std::nth_element(distances_.begin(), middle, distances_.end());
            reach_ = *middle;
        }
        take_near();
    }
    /// |X| - R
    [[nodiscard]] double distance(const Site3& j) const {
        const Site3& i = tree_.ball(ball_);
        return length(minus(centre3(j), centre3(i))) - (j.r - i.r);
    }
    /// How far a box is from the ball's centre along an axis.
    [[nodiscard]] static double away(const BallTree::Node& node, const std::array<double, 3>& from,
                                     std::size_t axis) {
        return std::max({node.low[axis] - from[axis], from[axis] - node.high[axis], 0.0});
    }
    /// All that are not certainly farther than the reach. So the f of all others is less than 2 /
    /// reach: its greatest value is 2 / (|X| - R).
    void take_near() {
        const Site3& i = tree_.ball(ball_);
        const std::array<double, 3> from{i.x, i.y, i.z};
        const auto is_near = [&](const BallTree::Node& node) {
            double square = 0.0;
            for (std::size_t k = 0; k < 3; ++k) square += away(node, from, k) * away(node, from, k);
            const double length = std::sqrt(square), more = node.high[3] - i.r;
            return !(length - more > reach_ + 0x1p-46 * (length + std::fabs(more)) + 0x1p-530);
        };
        tree_.visit(is_near, [&](Place place) {
            if (place == ball_) return;
            const Site3& j = tree_.ball(place);
            const double gap = distance(j);
            const double error = 0x1p-46 * (std::fabs(gap) + 2.0 * std::fabs(j.r - i.r)) + 0x1p-530;
            if (!(gap > reach_ + error)) near_.push_back(slot(place));
        });
    }
    /// |X| + |R|, or more.
    [[nodiscard]] static double size_from(const Site3& j, const Site3& i) {
        return std::fabs(j.x - i.x) + std::fabs(j.y - i.y) + std::fabs(j.z - i.z) +
               std::fabs(j.r - i.r);
    }
    /// A power of two, about 1 / size; 0 where differences are too small to be known.
    [[nodiscard]] static double unit_of(double size) {
        return size > 0x1p-960 ? std::ldexp(1.0, -std::ilogb(size)) : 0.0;
    }
    Slot slot(Place place) {
        if (slot_of_[place] != no_slot) return slot_of_[place];
        const Site3& i = tree_.ball(ball_);
        const Site3& j = tree_.ball(place);
        Point3 x = minus(centre3(j), centre3(i));
        double r = j.r - i.r;
        double square = dot(x, x);
        double both = square + r * r;
        Seen seen{};
        seen.place = place;
        double unit = 1.0;
        if (!(both > 0x1p-600)) [[unlikely]] {
            unit = unit_of(size_from(j, i));
            x = times(x, unit);
            r *= unit;
            square = dot(x, x);
            both = square + r * r;
        }
        const double p = square - r * r;
        seen.is_later = tree_.name(place) > tree_.name(ball_);
        seen.is_of_its_kind = kinds_[place] != 0 && kinds_[place] == kinds_[ball_];
        seen.is_wild = !(p > 0x1p-40 * both && p > 0x1p-700);
        if (!seen.is_wild) {
            const double factor = 2.0 / p * unit;
            seen.a = times(x, factor);
            seen.b = r * factor;
            seen.length = factor * std::sqrt(square);
            const double inverse = 1.0 / std::sqrt(square);
            seen.n = times(x, inverse);
            seen.c = r * inverse;
            seen.error = 0x1p-53 * (32.0 + 16.0 * (both / p)) * (seen.length + std::fabs(seen.b));
        }
        const auto number = static_cast<Slot>(seen_.size());
        slot_of_[place] = number;
        seen_.push_back(seen);
        places_.push_back(place);
        return number;
    }

    /// In the middle of the patch.
    [[nodiscard]] static double value(const Linear& f, const Patch& patch) {
        return dot(f.a, patch.v) + f.b;
    }
    [[nodiscard]] static double least(const Seen& q, const Patch& patch) {
        return value(q, patch) - patch.delta * q.length - q.error;
    }
    [[nodiscard]] static bool is_below_infinity(const Seen& q, const Patch& patch) {
        return !q.is_wild && value(q, patch) + patch.delta * q.length + q.error < 0.0;
    }
    [[nodiscard, gnu::always_inline]] bool is_below(const Seen& q, const Seen& j,
                                                    const Patch& patch) const {
        if (q.is_wild || j.is_wild) return false;
        return is_less(q, j, patch) ||
               (q.length + q.error <= j.length - j.error && is_lower(q, j, patch));
    }
    /// Whether f_q < f_j on all of the patch, none of them wild.
    [[nodiscard, gnu::always_inline]] bool is_less(const Seen& q, const Seen& j,
                                                   const Patch& patch) const {
        const Point3 a = minus(q.a, j.a);
        const double error = q.error + j.error;
        const double middle = dot(a, patch.v) + (q.b - j.b) + error;
        const double square = dot(a, a);
        if (is_beside(square, error)) [[unlikely]]
            return is_less_beside(q, j, patch);
        if (!(middle < 0.0)) return false;
        const double step = patch.delta * patch.delta * square;
        return middle * middle > step * (1.0 + 0x1p-48) + 0x1p-1000;
    }
    /// Whether the two are so near one another, seen from the ball, that f tells little of their
    /// difference; or so near the ball, that squares of a overflow.
    [[nodiscard]] static bool is_beside(double square, double error) {
        return !(square > 0x1p24 * error * error && square < 0x1p900);
    }

    /// P_q (f_q - f_j) / 2 in a patch.
    [[nodiscard]] Linear difference(const Seen& q, const Seen& j) const {
        const Site3& i = tree_.ball(ball_);
        const Site3& one = tree_.ball(q.place);
        const Site3& other = tree_.ball(j.place);
        const Point3 x = minus(centre3(one), centre3(other));
        const double r = one.r - other.r;
        const double size = size_from(other, i), unit = unit_of(size), inverse = 1.0 / unit;
        const Point3 sum = plus(minus(centre3(one), centre3(i)), minus(centre3(other), centre3(i)));
        const double h =
            0.5 * (dot(x, times(sum, unit)) - r * (((one.r - i.r) + (other.r - i.r)) * unit));
        Linear g{};
        g.a = minus(x, times(times(j.a, inverse), h));
        g.b = r - h * (j.b * inverse);
        g.length = std::hypot(g.a.x, g.a.y, g.a.z);
        const double of_j = j.length + std::fabs(j.b);
        const double terms = ((size_from(one, i) + size) * unit) * (of_j * inverse);
        g.error = size_from(one, other) * (1.0 + terms) * (j.error / of_j) + 0x1p-1000;
        return g;
    }
    /// is_less by the balls' own differences.
    [[nodiscard, gnu::noinline]] bool is_less_beside(const Seen& q, const Seen& j,
                                                     const Patch& patch) const {
        const Linear g = difference(q, j);
        return value(g, patch) + patch.delta * g.length * (1.0 + 0x1p-48) + g.error < 0.0;
    }

    [[nodiscard]] static double height(const Seen& q, const Patch& patch) {
        return dot(q.n, patch.v) + q.c;
    }
    /// Whether F_q < F_j on all of the patch.
    [[nodiscard]] static bool is_lower(const Seen& q, const Seen& j, const Patch& patch) {
        const Point3 n = minus(q.n, j.n);
        const double middle =
            dot(n, patch.v) + (q.c - j.c) + 0x1p-48 * (4.0 + std::fabs(q.c) + std::fabs(j.c));
        if (!(middle < 0.0)) return false;
        return middle * middle > patch.delta * patch.delta * dot(n, n) * (1.0 + 0x1p-46) + 0x1p-90;
    }

    [[nodiscard]] static const std::vector<Patch>& first_patches() {
        static const std::vector<Patch> patches = [] {
            std::vector<Patch> result;
            constexpr int side = 2;
            for (int face = 0; face < 6; ++face)
                for (int s = 0; s < side; ++s)
                    for (int t = 0; t < side; ++t)
                        result.emplace_back(face, (2.0 * s + 1.0) / side - 1.0,
                                            (2.0 * t + 1.0) / side - 1.0, 1.0 / side);
            return result;
        }();
        return patches;
    }

    // ---- from the tree --------------------------------------------------------------------------

    /// What a patch has found so far.
    struct Gathered {
        std::vector<Slot> list;
        double f_least = 0.0;
        Slot best = no_slot;
        double best_value = -std::numeric_limits<double>::infinity();
        // The highest F in the middle, of those known from the beginning.
        std::array<std::pair<double, Slot>, most_high> high;
        std::size_t number_of_high = 0;
    };
    void know(Gathered& gathered, Slot slot, const Patch& patch) const {
        const Seen& q = seen_[slot];
        if (q.is_wild) return;
        gathered.f_least = std::max(gathered.f_least, least(q, patch));
        const double its_value = value(q, patch);
        if (its_value <= gathered.best_value) return;
        gathered.best = slot;
        gathered.best_value = its_value;
    }

    void choose_high(Gathered& gathered, const std::vector<Slot>& known, const Patch& patch) const {
        high_.clear();
        for (const Slot slot : known)
            if (!seen_[slot].is_wild) high_.emplace_back(-height(seen_[slot], patch), slot);
        gathered.number_of_high = std::min(most_high, high_.size());
        std::partial_sort(high_.begin(),
                          high_.begin() + static_cast<std::ptrdiff_t>(gathered.number_of_high),
                          high_.end());
        for (std::size_t k = 0; k < gathered.number_of_high; ++k)
            gathered.high[k] = {-high_[k].first, high_[k].second};
    }
    template <class Leaf>
    void gather(const Patch& patch, int depth, const std::vector<Slot>& known, const Leaf& leaf) {
        Gathered gathered;
        for (const Slot slot : known) know(gathered, slot, patch);
        choose_high(gathered, known, patch);
        // Of balls of which many are the greatest together all along a circle small patches have as
        // many as large ones: so more are allowed, the smaller the patch.
        const std::size_t most =
            depth < most_depth ? most_gathered << (depth + depth / 2) : tree_.size();
        if (descend(patch, gathered, most))
            return divide(patch, gathered.list, depth, 0, true, leaf);
        for (int quarter = 0; quarter < 4; ++quarter)
            gather(patch.quarter(quarter), depth + 1, gathered.list, leaf);
    }

    /// Whether some ball in the node may be the greatest somewhere in the patch.
    [[nodiscard]] bool may_reach(const BallTree::Node& node, const Patch& patch,
                                 const Gathered& gathered) const;

    [[nodiscard]] bool is_below_any(Slot slot, const Gathered& gathered, const Patch& patch) const {
        for (std::size_t k = 0; k < gathered.number_of_high; ++k) {
            const Slot other = gathered.high[k].second;
            if (other != slot && is_below(seen_[slot], seen_[other], patch)) return true;
        }
        return false;
    }
    /// False where too many balls are found.
    bool descend(const Patch& patch, Gathered& gathered, std::size_t most) {
        const Site3& i = tree_.ball(ball_);
        const std::array<double, 3> from{i.x, i.y, i.z};
        // First the half that is nearer.
        const auto is_later = [&](const BallTree::Node& one, const BallTree::Node& other) {
            double nearness = 0.0;
            for (std::size_t k = 0; k < 3; ++k)
                nearness += away(other, from, k) - away(one, from, k);
            return !(nearness >= 0.0);
        };
        const auto take = [&](const BallTree::Node& node) {
            for (Place place = node.first; place < node.last; ++place) {
                if (place == ball_) continue;
                const Slot found = slot(place);
                know(gathered, found, patch);
                if (is_below_infinity(seen_[found], patch)) continue;
                if (gathered.best != no_slot && found != gathered.best &&
                    is_below(seen_[found], seen_[gathered.best], patch))
                    continue;
                if (is_below_any(found, gathered, patch)) continue;
                gathered.list.push_back(found);
            }
            return gathered.list.size() <= most;
        };
        return tree_.visit(
            [&](const BallTree::Node& node) { return may_reach(node, patch, gathered); }, is_later,
            take);
    }

    // ---- lists ----------------------------------------------------------------------------------

    /// `steady`: how many divisions have left as many in the list. `is_complete`: whether the list
    /// has been gathered from the whole tree, and not from what is near alone.
    template <class Leaf>
    void divide(const Patch& patch, const std::vector<Slot>& above, int depth, int steady,
                bool is_complete, const Leaf& leaf) {
        std::vector<Slot>& list = list_at(depth);
        list.clear();
        Gathered best;
        for (const Slot slot : above) know(best, slot, patch);
        for (const Slot slot : above) {
            if (is_below_infinity(seen_[slot], patch)) continue;
            if (slot != best.best && best.best != no_slot &&
                is_below(seen_[slot], seen_[best.best], patch))
                continue;
            list.push_back(slot);
        }
        if (list.size() > most_in_pairs && steady > 0) take_out_below_highest(list, patch);
        // Where the greatest f is positive, shorter ones that are lower matter little.
        const bool is_open = !(best.f_least > 0.0);
        if (list.size() > 2 && list.size() <= most_in_pairs) {
            sorted_.clear();
            for (const Slot slot : list)
                sorted_.emplace_back(seen_[slot].is_wild ? HUGE_VAL : value(seen_[slot], patch),
                                     slot);
            std::sort(sorted_.begin(), sorted_.end(), std::greater<>());
            list.clear();
            for (std::size_t q = 0; q < sorted_.size(); ++q) {
                const Seen& one = seen_[sorted_[q].second];
                const bool is_out =
                    is_less_than_later(q, patch) ||
                    std::any_of(list.begin(), list.end(),
                                [&](Slot j) {
                                    return !one.is_wild && !seen_[j].is_wild &&
                                           is_less(one, seen_[j], patch);
                                }) ||
                    (is_open && std::any_of(sorted_.begin(), sorted_.end(), [&](const auto& j) {
                         return j.second != sorted_[q].second &&
                                is_below(one, seen_[j.second], patch);
                     }));
                if (!is_out) list.push_back(sorted_[q].second);
            }
        }
        if (!is_complete && !(best.f_least * reach_ > 2.0 + 0x1p-40)) {
            const std::vector<Slot> own = list;
            if (depth >= most_depth_of_near) return gather(patch, depth, own, leaf);
            for (int quarter = 0; quarter < 4; ++quarter)
                divide(patch.quarter(quarter), own, depth + 1, 0, false, leaf);
            return;
        }
        // Those that are wild remain, however small the patch.
        std::size_t tame = 0, later = 0, of_other_kinds = 0;
        for (const Slot slot : list) {
            tame += !seen_[slot].is_wild;
            later += seen_[slot].is_later;
            of_other_kinds += seen_[slot].is_later && !seen_[slot].is_of_its_kind;
        }
        const bool is_to_be_divided = of_other_kinds == 0
                                          ? steady < most_steady_of_a_kind
                                          : steady < most_steady || later > most_at_once;
        if (tame > most_in_a_list && later >= 3 && depth < most_depth && is_to_be_divided) {
            if (tame > most_at_once && of_other_kinds > 0 &&
                divide_finely(patch, list, steady, leaf))
                return;
            const int now_steady = list.size() == above.size() ? steady + 1 : 0;
            const std::vector<Slot> own = list;
            for (int quarter = 0; quarter < 4; ++quarter)
                divide(patch.quarter(quarter), own, depth + 1, now_steady, true, leaf);
            return;
        }
        finish(list, is_open, later, of_other_kinds, leaf);
    }
    /// Passes a list on, of which so many are later, and of these so many of other kinds.
    template <class Leaf>
    [[gnu::always_inline]] void finish(std::vector<Slot>& list, bool is_open, std::size_t later,
                                       std::size_t of_other_kinds, const Leaf& leaf) {
        may_be_unbounded_ |= is_open;
        for (const Slot slot : list)
            if (!std::exchange(seen_[slot].is_listed, true)) neighbours_.push_back(places_[slot]);
        if (later < 2 || of_other_kinds == 0) return;
        std::partition(list.begin(), list.end(), [&](Slot slot) { return seen_[slot].is_later; });
        leaf_.clear();
        for (const Slot slot : list) leaf_.push_back(places_[slot]);
        leaf(std::span<const Place>(leaf_), later);
    }
    /// Whether one of sorted_ is less than one that follows it, but whose value may be the greater.
    [[nodiscard]] bool is_less_than_later(std::size_t number, const Patch& patch) const {
        const auto& [its_value, slot] = sorted_[number];
        const Seen& one = seen_[slot];
        if (one.is_wild) return false;
        for (std::size_t k = number + 1; k < sorted_.size(); ++k) {
            const Seen& other = seen_[sorted_[k].second];
            if (sorted_[k].first + other.error + one.error < its_value) return false;
            if (is_less(one, other, patch)) return true;
        }
        return false;
    }
    /// Of a long list: those that are less than one of the few that are the highest in the middle.
    /// The highest of all may be so there alone, and one of many far balls the next.
    void take_out_below_highest(std::vector<Slot>& list, const Patch& patch) const {
        constexpr std::size_t most_highest = 16;
        for (std::size_t k = 0; k < most_highest && list.size() > most_in_pairs; ++k) {
            std::size_t top = list.size();
            for (std::size_t m = k; m < list.size(); ++m) {
                const Seen& q = seen_[list[m]];
                if (q.is_wild) continue;
                if (top == list.size() || is_higher(q, seen_[list[top]], patch)) top = m;
            }
            if (top == list.size()) return;
            std::swap(list[k], list[top]);
            const Seen& highest = seen_[list[k]];
            const auto is_out = [&](Slot slot) {
                return !seen_[slot].is_wild && is_less(seen_[slot], highest, patch);
            };
            list.erase(std::remove_if(list.begin() + static_cast<std::ptrdiff_t>(k) + 1, list.end(),
                                      is_out),
                       list.end());
        }
    }
    /// In the middle of the patch, as far as that is known.
    [[nodiscard]] bool is_higher(const Seen& q, const Seen& j, const Patch& patch) const {
        const double difference_of_f = value(q, patch) - value(j, patch);
        if (std::fabs(difference_of_f) > q.error + j.error) return difference_of_f > 0.0;
        return value(difference(q, j), patch) > 0.0;
    }

    // ---- finely ---------------------------------------------------------------------------------

    /// A ball in the list of a band or a chart.
    struct Member {
        std::uint32_t number;  // in forms_
        DoubleDouble value;    // in the middle
    };

    /// Divides a patch in bands, where the a of the list are nearly on a line, or in a chart, where
    /// the patch is small and the list still long. False where it is neither, where numbers are out
    /// of range, and where it takes too long: some leaves may have been passed on then.
    template <class Leaf>
    [[gnu::noinline]] bool divide_finely(const Patch& patch, const std::vector<Slot>& list,
                                         int steady, const Leaf& leaf);
    /// Whether the a of most balls lie nearly on a line of this direction, also with those that are
    /// nearest along it.
    [[nodiscard]] bool are_on_a_line(const std::vector<Slot>& list, const Point3& axis);
    template <class Region, class Leaf>
    [[gnu::noinline]] void halve(const Region& region, std::size_t depth, const Leaf& leaf);
    /// Of a form's change in a region, with its error.
    template <class Region>
    [[nodiscard]] static double bound(const Region& region, double x, double y, double z, double b,
                                      double error) {
        return region.change(x, y, z, b) * (1.0 + 0x1p-40) + error + 0x1p-500;
    }
    [[nodiscard]] static double difference(const DoubleDouble& a, const DoubleDouble& b) {
        return (a.high - b.high) + (a.low - b.low);
    }
    /// Whether f_q < f_j on all of the region.
    template <class Region>
    [[nodiscard]] bool is_less(const Member& q, const Member& j, const Region& region) const {
        const double middle = difference(q.value, j.value);
        if (!(middle < 0.0)) return false;
        const FineForm& one = forms_[q.number];
        const FineForm& other = forms_[j.number];
        return bound(region, difference(one.x, other.x), difference(one.y, other.y),
                     difference(one.z, other.z), difference(one.b, other.b),
                     one.error + other.error) < -middle * (1.0 - 0x1p-40);
    }
    /// Those that are less than another one: of a long list, than one that is the greatest in the
    /// middle or toward an end. Of the others the greatest in the middle come first.
    template <class Region>
    [[gnu::noinline]] void take_out_less(std::vector<Member>& list, const Region& region);

    std::vector<Slot>& list_at(int depth) {
        if (lists_.size() <= static_cast<std::size_t>(depth))
            lists_.resize(static_cast<std::size_t>(depth) + 1);
        return lists_[static_cast<std::size_t>(depth)];
    }
    static constexpr std::size_t most_in_pairs = 32;
    static constexpr std::size_t most_in_a_list = 5;
    static constexpr int most_steady = 4;
    static constexpr int most_steady_of_a_kind = 1;
    static constexpr std::size_t most_at_once = 12;
    static constexpr int least_steady_of_charts = 3;
    static constexpr std::size_t most_depth_of_halvings = 200;
    /// Of one patch, and how many patches of a cell may come to more.
    static constexpr int most_halvings = 10'000;
    static constexpr int most_failures = 2;

    const BallTree& tree_;
    std::vector<std::uint32_t> kinds_;  // by place
    std::optional<Point3> line_;
    Place ball_ = 0;
    bool may_be_unbounded_ = false;
    std::vector<Slot> slot_of_;  // by place
    std::vector<Place> places_;  // by slot
    std::vector<Seen> seen_;
    std::vector<Place> neighbours_;
    mutable std::vector<std::pair<double, Slot>> high_;
    std::vector<std::pair<double, Slot>> sorted_;
    // What is near: |X| - R is at most the reach.
    double reach_ = 0.0;
    std::vector<Slot> near_;
    std::vector<double> distances_;
    std::vector<std::vector<Slot>> lists_;
    std::vector<Place> leaf_;
    // Of the patch that is divided finely: its balls' functions in the frame, and those that have
    // none.
    int halvings_left_ = 0;
    int failures_ = 0;
    std::vector<FineForm> forms_;
    std::vector<Slot> slots_of_forms_;
    std::vector<Slot> wild_;
    std::vector<Slot> fine_list_;
    std::vector<std::vector<Member>> members_;
};

}  // namespace signum::balls

#include "cell_finely.hpp"
#include "cell_tree.hpp"
