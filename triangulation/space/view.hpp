#pragma once
/// What a site that is inserted sees of the others: lifted offsets from it.
///
/// All cells around it are judged by these, computed once for a vertex however many cells meet
/// there, and one error bound, of the largest offsets seen so far, serves all of these cells.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "../../core/index.hpp"
#include "../../core/large_array.hpp"
#include "../../predicates/space/in_sphere.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::spatial {

/// Vertices by the order in which they were seen; the first is infinity.
using Seen = std::uint32_t;
inline constexpr Seen seen_infinity = 0;

/// A facet that turns positively seen from the site, and its place in the cell beyond it.
struct Facet {
    std::array<Seen, 3> vertex;
    std::uint32_t place = 0;
};

/// A row of in_sphere's determinant. The vertex at infinity is where nothing but the lift is not 0:
/// what is left of the determinant is the orientation of the three others with the site.
struct alignas(32) ViewRow {
    predicates::Offset3<double> offset;
    double lift;
    [[nodiscard]] double height() const noexcept { return lift; }
};

/// The determinants of in_sphere in the cells beyond the facets of one: `cell` are its vertices in
/// an order in which they turn positively, beyond[k] is the vertex beyond the facet across from
/// cell[k].
void in_spheres_beyond(const std::array<const ViewRow*, 4>& cell,
                       const std::array<const ViewRow*, 4>& beyond,
                       std::array<double, 4>& determinants) noexcept;
/// The same for points of a lattice, where nothing rounds. A step along x counts along_x, one along
/// y along_y, so that a point comes before another in the tie rule's order where it has the
/// smaller sum. Instead of a determinant that is 0, the one that the rule decides by: where the
/// site is the last point in the order -1, and otherwise the coefficient of the last one that has
/// any. It stays 0 where the site is one of the points or one of them is at infinity.
void in_spheres_beyond_by_rule(const std::array<const ViewRow*, 4>& cell,
                               const std::array<const ViewRow*, 4>& beyond, double along_x,
                               double along_y, std::array<double, 4>& determinants) noexcept;

/// The same in double-doubles, for sites within their window; rounded at the end. In error by less
/// than refined_error times the sum of the magnitudes of the terms.
template <power::PowerSite3 S>
void refined_in_spheres_beyond(const S& eye, const std::array<const S*, 4>& cell,
                               const std::array<const S*, 4>& beyond,
                               std::array<double, 4>& determinants) noexcept;
/// Whether sites are within the window of double-doubles.
template <power::PowerSite3 S>
[[nodiscard]] bool are_in_window(std::span<const S> sites) noexcept;
inline constexpr double refined_error = 0x1p-96;

template <power::PowerSite3 S>
class View {
 public:
    explicit View(const S* sites) : sites_(sites) {}
    /// The same sites, and perhaps more, elsewhere in memory.
    void move_to(const S* sites) noexcept { sites_ = sites; }

    /// From here on vertices are seen from q, and none yet but infinity.
    void look_from(Index q) noexcept {
        eye_ = q;
        count_ = looked_at_ = 1;
        largest_ = {0.0, 0.0, 0.0};
        weight_ = 0.0;
        in_environment_ = filters::environment_is_default();
    }
    /// Room for this many more vertices to be seen.
    void make_room(std::size_t vertices) {
        if (count_ + vertices <= names_.size()) [[likely]]
            return;
        names_.resize(2 * (count_ + vertices));
        rows_.resize(names_.size());
    }
    /// The next vertex to be seen, if it is new: without a branch. Precondition: there is room.
    void see(Index v, bool is_new = true) noexcept {
        names_[count_] = v;
        count_ += static_cast<std::size_t>(is_new);
    }
    [[nodiscard]] std::size_t count() const noexcept { return count_; }
    /// To be called before cells are judged by what has been seen. The bound is that of the filter
    /// of in_sphere, with the largest offsets of all in the place of the largest of a cell; beyond
    /// the filter's window, and where a determinant could overflow, it is infinite.
    void set_bound() noexcept {
        for (; looked_at_ < count_; ++looked_at_) look_at(looked_at_);
        const auto& [x, y, z] = largest_;
        const double height = x * x + y * y + z * z + weight_;
        rows_[seen_infinity].lift = height;
        volume_ = (x * y) * z;
        magnitude_ = volume_ * height;
        bound_ = 24 * power::in_sphere_error * magnitude_;
        if (!in_environment_ || !predicates::in_filter_window(largest_) ||
            !(magnitude_ <= 0x1p1018)) [[unlikely]]
            volume_ = magnitude_ = bound_ = std::numeric_limits<double>::infinity();
    }

    [[nodiscard]] const S& at(Index v) const noexcept { return sites_[v]; }
    [[nodiscard]] Index eye() const noexcept { return eye_; }
    [[nodiscard]] Index name(Seen v) const noexcept { return names_[v]; }
    [[nodiscard]] const ViewRow* rows() const noexcept { return rows_.data(); }
    /// Of one that was seen before the bound was set.
    [[nodiscard]] const ViewRow& row(Seen v) const noexcept { return rows_[v]; }
    [[nodiscard]] std::array<const ViewRow*, 4> rows(
        const std::array<Seen, 4>& cell) const noexcept {
        return {&row(cell[0]), &row(cell[1]), &row(cell[2]), &row(cell[3])};
    }
    [[nodiscard]] double in_sphere(const std::array<Seen, 4>& cell) const noexcept {
        return power::in_sphere_determinant(row(cell[0]), row(cell[1]), row(cell[2]), row(cell[3]));
    }
    /// A determinant is in error by less than this.
    [[nodiscard]] double bound() const noexcept { return bound_; }
    /// The largest that the sum of the magnitudes of its terms can be, over 24.
    [[nodiscard]] double magnitude() const noexcept { return magnitude_; }
    /// The largest offsets along the axes, the largest of these, and the largest height.
    [[nodiscard]] const predicates::Offset3<double>& largest() const noexcept { return largest_; }
    [[nodiscard]] double reach() const noexcept {
        return std::max(std::max(largest_.x, largest_.y), largest_.z);
    }
    [[nodiscard]] double height() const noexcept { return rows_[seen_infinity].lift; }
    /// The same for orientations, over 6.
    [[nodiscard]] double volume() const noexcept { return volume_; }

 private:
    void look_at(std::size_t number) noexcept {
        using filters::magnitude;
        const power::LiftedRow<double> row = power::lifted_row(at(names_[number]), at(eye_));
        rows_[number] = {row.offset, row.height()};
        largest_ = {std::max(largest_.x, magnitude(row.offset.x)),
                    std::max(largest_.y, magnitude(row.offset.y)),
                    std::max(largest_.z, magnitude(row.offset.z))};
        weight_ = std::max(weight_, magnitude(row.weight));
    }

    const S* sites_;
    Index eye_ = 0;
    bool in_environment_ = true;
    std::size_t count_ = 1;
    std::size_t looked_at_ = 1;  // of those that are seen
    LargeArray<ViewRow> rows_ = LargeArray<ViewRow>(64, ViewRow{});
    LargeArray<Index> names_ = LargeArray<Index>(64, -1);
    predicates::Offset3<double> largest_{};
    double weight_ = 0.0;
    double volume_ = 0.0;
    double magnitude_ = 0.0;
    double bound_ = 0.0;
};

}  // namespace signum::spatial

SIGNUM_IEEE_END
