#pragma once
/// When two balls meet, or a ball and a wall: one rule.
///
/// Let F(t) be |D(t)|² - R², D the difference of the centres and R the sum of the radii (wall: the
/// distance of the centre less the radius), and T the later of the two balls' own times. They meet
/// at the least t >= T at which F(t) <= 0 and F falls right after t. The meeting time is the double
/// nearest to it, halves to even, and T where that would be below T. Infinity stands for never.
/// So it is a function of two states and of nothing else.
///
/// What it means: F falls, they approach. Touching or overlapping at T and approaching: T.
/// Receding: never (radii that outgrow the motion and walls under gravity come back: F is concave
/// there). Where F only touches 0 they graze, and exchange no impulse: never.
///
/// Three stages: doubles with a bound (MeetingFilter), which tell an interval that contains the
/// meeting time, or never, or nothing; double-doubles that nearly always tell the one double
/// (refined_meeting()), and rationals (exact_meeting()).

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "../filters/bounds.hpp"
#include "ball.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::motion {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// The meeting time lies in [early, late].
struct Meeting {
    double early = infinity;
    double late = infinity;
};
inline constexpr Meeting never{infinity, infinity};
inline constexpr Meeting unknown{-infinity, infinity};

/// Where a ball is at a moment, rounded.
template <int D>
struct Place {
    Vector<D> x;
    Vector<D> v;
};

/// How a centre comes to something flat, all times a scale: its distance from it, speed v and
/// acceleration g away from it.
struct Approach {
    double distance = 0.0;
    double scale = 1.0;
    double v = 0.0;
    double g = 0.0;
    double extent = 0.0;  ///< of what the distance is a sum
    double sizes = 0.0;   ///< of what v is a sum; 0 where it is exact
};

/// As many balls as are asked about at once, and what was told of each.
struct Crowd {
    static constexpr std::size_t capacity = 64;

    std::size_t size = 0;
    std::array<Slot, capacity> who;
    std::array<double, capacity> early;
    std::array<double, capacity> late;
    double soonest;  ///< the least of late

    /// Precondition: there is room.
    void push(Slot slot) noexcept { who[size++] = slot; }
    void assign(std::span<const Slot> slots) noexcept {
        std::ranges::copy(slots, who.begin());
        size = slots.size();
    }
    [[nodiscard]] bool is_full() const noexcept { return size == capacity; }
};

template <int D>
struct Bounds {
    Vector<D> gravity{};
    bool periodic = false;
    Vector<D> length{};  ///< of the box
    Vector<D> inverse_length{};
    double growth = 0.0;       ///< of radii, as a part of those at time 0
    double extent = 0x1p-150;  ///< so that no product of bounds is a denormal
    double speed = 0.0;
    double speed_square = 0.0;
    /// K, of C and per square of speed of the discriminant.
    double gap_error = 0.0;
    /// (128 u E)², of (D·V)² per square of speed.
    double product_error = 0.0;
};

/// The first stage. Its bounds, with u = 2^-53, E = extent, W = speed:
///
/// Of the place of a ball: dt = fl(t - time), x + v dt + g dt²/2. The ball's own x, what it has
/// flown and fallen since, and its place are at most E in each coordinate: of the one that asks E
/// is made so, the others are asked whether it is so. So a place errs by 4 u E, with gravity by 9 u
/// E, and D_i, a difference of two places less a multiple of the box's length that is at most 3 E,
/// by less than 17 u E, with gravity by less than 27 u E. Of speeds W bounds those of all own times
/// and the present one of the one that asks, so that of another one is at most W + √A; V errs by u
/// a component, with gravity by less than 10 u W + 4 u √A. For D <= 3, |D|² <= 12 E²:
///     B = D·V     |error| <= 82 u E √A + 60 u E W, whose square is below (128 u E)² (A + W²)
///     C = D·D-R²  |error| <= 520 u E²
///     B² - AC     |error| <= 1682 u E² A + 416 u E² W² <= K (A + W²),   K = 2048 u E²
/// and of s = C / (-B + √disc), since s √A <= |D| and s A = -B - √disc,
///     |error| <= (K + s K W/E + s K (A + W²)/√disc) / (-B + √disc),
/// which is at most K/√disc where W = 0. Twice that is taken, for the bounds are computed in
/// rounded numbers and disc may be twice its error. That B < 0 where a time is told need not be
/// asked: disc > 2 K (A + W²) and C > 0 make |B| larger than its error, and who recedes is never
/// met. s is rounded seven times and t = now + s, now >= 0, and the interval's ends once: 2^-49 t.
///
/// Radii that grow are one coordinate more, with the other sign: R = (r_a + r_b)(1 + γ t), at most
/// E, errs by 4 u E, and its rate P by 3 u P. With S = V·V + P² in place of A, B = D·V - R P errs
/// by less than (82 + 9) u E √S + 60 u E W, C by less than 528 u E², A = V·V - P² by less than 20 u
/// S + 21 u (S + W²), and B² - AC by less than 2 K (S + W²). Where A may be negative they meet
/// sooner or later, and B >= 0 tells nothing. The root moves by (δC + 2 s δB + s² δA) / 2√disc,
/// less than K (2 + 4 s² (S + W²) / E²) / √disc.
template <int D>
class MeetingFilter {
 public:
    MeetingFilter(const Effects<D>& effects, Kernel kernel);

    /// Takes a ball into the bounds, as it is at its own time.
    void include(const Ball<D>& ball) noexcept {
        for (const double x : ball.x) include(x);
        include(largest_growth_ * 2.0 * ball.radius);
        if (falls_)
            for (const double v : ball.v)
                bounds_.speed = std::max(bounds_.speed, filters::magnitude(v));
        set_bounds();
    }

    /// The questions of one ball at one time, by the filter's bounds.
    class Asker {
     public:
        /// When it meets each of a crowd, four at a time and without a branch: which of many are
        /// met is anybody's guess. Precondition: now is not before anybody's own time, and no two
        /// have met between T and now.
        void meetings(const Ball<D>* balls, Crowd& crowd) const noexcept {
            answer_(*this, balls, crowd);
        }
        /// Of a side of the box: F = x - side - r, x counted inwards.
        [[nodiscard]] Meeting meeting(Wall wall, double side) const noexcept;
        /// Of anything flat: F = distance - scale · r. With errors of 64 u of the extent in F, and
        /// of 8 u of the sizes in v; those of the root as above.
        [[nodiscard]] Meeting descent(const Approach& approach) const noexcept;

        [[nodiscard]] const Place<D>& place() const noexcept { return place_; }
        [[nodiscard]] double radius() const noexcept {
            return radius_ * (1.0 + bounds_->growth * now_);
        }
        /// The rate at which its radius grows.
        [[nodiscard]] double growth() const noexcept { return radius_ * bounds_->growth; }
        [[nodiscard]] double now() const noexcept { return now_; }
        [[nodiscard]] const Bounds<D>& bounds() const noexcept { return *bounds_; }

     private:
        friend MeetingFilter;
        template <class Flight>
        static void answer(const Asker& asker, const Ball<D>* balls, Crowd& crowd) noexcept;
        template <class Flight>
        void fill(const Ball<D>* balls, Crowd& crowd) const noexcept;
        using Answer = void (*)(const Asker&, const Ball<D>*, Crowd&) noexcept;

        Place<D> place_;
        const Ball<D>* own_;
        double radius_;
        double now_;
        const Bounds<D>* bounds_;
        Answer answer_;
        Kernel kernel_;
    };
    /// Takes a ball into the bounds as it is now; returns where that is.
    Place<D> include(const Ball<D>& ball, double now) noexcept;
    /// The bounds then hold for questions asked from where the ball is now.
    [[nodiscard]] Asker asker(const Ball<D>& ball, double now) noexcept;

 private:
    void include(double coordinate) noexcept {
        bounds_.extent = std::max(bounds_.extent, filters::magnitude(coordinate));
    }
    void set_bounds() noexcept {
        const double square = bounds_.extent * bounds_.extent;
        bounds_.gap_error = 0x1p-42 * square;
        bounds_.product_error = 0x1p-92 * square;
        bounds_.speed_square = bounds_.speed * bounds_.speed;
    }

    bool falls_;
    Kernel kernel_;
    double largest_growth_ = 1.0;  ///< of radii, as a factor
    Bounds<D> bounds_;
    typename Asker::Answer answer_;
};

}  // namespace signum::motion

SIGNUM_IEEE_END
