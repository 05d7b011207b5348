#pragma once
/// Which part each site belongs to: a tree of cuts along the axes, made from a sample.

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "../../core/site.hpp"

namespace signum::distributed {

class Cuts {
 public:
    /// Of so many parts, one at least, each with about as many of the sample. The same wherever it
    /// is made from the same sample. O(n log parts).
    Cuts(std::vector<Point3> sample, std::size_t parts) : parts_(parts) { cut(sample, 0, parts); }

    [[nodiscard]] std::size_t parts() const noexcept { return parts_; }
    [[nodiscard]] std::size_t part_of(const Point3& p) const noexcept {
        std::size_t first = 0;
        std::size_t last = parts_;
        for (std::size_t node = 0; last - first > 1;) {
            const Node& here = nodes_[node];
            const std::size_t middle = first + (last - first) / 2;
            if (p.*here.axis < here.at) {
                last = middle;
                ++node;
            } else {
                first = middle;
                node = here.above;
            }
        }
        return first;
    }

 private:
    /// Parts first … last: the lower half is the next node.
    struct Node {
        double Point3::*axis;
        double at;
        std::size_t above;
    };

    void cut(std::span<Point3> sample, std::size_t first, std::size_t last) {
        if (last - first <= 1) return;
        const std::size_t middle = first + (last - first) / 2;
        const std::size_t place = sample.size() * (middle - first) / (last - first);
        const std::size_t number = nodes_.size();
        nodes_.push_back({&Point3::x, 0.0, 0});
        if (!sample.empty()) {
            const auto put_in_place = [&](std::size_t k, double Point3::*axis) {
                std::ranges::nth_element(sample, sample.begin() + static_cast<std::ptrdiff_t>(k),
                                         {}, axis);
                return sample[k].*axis;
            };
            // Along the axis along which most of them are spread widest. Halved, so that it cannot
            // overflow.
            const auto spread = [&](double Point3::*axis) {
                const std::size_t eighth = sample.size() / 8;
                return 0.5 * put_in_place(sample.size() - 1 - eighth, axis) -
                       0.5 * put_in_place(eighth, axis);
            };
            double Point3::*widest = &Point3::x;
            for (double Point3::*const axis : {&Point3::y, &Point3::z})
                if (spread(axis) > spread(widest)) widest = axis;
            nodes_[number].axis = widest;
            nodes_[number].at = put_in_place(place, widest);
        }
        // As part_of() parts them: those that are equal go together.
        const auto is_below = [axis = nodes_[number].axis,
                               at = nodes_[number].at](const Point3& p) { return p.*axis < at; };
        const auto above = std::partition(sample.begin(), sample.end(), is_below);
        const auto below = static_cast<std::size_t>(above - sample.begin());
        cut(sample.first(below), first, middle);
        nodes_[number].above = nodes_.size();
        cut(sample.subspan(below), middle, last);
    }

    std::size_t parts_;
    std::vector<Node> nodes_;
};

}  // namespace signum::distributed
