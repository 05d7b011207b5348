#pragma once
/// Which nodes of the tree may matter to the cell of a ball. Part of cell.hpp, which includes it.

namespace signum::balls {

inline bool CellSearch::may_reach(const BallTree::Node& node, const Patch& patch,
                                  const Gathered& gathered) const {
    const Site3& i = tree_.ball(ball_);
    const Point3 low = minus({node.low[0], node.low[1], node.low[2]}, centre3(i));
    const Point3 high = minus({node.high[0], node.high[1], node.high[2]}, centre3(i));
    double farthest = 0.0;
    for (const auto axis : axes_of_space) {
        const double far = std::max(-(low.*axis), high.*axis);
        farthest += far * far;
    }
    const double least_r = node.low[3] - i.r, greatest_r = node.high[3] - i.r;
    const double square_r = std::max(least_r * least_r, greatest_r * greatest_r);
    if (!(farthest > 0x1p-900)) return true;
    const double far = std::sqrt(farthest);
    // The greatest of 2 X·v - f X·X + 2 R + f R², but for its error: of each coordinate the top
    // is at v / f.
    const auto greatest = [&](double f) {
        double sum = 2.0 * greatest_r + f * square_r;
        for (const auto axis : axes_of_space) {
            const double v = patch.v.*axis;
            double x = v > 0.0 ? high.*axis : low.*axis;
            if (v * x >= 0.0 && f * std::fabs(x) > std::fabs(v))
                x = std::clamp(v / f, low.*axis, high.*axis);
            sum += x * (2.0 * v - f * x);
        }
        return sum;
    };
    const auto error = [&](double f) {
        return 0x1p-46 *
               (far + std::fabs(greatest_r) + std::fabs(least_r) + f * (farthest + square_r));
    };
    const double f_least = gathered.f_least;
    if (greatest(f_least) + 2.0 * patch.delta * far + error(f_least) < 0.0) return false;
    const Point3 middle = times(plus(low, high), 0.5), half_sides = times(minus(high, low), 0.5);
    const double square = dot(middle, middle), half_square = dot(half_sides, half_sides);
    double nearest = 0.0;
    for (const auto axis : axes_of_space) {
        const double near = std::max({low.*axis, -(high.*axis), 0.0});
        nearest += near * near;
    }
    const double half = std::sqrt(half_square), distance = std::sqrt(square);
    // F is lower than that of another, whose a is longer: |a| is at most that of the nearest.
    if (nearest > square_r && nearest > 0x1p-900) {
        const double longest = 2.0 * std::sqrt(nearest) / (nearest - square_r) * (1.0 + 0x1p-40);
        const double along = dot(middle, patch.v) + greatest_r + half;
        const double slack = 0x1p-46 * (far + std::fabs(greatest_r));
        for (std::size_t k = 0; k < gathered.number_of_high; ++k) {
            const auto& [its_height, slot] = gathered.high[k];
            const Seen& j = seen_[slot];
            const double top = along - distance * its_height + half * std::fabs(its_height) +
                               slack * (1.0 + std::fabs(j.c));
            if (!(top < 0.0)) continue;
            if (nearest <= square_r * (1.0 + 0x1p-10) || !(longest <= j.length - j.error)) continue;
            const double change = length(plus(middle, j.n, -distance)) + 2.0 * half + slack;
            if (top + patch.delta * change * (1.0 + 0x1p-46) < 0.0) return false;
        }
    }
    if (gathered.best == no_slot || !(gathered.best_value > 0.0)) return true;
    // The same beside the best one of f = a·u + b, which changes by a·w: w·(2 X - P a).
    const Seen& best = seen_[gathered.best];
    const double f = gathered.best_value;
    const double top = greatest(f) + error(f) + best.error * (farthest + square_r);
    if (!(top < 0.0)) return true;
    const double middle_r = 0.5 * (least_r + greatest_r);
    const double half_r = 0.5 * (greatest_r - least_r);
    const double p = square - middle_r * middle_r;
    const double change_of_p =
        2.0 * distance * half + half_square + half_r * (2.0 * std::fabs(middle_r) + half_r);
    const double change = length(plus(times(middle, 2.0), best.a, -p)) + 2.0 * half +
                          best.length * (change_of_p + 0x1p-46 * (farthest + square_r));
    return !(top + patch.delta * (change * (1.0 + 0x1p-46) + 0x1p-46 * far) < 0.0);
}

}  // namespace signum::balls
