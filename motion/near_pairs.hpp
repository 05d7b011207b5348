#pragma once
/// Which pairs may be the closest ones at some moment of a time in which nothing strikes. For
/// sources only.
///
/// Law: at each moment of it the closest pair, and all that are as close, are among those told.
/// Why: of a pair in one image the square root of a convex q is a convex gap, so that it is nowhere
/// greater than at one of the two ends. The least such number of the pairs seen is the bound; a
/// pair whose gap is greater all the time is never the closest one. All numbers are intervals.
///
/// Pairs are found in a tree of boxes (a k-d tree of where balls are in that time), in which nodes
/// that are farther apart than the bound are passed over together. What all have in common, the
/// fall, is left out of the boxes: so all fly straight, and a box is around two places.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "../filters/interval.hpp"
#include "gap.hpp"
#include "meeting.hpp"
#include "pair_tree.hpp"
#include "stop.hpp"

namespace signum::motion {

using filters::Interval;

[[nodiscard]] inline Interval hull(const Interval& a, const Interval& b) noexcept {
    return {filters::min(a.low, b.low), filters::max(a.high, b.high)};
}
/// Of what is not below 0 of an interval.
[[nodiscard]] inline Interval square_root(const Interval& a) noexcept {
    return {a.low > 0.0 ? std::sqrt(a.low) * (1.0 - filters::epsilon) : 0.0,
            std::sqrt(filters::max(a.high, 0.0)) * (1.0 + 2.0 * filters::epsilon)};
}
template <int D>
[[nodiscard]] Interval size_of(const PerAxis<Interval, D>& v) noexcept {
    return square_root(dot(v, v));
}

/// Gaps are those of balls that fly without kicks, and whose radii stay as they are. Throws
/// std::invalid_argument otherwise.
template <int D>
void require_free_flight(const Effects<D>& effects) {
    if (effects.growth || effects.time_step > 0.0)
        throw std::invalid_argument("who is near whom is told without growth and time steps alone");
}

/// Two balls, by their numbers a < b, and their gap: its least value is not below gap.low, and it
/// is nowhere above gap.high.
template <int D>
struct NearPair {
    std::int32_t a;
    std::int32_t b;
    Image<D> image;
    Interval gap;
};
/// Of equal gaps the pair with the smaller numbers is the closer one.
template <int D>
[[nodiscard]] std::pair<std::int32_t, std::int32_t> numbers_of(const NearPair<D>& pair) noexcept {
    return {pair.a, pair.b};
}
template <int D>
[[nodiscard]] Couple<D> couple_of(const NearPair<D>& pair,
                                  std::span<const Ball<D>> balls) noexcept {
    return {&balls[static_cast<std::size_t>(pair.a)], &balls[static_cast<std::size_t>(pair.b)],
            pair.image};
}

template <int D>
class NearPairs {
 public:
    static constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();
    /// All axes together. In a box four diameters wide a pair has 3^D, unless it flies far in the
    /// time.
    static constexpr double most_images = 0x1p20;

    /// Of balls that fly in [from, to] without a strike. Precondition: at least one; from and to
    /// are finite, and no own time is later than from; the default floating-point environment.
    NearPairs(std::span<const Ball<D>> balls, const Effects<D>& effects, double from, double to)
        : balls_(balls), effects_(effects), from_(from), time_(Interval(to) - Interval(from)) {
        if (from == to) time_ = Interval(0.0);
        if (effects.periodic) length_ = effects.box->lengths();
    }

    /// Those that may be the closest ones, each image of a pair for itself; nothing where they are
    /// more than a limit, where `stop` is told to, or, with a limit, where a pair has too many
    /// images (most_images). Throws std::range_error for the latter without a limit.
    [[nodiscard]] std::optional<std::vector<NearPair<D>>> closest(std::size_t limit,
                                                                  Stop& stop) const {
        std::vector<typename PairTree<D>::Place> boxes;
        boxes.reserve(balls_.size());
        for (const Ball<D>& ball : balls_) boxes.push_back(box_of(ball));
        const PairTree<D> tree(boxes, effects_);
        Found found{infinity, limit, {}};
        const bool all = tree.visit_pairs(
            [&] { return found.bound; },
            [&](std::uint32_t i, std::uint32_t j) { return !stop.turn() && look_at(i, j, found); });
        found.forget_far();
        if (!all) return std::nullopt;
        return std::move(found.pairs);
    }
    /// Those that may be the closest ones with a ball. Precondition: from == to.
    [[nodiscard]] std::vector<NearPair<D>> closest_to(std::uint32_t ball) const {
        for (const Ball<D>& each : balls_) box_of(each);
        Found found{infinity, no_limit, {}};
        for (std::uint32_t i = 0; i < balls_.size(); ++i)
            if (i != ball) look_at(ball, i, found);
        found.forget_far();
        return std::move(found.pairs);
    }
    /// Of a pair's gap in [from + low, from + high]: not below and not above.
    [[nodiscard]] Interval gap_between(const NearPair<D>& pair, double low, double high) const {
        const PerAxis<Linear<Interval>, D> d =
            difference_of_centres<Interval>(couple_of(pair, balls_), effects_, from_);
        PerAxis<Interval, D> at_low;
        PerAxis<Interval, D> at_high;
        for (int k = 0; k < D; ++k) {
            at_low[k] = d[k].c[0] + d[k].c[1] * Interval(low);
            at_high[k] = d[k].c[0] + d[k].c[1] * Interval(high);
        }
        return gap_of(at_low, at_high, radii_of(pair.a, pair.b));
    }
    /// Not less than how long it takes.
    [[nodiscard]] double duration() const noexcept { return time_.high; }

 private:
    struct Found {
        double bound;
        std::size_t limit;
        std::vector<NearPair<D>> pairs;

        void forget_far() {
            std::erase_if(pairs, [&](const NearPair<D>& pair) { return pair.gap.low > bound; });
        }
        bool add(const NearPair<D>& pair) {
            bound = std::min(bound, pair.gap.high);
            if (pair.gap.low > bound) return true;
            if (pairs.size() >= limit) {
                forget_far();
                if (pairs.size() >= limit) return false;
            }
            pairs.push_back(pair);
            return true;
        }
    };

    [[nodiscard]] const Ball<D>& ball(std::int32_t number) const noexcept {
        return balls_[static_cast<std::size_t>(number)];
    }
    [[nodiscard]] Interval radii_of(std::int32_t a, std::int32_t b) const noexcept {
        return Interval(ball(a).radius) + Interval(ball(b).radius);
    }

    typename PairTree<D>::Place box_of(const Ball<D>& ball) const {
        constexpr Interval half(0.5);
        const Interval since = Interval(from_) - Interval(ball.time);
        typename PairTree<D>::Place node;
        node.radius = ball.radius;
        for (int k = 0; k < D; ++k) {
            Interval v(ball.v[k]);
            Interval x = Interval(ball.x[k]) + v * since;
            if (effects_.gravity[k] != 0.0) {
                const Interval gained = Interval(effects_.gravity[k]) * since;
                v = v + gained;
                x = x + half * gained * since;
            }
            if (effects_.periodic) refuse_far(x, length_[k]);
            const Interval both = hull(x, x + v * time_);
            node.box.low[k] = both.low;
            node.box.high[k] = both.high;
        }
        return node;
    }
    static void refuse_far(const Interval& x, double length) {
        if (!(std::max(std::fabs(x.low), std::fabs(x.high)) <= 0x1p29 * length))
            throw std::range_error("a ball has flown more than 2^29 lengths of the periodic box");
    }

    /// Of a straight flight relative to one another: its ends, and the box around it.
    [[nodiscard]] static Interval gap_of(const PerAxis<Interval, D>& begin,
                                         const PerAxis<Interval, D>& end, const Interval& radii) {
        PerAxis<Interval, D> between;
        for (int k = 0; k < D; ++k) between[k] = filters::magnitude(hull(begin[k], end[k]));
        const Interval least = size_of(between) - radii;
        const Interval at_begin = size_of(begin) - radii;
        const Interval at_end = size_of(end) - radii;
        return {least.low, filters::max(at_begin.high, at_end.high)};
    }

    /// False where there are too many.
    bool look_at(std::uint32_t i, std::uint32_t j, Found& found) const {
        Seen seen{this, &found, {}, {}, {}, {}, {}};
        seen.pair.a = static_cast<std::int32_t>(std::min(i, j));
        seen.pair.b = static_cast<std::int32_t>(std::max(i, j));
        seen.radii = radii_of(seen.pair.a, seen.pair.b);
        const PerAxis<Linear<Interval>, D> d = difference_of_centres<Interval>(
            {&ball(seen.pair.a), &ball(seen.pair.b), {}}, effects_, from_);
        for (int k = 0; k < D; ++k) {
            seen.begin[k] = d[k].c[0];
            seen.end[k] = d[k].c[0] + d[k].c[1] * time_;
        }
        if (!effects_.periodic) return seen.add(seen.begin, seen.end);
        // An image that is about the nearest one at the beginning makes the bound finite.
        for (int k = 0; k < D; ++k)
            seen.pair.image[k] = static_cast<int>(std::floor(seen.begin[k].low / length_[k] + 0.5));
        const double near = seen.gap(seen.begin, seen.end).high;
        found.bound = std::min(found.bound, near);
        const double reach = std::max(seen.radii.high + found.bound, 0.0);
        double images = 1.0;
        for (int k = 0; k < D; ++k) {
            const Interval both = hull(seen.begin[k], seen.end[k]);
            const double low = (both.low - reach) / length_[k];
            const double high = (both.high + reach) / length_[k];
            constexpr double most = 0x1p31 - 1.0;
            images *= high - low + 1.0;
            if (!(images < most_images) || !(std::fabs(low) < most) || !(std::fabs(high) < most)) {
                if (found.limit == no_limit)
                    throw std::range_error(
                        "a pair of balls may be nearest in a million images: they fly too fast "
                        "for the clock, or are too large for the periodic box");
                return false;
            }
            seen.first[k] = static_cast<int>(std::ceil(low - 0x1p-40 * (1.0 + std::fabs(low))));
            seen.last[k] = static_cast<int>(std::floor(high + 0x1p-40 * (1.0 + std::fabs(high))));
        }
        return seen.images(0);
    }

    /// A pair in all images that may be near.
    struct Seen {
        const NearPairs* all;
        Found* found;
        PerAxis<Interval, D> begin;
        PerAxis<Interval, D> end;
        Interval radii;
        Image<D> first;
        Image<D> last;
        NearPair<D> pair{};

        [[nodiscard]] PerAxis<Interval, D> shifted(PerAxis<Interval, D> d) const {
            for (int k = 0; k < D; ++k)
                if (pair.image[k] != 0)
                    d[k] = d[k] - pair.image[k] * length<Interval>(all->effects_, k);
            return d;
        }
        [[nodiscard]] Interval gap(const PerAxis<Interval, D>& at_begin,
                                   const PerAxis<Interval, D>& at_end) const {
            return gap_of(shifted(at_begin), shifted(at_end), radii);
        }
        bool add(const PerAxis<Interval, D>& at_begin, const PerAxis<Interval, D>& at_end) {
            pair.gap = gap(at_begin, at_end);
            return found->add(pair);
        }
        bool images(int axis) {
            if (axis == D) return add(begin, end);
            for (int k = first[axis]; k <= last[axis]; ++k) {
                pair.image[axis] = k;
                if (!images(axis + 1)) return false;
            }
            return true;
        }
    };

    std::span<const Ball<D>> balls_;
    const Effects<D>& effects_;
    double from_;
    Interval time_;
    Vector<D> length_{};  // of a periodic box
};

}  // namespace signum::motion
