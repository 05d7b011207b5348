#pragma once
/// Sets of sites in which degenerate positions abound.

#include "../../core/site.hpp"

#include <array>
#include <utility>

#include "../unit/exact_reference.hpp"

namespace signum::brute_force {

using reference::Random;

/// Degenerate sites in small integers.
class Degenerate {
 public:
    static constexpr int families = 9;
    explicit Degenerate(std::uint64_t seed) : random_(seed) {}

    /// Any of (±3, ±4), (±4, ±3), (±5, 0), (0, ±5).
    std::array<int, 2> of_length_5() {
        std::array<int, 2> v = random_.coin() ? std::array{3, 4} : std::array{0, 5};
        if (random_.coin()) std::swap(v[0], v[1]);
        return {random_.coin() ? v[0] : -v[0], random_.coin() ? v[1] : -v[1]};
    }

    void fill(int family, Site* first, std::size_t count) {
        const auto upto = [&](int n) { return random_.between(0, n); };
        const int box = 1 + upto(7);
        const int largest = upto(4);
        const int step = upto(3);
        const auto along = of_length_5();
        const auto number = [](int n) { return static_cast<double>(n); };
        for (std::size_t m = 0; m < count; ++m) {
            Site& s = first[m];
            const int t = random_.between(-3, 3);
            switch (family) {
                case 0:  // a box
                    s = {number(upto(box)), number(upto(box)), number(upto(largest))};
                    break;
                case 1:  // a grid of equal radii
                    s = {number(upto(3)), number(upto(3)), number(largest)};
                    break;
                case 2:  // centres on a line
                    s = {number(along[0] * t), number(along[1] * t), number(upto(8))};
                    break;
                case 3: {  // tangent to the one before, from inside or outside
                    if (m == 0) {
                        s = {0, 0, number(upto(9))};
                        break;
                    }
                    const Site& from = first[random_.below(static_cast<int>(m))];
                    const auto [x, y] = of_length_5();
                    const int d = upto(2);
                    const int touch = random_.between(-1, 1) * 5 * d;
                    s = {from.x + x * d, from.y + y * d, from.r + touch};
                    break;
                }
                case 4:  // a common tangent line, along (4, -3)
                case 5: {
                    const int r = upto(family == 4 ? 2 : 1);
                    s = {number(4 * t + 3 * r), number(-3 * t + 4 * r),
                         number(5 * r + (upto(7) == 0 ? 1 : 0))};
                    break;
                }
                case 6: {  // a common circle, of radius step - 1
                    const auto [x, y] = of_length_5();
                    const int d = 1 + upto(2);
                    s = {number(x * d), number(y * d),
                         number(5 * d - step + (upto(9) == 0 ? 1 : 0))};
                    break;
                }
                case 7:  // nested
                    s = {number(upto(2)), number(upto(2)), number(upto(9))};
                    break;
                default:  // small between large
                    s = m < 2
                            ? Site{number(10 * static_cast<int>(m)), number(upto(2)),
                                   number(upto(6))}
                            : Site{number(random_.between(-4, 14)), number(random_.between(-9, 9)),
                                   number(upto(9) == 0 ? 12 : upto(3))};
            }
        }
    }

    Random& random() { return random_; }

 private:
    Random random_;
};

}  // namespace signum::brute_force
