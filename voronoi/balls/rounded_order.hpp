#pragma once
/// The order of spheres along the curve of three balls, from rounded numbers. For sources only.

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "../../core/site.hpp"
#include "../../filters/bounds.hpp"
#include "../../predicates/space/ball_filter.hpp"
#include "../../predicates/space/ccw.hpp"
#include "../vector3.hpp"

namespace signum::balls {

/// What forward_order() says (exact_sphere.hpp), from spheres whose numbers are rounded: nothing
/// where that is not certain.
///
/// By heights n·x, n = X_b × X_c; on a loop also by whether the height rises forward, that is the
/// sign of det[w', b, c, (n, 0)] = h n·n + x·(R_b X_c × n - R_c X_b × n).
///
/// The bounds. Each number of a sphere errs by a part of 2^-53, and so do differences. With l the
/// sum of magnitudes, n errs by a part of 2^-51 of the sums of its products, m; W = <b,b> <c,c> -
/// <b,c>² by one of 2^-47 of the products of the sums of squares, heights and rises by less than
/// 2^-46 of the products below. Nothing is certain where numbers underflow.
class RoundedOrder {
 public:
    RoundedOrder(const std::array<Site3, 3>& curve) : first_(curve[0]) {
        using euclidean::balls::Row;
        using euclidean::balls::filter::pinned;
        const Row<3, double> b = euclidean::balls::row<3, double>(pinned(curve[1]), pinned(first_));
        const Row<3, double> c = euclidean::balls::row<3, double>(pinned(curve[2]), pinned(first_));
        const auto product = [](const Row<3, double>& p, const Row<3, double>& q) {
            return (p[0] * q[0] + p[1] * q[1] + p[2] * q[2]) - p[3] * q[3];
        };
        const auto size = [&](const Row<3, double>& p) {
            return product(p, p) + 2.0 * p[3] * p[3];
        };
        const double bc = product(b, c);
        const double w = product(b, b) * product(c, c) - bc * bc;
        const double bound = 0x1p-46 * (size(b) * size(c)) + 0x1p-900;
        loop_ = w < -bound ? 1 : w > bound ? -1 : 0;
        const Point3 x_b = {b[0], b[1], b[2]}, x_c = {c[0], c[1], c[2]};
        normal_ = cross(x_b, x_c);
        rise_ = minus(times(cross(x_c, normal_), b[3]), times(cross(x_b, normal_), c[3]));
        double length_b = 0.0, length_c = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
            size_ += filters::magnitude(b[l] * c[m]) + filters::magnitude(b[m] * c[l]);
            length_b += filters::magnitude(b[k]);
            length_c += filters::magnitude(c[k]);
        }
        size_of_rise_ =
            (filters::magnitude(b[3]) * length_c + filters::magnitude(c[3]) * length_b) * size_;
    }

    /// +1 of a loop, -1 of an open curve, 0 where that is not certain.
    [[nodiscard]] int loop() const noexcept { return loop_; }

    [[nodiscard]] std::optional<std::vector<std::size_t>> operator()(
        std::span<const Site3> spheres) const {
        if (loop_ == 0) return std::nullopt;
        struct Key {
            double rise, height, size;
            std::size_t number;
        };
        std::vector<Key> keys;
        for (std::size_t i = 0; i < spheres.size(); ++i) {
            const Site3& s = spheres[i];
            const Point3 from_first = minus(centre3(s), centre3(first_));
            const double size = filters::magnitude(s.x) + filters::magnitude(s.y) +
                                filters::magnitude(s.z) + filters::magnitude(first_.x) +
                                filters::magnitude(first_.y) + filters::magnitude(first_.z);
            double rise = 1.0;
            if (loop_ > 0) {
                const double value =
                    (s.r + first_.r) * dot(normal_, normal_) + dot(from_first, rise_);
                const double error =
                    0x1p-46 *
                        ((filters::magnitude(s.r) + filters::magnitude(first_.r)) * size_ * size_ +
                         size * size_of_rise_) +
                    0x1p-900;
                if (!(filters::magnitude(value) > error)) return std::nullopt;
                rise = value > 0.0 ? 1.0 : -1.0;
            }
            keys.push_back({rise, dot(from_first, normal_), size * size_, i});
        }
        std::ranges::sort(keys, [](const Key& p, const Key& q) {
            if (p.rise != q.rise) return p.rise > q.rise;
            return p.rise * p.height < q.rise * q.height;
        });
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < keys.size(); ++i) {
            const bool is_first = i == 0 || keys[i - 1].rise != keys[i].rise;
            if (!is_first && !(filters::magnitude(keys[i].height - keys[i - 1].height) >
                               0x1p-46 * (keys[i].size + keys[i - 1].size) + 0x1p-900))
                return std::nullopt;
            order.push_back(keys[i].number);
        }
        return order;
    }

 private:
    Site3 first_;
    int loop_ = 0;
    Point3 normal_, rise_;
    double size_ = 0.0;
    double size_of_rise_ = 0.0;
};

}  // namespace signum::balls
