/// The list of closest pairs: the least of many gaps as time goes on, from strike to strike.

#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "../exact/floating_environment.hpp"
#include "gap.hpp"
#include "near_pairs.hpp"
#include "queries.hpp"
#include "stop.hpp"

namespace signum::motion {
namespace {

/// 0 at a time, which is none of `from`.
struct Instant {
    double from;
    double time;
    template <class Number>
    [[nodiscard]] roots::PolynomialIn<Number, 1> in() const {
        return roots::line<Number>(from, 1.0) - roots::constant<Number>(time);
    }
};

template <int D>
class List {
 public:
    /// None is copied.
    List(const Effects<D>& effects, Stop& stop, ClosestPairs& result)
        : effects_(effects), stop_(stop), result_(result) {}

    /// Goes on with balls that fly in [from, to] without a strike; where it is stopped, up to the
    /// last pair of the list. Precondition: at least two balls; the default floating-point
    /// environment.
    void add(std::span<const Ball<D>> balls, double from, double to) {
        if (stop_.is_told()) return;
        const NearPairs<D> near(balls, effects_, from, to);
        const std::size_t usual = 2 * balls.size() + 64;
        std::optional<std::vector<NearPair<D>>> pairs = near.closest(usual, stop_);
        if (!pairs) {
            const double middle = from + 0.5 * (to - from);
            const bool is_between = from < middle && middle < to;
            std::size_t limit = NearPairs<D>::no_limit;
            if (is_between) {
                // As many may be equally close at any moment.
                const NearPairs<D> then(balls, effects_, middle, middle);
                const auto tied = then.closest(NearPairs<D>::no_limit, stop_);
                if (!tied) return;
                limit = usual + 2 * tied->size();
            }
            pairs = near.closest(limit, stop_);
            if (!pairs && !stop_.is_told()) {
                add(balls, from, middle);
                add(balls, middle, to);
                return;
            }
        }
        if (pairs) Walk(*this, balls, near, *pairs, from, to).go();
        if (!stop_.is_told()) result_.time = to;
    }

 private:
    /// From the closest pair to the one that comes below it first, and on.
    class Walk {
     public:
        Walk(List& list, std::span<const Ball<D>> balls, const NearPairs<D>& near,
             const std::vector<NearPair<D>>& pairs, double from, double to)
            : list_(list),
              balls_(balls),
              near_(near),
              pairs_(pairs),
              from_(from),
              to_(to),
              end_(Instant{from, to}),
              root_of_end_(end_.polynomial.real_roots()[0]) {}

        void go() {
            best_ = &pairs_.front();
            double least = gap_between(*best_, 0.0, 0.0).high;
            for (const NearPair<D>& pair : pairs_) {
                if (list_.stop_.turn()) return;
                if (pair.gap.low > least) continue;
                const Interval gap = gap_between(pair, 0.0, 0.0);
                if (gap.low > least || !is_closer(pair, *best_, now_)) continue;
                best_ = &pair;
                least = gap.high;
            }
            put();
            if (from_ == to_) return;
            while (find_next()) put();
        }

     private:
        /// Right after a moment.
        [[nodiscard]] bool is_closer(const NearPair<D>& pair, const NearPair<D>& other,
                                     const Moment<D>& moment) const {
            if (&pair == &other) return false;
            const Sign order = order_of(pair, other).after(moment);
            return order < 0 || (order == 0 && numbers_of(pair) < numbers_of(other));
        }
        [[nodiscard]] GapOrder<D> order_of(const NearPair<D>& p, const NearPair<D>& q) const {
            return {couple_of(p, balls_), couple_of(q, balls_), list_.effects_, from_};
        }
        [[nodiscard]] Interval gap_between(const NearPair<D>& pair, double low, double high) const {
            return near_.gap_between(pair, low, high);
        }
        [[nodiscard]] bool is_before_end(const Moment<D>& moment) const {
            return compare(roots::RootOf{moment.curve->polynomial, moment.root},
                           roots::RootOf{end_.polynomial, root_of_end_}) < 0;
        }

        /// The next pair, and the moment from which on it is the closest one; none where it is
        /// stopped.
        bool find_next() {
            const double low = filters::max(0.0, now_.root.low);
            double high = near_.duration();
            double most = gap_between(*best_, low, high).high;
            const NearPair<D>* next = nullptr;
            std::optional<Moment<D>> when;
            for (const NearPair<D>& pair : pairs_) {
                if (list_.stop_.turn()) return false;
                if (&pair == best_ || pair.gap.low > most ||
                    gap_between(pair, low, high).low > most)
                    continue;
                const std::optional<Moment<D>> moment =
                    order_of(pair, *best_)
                        .first_less(now_, numbers_of(pair) < numbers_of(*best_),
                                    [&](const Moment<D>& each) { return is_before_end(each); });
                if (!moment) continue;
                const Sign order = when ? compare(*moment, *when) : -1;
                if (order > 0 || (order == 0 && !is_closer(pair, *next, *moment))) continue;
                next = &pair;
                when = moment;
                high = filters::min(high, when->root.high);
                most = gap_between(*best_, low, high).high;
            }
            if (next == nullptr) return false;
            best_ = next;
            now_ = *when;
            return true;
        }

        void put() {
            std::vector<ClosestPair>& list = list_.result_.pairs;
            const double time = now_.nearest_time(from_);
            list_.result_.time = time;
            if (!list.empty() && list.back().a == best_->a && list.back().b == best_->b) return;
            const Gap gap(couple_of(*best_, balls_), list_.effects_, time);
            list.push_back({time, best_->a, best_->b, gap.nearest_double()});
        }

        List& list_;
        std::span<const Ball<D>> balls_;
        const NearPairs<D>& near_;
        const std::vector<NearPair<D>>& pairs_;
        double from_;
        double to_;
        Curve<Instant> end_;
        roots::Root root_of_end_;
        const NearPair<D>* best_ = nullptr;
        Moment<D> now_{};
    };

    const Effects<D>& effects_;
    Stop& stop_;
    ClosestPairs& result_;
};

}  // namespace

template <int D>
ClosestPairs closest_pairs(const State<D>& state, const Effects<D>& effects, double begin,
                           double end, const Options& options,
                           const std::function<bool(double)>& stop) {
    if (!(state.time <= begin && begin <= end && std::isfinite(end)))
        throw std::invalid_argument(
            "closest_pairs: give a begin that is not before the state, and a later, finite end");
    require_free_flight(effects);
    ClosestPairs result;
    result.time = begin;
    std::function<bool()> asked;
    if (stop) asked = [&] { return stop(result.time); };
    Simulation<D> ahead(state, effects, options);
    result.outcome = ahead.run({.until = begin, .stop = asked});
    const auto is_over = [&] {
        return result.outcome.ending == Ending::collapse ||
               result.outcome.ending == Ending::stopped;
    };
    if (is_over()) return result;
    if (state.balls.size() < 2) {
        result.time = end;
        return result;
    }
    Stop told_to_stop(asked);
    List<D> list(effects, told_to_stop, result);
    for (double from = begin;;) {
        const State<D> now = ahead.state();
        double to = end;
        result.outcome = ahead.run({.until = end, .strikes = 1, .stop = asked},
                                   [&](const Strike& strike) { to = strike.time; });
        if (result.outcome.ending == Ending::stopped) break;
        if (result.outcome.ending == Ending::collapse) to = result.outcome.last.time;
        if (from < to || result.pairs.empty()) {
            const exact::IeeeEnvironment environment;
            list.add(now.balls, from, to);
        }
        from = to;
        const bool is_last = result.outcome.ending != Ending::strikes;
        if (told_to_stop.is_told() || (!is_last && told_to_stop.ask())) {
            result.outcome = {Ending::stopped, {}};
            break;
        }
        if (is_last) break;
    }
    return result;
}

template ClosestPairs closest_pairs(const State<2>&, const Effects<2>&, double, double,
                                    const Options&, const std::function<bool(double)>&);
template ClosestPairs closest_pairs(const State<3>&, const Effects<3>&, double, double,
                                    const Options&, const std::function<bool(double)>&);

}  // namespace signum::motion
