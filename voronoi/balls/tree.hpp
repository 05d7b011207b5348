#pragma once
/// A tree of boxes around balls. For sources only.

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "../../core/box_tree.hpp"
#include "../../core/index.hpp"
#include "../../core/site.hpp"

namespace signum::balls {

/// The fourth number of a box is the radius.
class BallTree : public BoxTree<4> {
 public:
    BallTree(std::span<const Site3> balls, std::span<const Index> names)
        : BoxTree(names.size(), 6, 3, [&](std::size_t i) {
              const Site3& b = balls[static_cast<std::size_t>(names[i])];
              return Bounds::point({b.x, b.y, b.z, b.r});
          }) {
        for (const std::uint32_t i : order()) {
            names_.push_back(names[i]);
            balls_.push_back(balls[static_cast<std::size_t>(names[i])]);
        }
    }

    /// By places.
    [[nodiscard]] const Site3& ball(std::size_t place) const noexcept { return balls_[place]; }
    [[nodiscard]] Index name(std::size_t place) const noexcept { return names_[place]; }
    [[nodiscard]] std::size_t size() const noexcept { return balls_.size(); }

 private:
    std::vector<Site3> balls_;
    std::vector<Index> names_;
};

}  // namespace signum::balls
