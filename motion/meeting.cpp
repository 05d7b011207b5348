#include "meeting.hpp"

#include <cstring>

#include "../core/processor.hpp"
#include "../filters/four.hpp"

namespace signum::motion {
namespace {

using filters::Flags;
using filters::Four;
using filters::lanes;
using filters::magnitude;
using filters::square_root;

static_assert(Crowd::capacity % lanes == 0);

/// The numbers of four balls, column by column: x, v, radius, time.
template <int D>
[[gnu::always_inline]] inline void load(Four (&columns)[2 * D + 2],
                                        const Ball<D>* const (&balls)[lanes]) noexcept {
    static_assert(offsetof(Ball<D>, time) == (2 * D + 1) * sizeof(double));
    // Two numbers at a time, which takes far fewer instructions than one.
    for (int k = 0; k < 2 * D + 2; k += 2) {
        filters::Two two[lanes];
        for (std::size_t lane = 0; lane < lanes; ++lane)
            std::memcpy(&two[lane], reinterpret_cast<const double*>(balls[lane]) + k,
                        sizeof(filters::Two));
        const Four even = __builtin_shufflevector(two[0], two[2], 0, 1, 2, 3);
        const Four odd = __builtin_shufflevector(two[1], two[3], 0, 1, 2, 3);
        columns[k] = __builtin_shufflevector(even, odd, 0, 4, 2, 6);
        columns[k + 1] = __builtin_shufflevector(even, odd, 1, 5, 3, 7);
    }
}
[[gnu::always_inline]] inline void raise(Four& largest, const Four& numbers) noexcept {
    Four magnitudes;
    magnitude(magnitudes, numbers);
    largest = magnitudes > largest ? magnitudes : largest;
}

constexpr double least_square = 0x1p-600;

/// s from now on, but for an error; the bounds of t's own rounding included.
[[gnu::always_inline]] inline Meeting around(double now, double s, double error) noexcept {
    const double t = now + s;
    const double either_way = 2.0 * error + 0x1p-50 * t;
    return {std::max(t - either_way, now), t + either_way};
}

/// How long until gap + v s + g s²/2 falls through 0 or, where it is not above, begins to fall; in
/// plain doubles.
double naive_descent(double gap, double v, double g) noexcept {
    if (v >= 0.0 && g >= 0.0) return infinity;
    if (gap <= 0.0) return v < 0.0 ? 0.0 : v / -g * (v * v > 2.0 * g * gap ? 2.0 : 1.0);
    const double square = v * v - 2.0 * g * gap;
    if (square <= 0.0) return infinity;
    return v < 0.0 ? 2.0 * gap / (std::sqrt(square) - v) : (v + std::sqrt(square)) / -g;
}

/// What the inner loop is compiled for.
template <bool Falls, bool Grows, Kernel kernel>
struct Flight {
    static constexpr bool falls = Falls;
    static constexpr bool grows = Grows;
    static constexpr bool exact = kernel == Kernel::exact;
};

}  // namespace

template <int D>
template <class Flight>
[[gnu::always_inline]] inline void MeetingFilter<D>::Asker::fill(const Ball<D>* all,
                                                                 Crowd& crowd) const noexcept {
    const Bounds<D>& bounds = *bounds_;
    Four soonest = Four{} + infinity;
    // The last one stands for those that are missing.
    for (std::size_t k = crowd.size; k % lanes != 0; ++k) crowd.who[k] = crowd.who[k - 1];
    for (std::size_t first = 0; first < crowd.size; first += lanes) {
        const Ball<D>* balls[lanes];
        for (std::size_t k = 0; k < lanes; ++k) balls[k] = &all[crowd.who[first + k]];
        Four columns[2 * D + 2];
        load<D>(columns, balls);
        Four r = columns[2 * D] + radius_;
        const Four rate = r * bounds.growth;
        if constexpr (Flight::grows) r *= 1.0 + bounds.growth * now_;
        const Four dt = now_ - columns[2 * D + 1];
        Four product{};
        Four square{};
        Four distance{};
        Four largest{};
        // Whoever falls alike from the same time on rests as exactly as who does not fall.
        Flags rests = Flags{} - 1;
        if constexpr (Flight::falls) rests = columns[2 * D + 1] == own_->time;
        for (int i = 0; i < D; ++i) {
            Four v = columns[D + i];
            if constexpr (Flight::falls) rests &= v == own_->v[i];
            const Four flown = v * dt;
            Four d = columns[i] + flown;
            raise(largest, flown);
            if constexpr (Flight::falls) {
                const Four fallen = 0.5 * bounds.gravity[i] * (dt * dt);
                d += fallen;
                v += bounds.gravity[i] * dt;
                raise(largest, fallen);
            }
            raise(largest, d);
            d = place_.x[i] - d;
            v = place_.v[i] - v;
            if (bounds.periodic) {
                const Four turns = (d * bounds.inverse_length[i] + where_doubles_are_integers) -
                                   where_doubles_are_integers;
                d -= bounds.length[i] * turns;
            }
            product += d * v;
            square += v * v;
            distance += d * d;
            if constexpr (!Flight::falls) rests &= v == 0.0;
        }
        const Four gap = distance - r * r;
        // S, and A.
        Four sizes = square;
        if constexpr (Flight::grows) {
            product -= r * rate;
            sizes += rate * rate;
            square -= rate * rate;
        }
        const Four discriminant = product * product - square * gap;
        Four root;
        square_root(root, discriminant > 0.0 ? discriminant : Four{});
        const Four sum = root - product;
        Four early;
        Four late;
        if constexpr (!Flight::exact) {
            Four t = now_ + gap / sum;
            t = t > now_ ? t : Four{} + now_;
            Flags meets = product < 0.0;
            if constexpr (Flight::grows) meets |= square < 0.0;
            early = (meets & (discriminant > 0.0)) ? t : Four{} + infinity;
            late = early;
        } else {
            const Four size = Flight::falls || Flight::grows ? sizes + bounds.speed_square : square;
            // One division for both quotients, s = gap / sum and K / root.
            const Four inverse = 1.0 / (root * sum);
            const Four s = gap * (root * inverse);
            const Four t = now_ + s;
            Four error = bounds.gap_error * (sum * inverse);
            if constexpr (Flight::grows)
                error *= 2.0 + 4.0 * (s * s) * (size / (bounds.extent * bounds.extent));
            else if constexpr (Flight::falls)
                error = bounds.gap_error * inverse *
                        (root + s * (root * (bounds.speed / bounds.extent) + size));
            Four toward;
            magnitude(toward, product);
            // Velocities that are the same are so exactly, unless something was added to them.
            const Flags known = (sizes > least_square) & (largest <= bounds.extent);
            constexpr double times = Flight::grows ? 2.0 : 1.0;
            Flags recedes = product * toward > bounds.product_error * size;
            Flags passes = discriminant < -times * bounds.gap_error * size;
            if constexpr (Flight::grows) {
                recedes &= square > 0x1p-40 * size;
                passes &= gap > bounds.gap_error;
            }
            Flags misses = (recedes | passes) & known;
            if constexpr (!Flight::grows) misses |= rests;
            const Flags tells = (discriminant > 2.0 * times * bounds.gap_error * size) &
                                (gap > bounds.gap_error) & (product < 0.0) & known;
            const Four either_way = 2.0 * error + 0x1p-49 * t;
            early = t - either_way;
            early = early > now_ ? early : Four{} + now_;
            late = t + either_way;
            const Four otherwise = misses ? Four{} + infinity : Four{} - infinity;
            early = tells ? early : otherwise;
            late = tells ? late : Four{} + infinity;
        }
        std::memcpy(&crowd.early[first], &early, sizeof early);
        std::memcpy(&crowd.late[first], &late, sizeof late);
        soonest = late < soonest ? late : soonest;
    }
    crowd.soonest = std::min(std::min(soonest[0], soonest[1]), std::min(soonest[2], soonest[3]));
}

template <int D>
template <class Flight>
void MeetingFilter<D>::Asker::answer(const Asker& asker, const Ball<D>* balls,
                                     Crowd& crowd) noexcept {
    as_wide_as_possible([&]() __attribute__((always_inline)) {
        asker.template fill<Flight>(balls, crowd);
    });
}

template <int D>
MeetingFilter<D>::MeetingFilter(const Effects<D>& effects, Kernel kernel)
    : falls_(effects.gravity != Vector<D>{}), kernel_(kernel) {
    bounds_.gravity = effects.gravity;
    bounds_.periodic = effects.periodic;
    if (effects.growth) {
        bounds_.growth = effects.growth->rate;
        largest_growth_ = largest_growth(*effects.growth);
    }
    if (effects.box) {
        bounds_.length = effects.box->lengths();
        for (int i = 0; i < D; ++i) {
            include(effects.box->low[i]);
            include(effects.box->high[i]);
            bounds_.inverse_length[i] = 1.0 / bounds_.length[i];
        }
    }
    const auto choose = [&]<Kernel k>() -> typename Asker::Answer {
        if (effects.growth) return Asker::template answer<Flight<true, true, k>>;
        if (falls_) return Asker::template answer<Flight<true, false, k>>;
        return Asker::template answer<Flight<false, false, k>>;
    };
    answer_ = kernel == Kernel::exact ? choose.template operator()<Kernel::exact>()
                                      : choose.template operator()<Kernel::naive>();
}

template <int D>
Place<D> MeetingFilter<D>::include(const Ball<D>& ball, double now) noexcept {
    Place<D> place;
    const double dt = now - ball.time;
    double farthest = 0.0;
    double fastest = 0.0;
    for (int i = 0; i < D; ++i) {
        const double flown = ball.v[i] * dt;
        farthest = std::max(farthest, filters::magnitude(flown));
        double& x = place.x[i];
        double& v = place.v[i];
        x = ball.x[i] + flown;
        v = ball.v[i];
        if (falls_) {
            const double fallen = 0.5 * bounds_.gravity[i] * (dt * dt);
            x += fallen;
            v += bounds_.gravity[i] * dt;
            farthest = std::max(farthest, filters::magnitude(fallen));
            fastest = std::max(fastest, filters::magnitude(v));
        }
        farthest = std::max(farthest, filters::magnitude(x));
    }
    if (farthest > bounds_.extent || fastest > bounds_.speed) [[unlikely]] {
        bounds_.extent = std::max(bounds_.extent, farthest);
        bounds_.speed = std::max(bounds_.speed, fastest);
        set_bounds();
    }
    return place;
}

template <int D>
auto MeetingFilter<D>::asker(const Ball<D>& ball, double now) noexcept -> Asker {
    Asker asker;
    asker.place_ = include(ball, now);
    asker.own_ = &ball;
    asker.radius_ = ball.radius;
    asker.now_ = now;
    asker.bounds_ = &bounds_;
    asker.answer_ = answer_;
    asker.kernel_ = kernel_;
    return asker;
}

template <int D>
Meeting MeetingFilter<D>::Asker::meeting(Wall wall, double side) const noexcept {
    const int axis = wall / 2;
    const double inwards = wall % 2 != 0 ? -1.0 : 1.0;
    const double g = inwards * bounds_->gravity[axis];
    return descent({inwards * (place_.x[axis] - side), 1.0, inwards * place_.v[axis], g,
                    bounds_->extent, g == 0.0 ? 0.0 : bounds_->speed});
}

template <int D>
Meeting MeetingFilter<D>::Asker::descent(const Approach& approach) const noexcept {
    const double rate = approach.scale * radius_ * bounds_->growth;
    const double gap = approach.distance - approach.scale * radius();
    const double v = approach.v - rate;
    const double g = approach.g;
    if (kernel_ == Kernel::naive) {
        const double t = now_ + naive_descent(gap, v, g);
        return {t, t};
    }
    const double gap_error = 0x1p-47 * approach.extent;
    const double sizes = approach.sizes + rate;
    const double v_error = 0x1p-50 * sizes;
    if (g == 0.0 && sizes == 0.0) {
        if (v >= 0.0) return never;
        if (!(gap > gap_error && v < -0x1p-300)) return unknown;
        return around(now_, gap / -v, gap_error / -v);
    }
    if (g >= 0.0 && v > v_error && gap >= -gap_error) return never;
    // It may have just been struck; then it rises, and falls if g does.
    if (!(gap > gap_error) && !(gap >= -gap_error && g < 0.0 && v > 2.0 * v_error)) return unknown;
    if (g == 0.0) {
        if (!(v < -2.0 * v_error && v < -0x1p-300)) return unknown;
        const double s = gap / -v;
        return around(now_, s, 2.0 * (gap_error + s * v_error) / -v);
    }
    const double discriminant = v * v - 2.0 * g * gap;
    const double speed = std::max(sizes, filters::magnitude(v));
    const double error =
        0x1p-48 * speed * speed +
        filters::magnitude(g) * (2.0 * gap_error + 0x1p-48 * filters::magnitude(gap));
    if (discriminant < -error && g > 0.0) return never;
    if (!(discriminant > 2.0 * error && (g < 0.0 || v < -v_error))) return unknown;
    const double root = std::sqrt(discriminant);
    const double root_error = v_error + error / root;
    if (v < 0.0) {
        const double s = 2.0 * gap / (root - v);
        return around(now_, s, (2.0 * gap_error + s * root_error) / (root - v) + 0x1p-48 * s);
    }
    const double s = (v + root) / -g;
    return around(now_, s, root_error / -g + 0x1p-48 * s);
}

template class MeetingFilter<2>;
template class MeetingFilter<3>;

}  // namespace signum::motion
