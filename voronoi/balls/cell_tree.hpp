#pragma once
/// Which nodes of the tree may matter to the cell of a ball. Part of cell.hpp, which includes it.

namespace signum::balls {

inline bool CellSearch::may_reach(const BallTree::Node& node, const Patch& patch,
                                  const Gathered& gathered) const {
    const Site3& i = tree_.ball(ball_);
    const std::array<double, 3> from{i.x, i.y, i.z};
    std::array<double, 3> low, high;
    double farthest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        low[k] = node.low[k] - from[k];
        high[k] = node.high[k] - from[k];
        const double far = std::max(-low[k], high[k]);
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
        for (std::size_t k = 0; k < 3; ++k) {
            const double v = patch.v[k];
            double x = v > 0.0 ? high[k] : low[k];
            if (v * x >= 0.0 && f * std::fabs(x) > std::fabs(v))
                x = std::clamp(v / f, low[k], high[k]);
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
    double square = 0.0, half_square = 0.0, nearest = 0.0;
    std::array<double, 3> middle;
    for (std::size_t k = 0; k < 3; ++k) {
        middle[k] = 0.5 * (low[k] + high[k]);
        const double half = 0.5 * (high[k] - low[k]);
        square += middle[k] * middle[k];
        half_square += half * half;
        const double near = std::max({low[k], -high[k], 0.0});
        nearest += near * near;
    }
    const double half = std::sqrt(half_square), distance = std::sqrt(square);
    // F is lower than that of another, whose a is longer: |a| is at most that of the nearest.
    if (nearest > square_r && nearest > 0x1p-900) {
        const double length = 2.0 * std::sqrt(nearest) / (nearest - square_r) * (1.0 + 0x1p-40);
        const double along = middle[0] * patch.v[0] + middle[1] * patch.v[1] +
                             middle[2] * patch.v[2] + greatest_r + half;
        const double slack = 0x1p-46 * (far + std::fabs(greatest_r));
        for (std::size_t k = 0; k < gathered.number_of_high; ++k) {
            const auto& [its_height, slot] = gathered.high[k];
            const Seen& j = seen_[slot];
            const double top = along - distance * its_height + half * std::fabs(its_height) +
                               slack * (1.0 + std::fabs(j.c));
            if (!(top < 0.0)) continue;
            if (nearest <= square_r * (1.0 + 0x1p-10) || !(length <= j.length - j.error)) continue;
            const double x = middle[0] - distance * j.nx, y = middle[1] - distance * j.ny,
                         z = middle[2] - distance * j.nz;
            const double change = std::sqrt(x * x + y * y + z * z) + 2.0 * half + slack;
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
    const double x = 2.0 * middle[0] - p * best.ax, y = 2.0 * middle[1] - p * best.ay,
                 z = 2.0 * middle[2] - p * best.az;
    const double change_of_p =
        2.0 * distance * half + half_square + half_r * (2.0 * std::fabs(middle_r) + half_r);
    const double change = std::sqrt(x * x + y * y + z * z) + 2.0 * half +
                          best.length * (change_of_p + 0x1p-46 * (farthest + square_r));
    return !(top + patch.delta * (change * (1.0 + 0x1p-46) + 0x1p-46 * far) < 0.0);
}

}  // namespace signum::balls
