#pragma once
/// How many balls lie at a distance from a ball, beside how many would at random.
///
/// g(r) is the number of pairs with centres in a shell, over all frames, divided by what the mean
/// density would put there. In a periodic box every ball is a centre, distances are those of the
/// nearest images, and the others have the density (n - 1) / V. In a box with walls the centres
/// are the balls that are farther than the largest r from all of them, so that every shell lies in
/// the box, and the density is that of these balls in the part of the box where they are. So g is 1
/// on the average of random points in either.

#include <cstddef>
#include <ostream>
#include <vector>

#include "../io/write_motion.hpp"

namespace signum {

class PairCorrelation {
 public:
    /// Distances go to eight mean diameters, but no farther than half the shortest side of a
    /// periodic box, or a quarter of that of one with walls; shells are a fiftieth of the mean
    /// diameter thick, of points a 200th of all. Precondition: the frame has a box.
    explicit PairCorrelation(const MotionFrame& first);

    /// O(n log n + n²w), where w is the largest distance as a share of the box along x.
    void add(const MotionFrame& frame);
    struct Shell {
        double r = 0.0;  ///< its middle
        double g = 0.0;
    };
    /// None where no ball was a centre.
    [[nodiscard]] std::vector<Shell> shells() const;
    /// As CSV: r,g, a shell a line.
    void write(std::ostream& out) const;

    [[nodiscard]] double thickness() const noexcept { return thickness_; }
    /// Of the pairs in each shell, how many a centre has on the average.
    [[nodiscard]] std::vector<double> neighbours() const;

 private:
    int dimension_;
    double thickness_ = 0.0;
    std::vector<double> pairs_;  ///< of a centre and another, by shells
    double centres_ = 0.0;       ///< of all frames
    double expected_ = 0.0;      ///< the sum over centres of the density
};

}  // namespace signum
