#pragma once
/// The walls that the inner loop does not know: sides of a box that shakes, and obstacles. Of sides
/// at rest they tell what is no question of the inner loop. For sources only.
///
/// Each has three stages, as pairs have (meeting.hpp). The first one, in doubles with a bound, goes
/// along the gap F from now on in steps that cannot pass its first root: with a bound B of -F'' in
/// the step, F(t + h) >= F + F' h - B h²/2. Where F > 0 is next to 0 and surely falls, the root is
/// enclosed; where that does not come about in some steps, it is unknown.

#include <variant>
#include <vector>

#include "meeting.hpp"
#include "shaking_wall.hpp"
#include "wall_strike.hpp"

namespace signum::motion {

template <int D>
class Walls {
 public:
    Walls(const Effects<D>& effects, Kernel kernel);

    using Asker = typename MeetingFilter<D>::Asker;

    /// Their numbers, in order; without sides at rest.
    [[nodiscard]] const std::vector<Wall>& numbers() const noexcept { return numbers_; }
    [[nodiscard]] bool has(Wall wall) const noexcept { return wall_of(wall) != nullptr; }

    /// When a ball meets a wall, as far as it does so by a time: later ones may be told as later
    /// than that, whenever they are.
    [[nodiscard]] Meeting meeting(Wall wall, const Asker& asker, double latest) const;
    /// The one double. Here and where it is said sides at rest are walls, too.
    [[nodiscard]] double exact_meeting(const Ball<D>& ball, Wall wall) const;
    /// The next one after a meeting that was no strike: of those from the first of the times
    /// passed + 2^k ulps on at which the ball does not meet the wall at once. With a half space
    /// there is none, as the gap does not bend down.
    [[nodiscard]] double next_meeting(const Ball<D>& ball, Wall wall, double passed) const;
    /// The same as exact_meeting(), of a ball that meets it at some time near `about`; NaN where it
    /// is not told. Sides at rest, too.
    [[nodiscard]] double refined_meeting(const Ball<D>& ball, Wall wall, double about) const;
    /// Sides at rest, too.
    [[nodiscard]] Facing<D> facing(const Ball<D>& ball, Wall wall) const;
    /// Whether the gap between it and a ball at its own time bends down (wall_strike.hpp). Sides at
    /// rest, too.
    [[nodiscard]] bool bends_down(const Ball<D>& ball, Wall wall) const;
    /// How deep into a wall a centre may be rounded and still be on its side of it: the distance of
    /// the centre from the wall's middle when they touch; infinite where a wall has one side alone.
    [[nodiscard]] double depth(const Ball<D>& ball, Wall wall) const;
    /// The velocity of any wall, a side at rest included: such a one moves along itself where the
    /// box shakes. Rounded; of a half space that along its normal.
    [[nodiscard]] Vector<D> velocity(Wall wall, double t) const;
    /// Those of the box's sides for balls that lie on them from t to t + step, and fly straight:
    /// along itself its mean one; along its normal so fast that the ball does not enter, as far as
    /// four looks at the wave tell, for which steps are to be short beside its period.
    [[nodiscard]] std::array<Vector<D>, 2 * D> side_velocities(double t, double step) const;
    /// 1 over the radius of the surface on which the centre of a ball lies that touches a sphere
    /// from inside; 0 where a wall is not hollow, or as wide as the ball.
    [[nodiscard]] double curvature(const Ball<D>& ball, Wall wall) const;
    /// How far a ball at its own time is from any wall, rounded; below 0 where they overlap.
    [[nodiscard]] double gap(const Ball<D>& ball, Wall wall) const;

 private:
    template <class... Kinds>
    static std::variant<ShakingWall, Kinds...> with_shaking(const std::variant<Kinds...>&);
    using Surface = decltype(with_shaking(Obstacle<D>()));

    [[nodiscard]] const Surface* wall_of(Wall wall) const noexcept;

    const Effects<D>& effects_;
    Kernel kernel_;
    std::vector<Wall> numbers_;
    std::vector<Surface> surfaces_;
};

}  // namespace signum::motion
