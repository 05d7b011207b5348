#pragma once
/// Sites in a tree of boxes, for the question which of them may be as near to a place as some other
/// one is: as triangulation/check/near_sites.hpp, in any dimension.
///
/// A box is a site whose numbers are intervals; the distance from it, in interval arithmetic, is no
/// greater than that from any site in it. What is certainly farther is passed over as a whole.
/// Numbers are multiplied by a power of two first, so that squares are doubles.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "../../core/index.hpp"
#include "../../filters/interval.hpp"
#include "sites.hpp"

namespace signum::any_dimension {

/// All this in the default environment. Building takes O(n log n).
template <class S>
class NearSites {
 public:
    /// Of the sites that `members` names.
    NearSites(std::span<const S> sites, std::vector<Index> members)
        : sites_(sites), members_(std::move(members)) {
        double largest = 0.0;
        for (std::size_t m = 0; m < members_.size(); ++m)
            for (std::size_t which = 0; which <= coordinates; ++which)
                largest = std::max(largest, length(member(m), which));
        if (largest > 0.0) scale_ = std::ldexp(1.0, -std::clamp(std::ilogb(largest), -1000, 1000));
        if (!members_.empty()) build(0, members_.size());
    }

    /// Calls visit(i) for each site that is not certainly farther from the centre of q than `other`
    /// is. Returns how often something was passed over.
    template <class Visit>
    std::size_t visit_near(const S& q, const S& other, Visit visit) {
        std::size_t passed = 0;
        const Box centre = box_of(q);
        const Interval limit = distance(centre, box_of(other));
        pending_.assign(nodes_.empty() ? 0 : 1, 0);
        while (!pending_.empty()) {
            const std::size_t place = pending_.back();
            const Node& node = nodes_[place];
            pending_.pop_back();
            if ((distance(centre, node.box) - limit).low > 0.0) {
                ++passed;
            } else if (node.right != 0) {
                pending_.push_back(node.right);
                pending_.push_back(place + 1);
            } else {
                for (std::size_t m = node.first; m < node.last; ++m) visit(members_[m]);
            }
        }
        return passed;
    }

 private:
    using Interval = filters::Interval;
    static constexpr auto coordinates = static_cast<std::size_t>(dimension_of<S>);
    /// The coordinates, and what orders sites by weight.
    using Box = std::array<Interval, coordinates + 1>;
    /// The left child follows; a leaf has no right one.
    struct Node {
        Box box;
        std::size_t first;
        std::size_t last;
        std::size_t right;
    };
    static constexpr std::size_t leaf_size = 4;
    static constexpr bool has_radius = requires(const S& s) { s.r; };

    [[nodiscard]] static constexpr bool is_length(std::size_t which) noexcept {
        return which < coordinates || has_radius;
    }

    [[nodiscard]] static double number(const S& s, std::size_t which) noexcept {
        return which < coordinates ? coordinate(s, which) : power::weight_key(s);
    }
    /// Of a number its magnitude, of a weight the radius that it is the square of.
    [[nodiscard]] static double length(const S& s, std::size_t which) noexcept {
        const double x = filters::magnitude(number(s, which));
        return is_length(which) ? x : std::sqrt(x);
    }
    [[nodiscard]] Interval scaled(const Interval& x, std::size_t which) const noexcept {
        const Interval once = x * Interval(scale_);
        return is_length(which) ? once : once * Interval(scale_);
    }
    [[nodiscard]] Box box_of(const S& s) const noexcept {
        Box box;
        for (std::size_t which = 0; which <= coordinates; ++which)
            box[which] = scaled(Interval(number(s, which)), which);
        return box;
    }
    /// From the centre of a site, of which the weight does not matter.
    [[nodiscard]] static Interval distance(const Box& centre, const Box& box) noexcept {
        Interval weight = box[coordinates];
        if constexpr (has_radius) weight = weight * weight;
        Interval sum = -weight;
        for (std::size_t axis = 0; axis < coordinates; ++axis) {
            const Interval x = filters::magnitude(box[axis] - centre[axis]);
            sum = sum + x * x;
        }
        return sum;
    }
    [[nodiscard]] const S& member(std::size_t m) const noexcept {
        return sites_[static_cast<std::size_t>(members_[m])];
    }

    void build(std::size_t first, std::size_t last) {
        Box box;
        for (std::size_t which = 0; which <= coordinates; ++which) {
            double low = number(member(first), which);
            double high = low;
            for (std::size_t m = first + 1; m < last; ++m) {
                low = std::min(low, number(member(m), which));
                high = std::max(high, number(member(m), which));
            }
            box[which] = scaled({low, high}, which);
        }
        const std::size_t place = nodes_.size();
        nodes_.push_back({box, first, last, 0});
        if (last - first <= leaf_size) return;
        // Halved by the number in which they differ most.
        std::size_t widest = 0;
        for (std::size_t which = 1; which <= coordinates; ++which)
            if (box[which].high - box[which].low > box[widest].high - box[widest].low)
                widest = which;
        const std::size_t middle = first + (last - first) / 2;
        const auto at = [&](std::size_t m) {
            return members_.begin() + static_cast<std::ptrdiff_t>(m);
        };
        std::nth_element(at(first), at(middle), at(last), [&](Index a, Index b) {
            return number(sites_[static_cast<std::size_t>(a)], widest) <
                   number(sites_[static_cast<std::size_t>(b)], widest);
        });
        build(first, middle);
        nodes_[place].right = nodes_.size();
        build(middle, last);
    }

    std::span<const S> sites_;
    std::vector<Index> members_;
    std::vector<Node> nodes_;
    std::vector<std::size_t> pending_;
    double scale_ = 1.0;
};

}  // namespace signum::any_dimension
