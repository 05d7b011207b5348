#pragma once
/// A view of sites that lie anywhere in memory with a constant stride: a vector of Site, a
/// row-major matrix, three columns, a struct of one's own. Nothing is copied.

#include <cstddef>
#include <span>
#include <type_traits>

#include "contract.hpp"
#include "site.hpp"

namespace signum {

/// Sites, seen where they are; to copy a view copies no site.
class StridedSites {
 public:
    StridedSites() = default;

    /// A contiguous range of Site (third is a radius), power::Site (third is a weight) or Point
    /// (third is 0).
    template <class Range>
    requires requires(const Range& range) { std::span(range); }
    // NOLINTNEXTLINE(google-explicit-constructor): a vector of sites is a view of sites
    StridedSites(const Range& range) noexcept {
        const std::span all(range);
        using Element = std::remove_cv_t<typename decltype(all)::element_type>;
        static_assert(std::is_same_v<Element, Site> || std::is_same_v<Element, power::Site> ||
                          std::is_same_v<Element, Point>,
                      "a range of Site, power::Site or Point; other layouts give three pointers");
        const Element* first = all.data();
        size_ = all.size();
        stride_ = static_cast<std::ptrdiff_t>(sizeof(Element));
        third_is_weight_ = std::is_same_v<Element, power::Site>;
        if (first == nullptr) return;
        x_ = &first->x;
        y_ = &first->y;
        if constexpr (std::is_same_v<Element, Site>) third_ = &first->r;
        if constexpr (std::is_same_v<Element, power::Site>) third_ = &first->w;
    }

    /// Sites of which the call says what their third number is.
    StridedSites(std::span<const Site> sites, bool third_is_weight) noexcept : StridedSites(sites) {
        third_is_weight_ = third_is_weight;
    }

    /// `size` sites whose numbers stand `stride` bytes apart; third may be null, which means 0.
    /// Precondition: a double may lie at each of these places, so that the stride is a multiple of
    /// its alignment.
    StridedSites(std::size_t size, std::ptrdiff_t stride, const double* x, const double* y,
                 const double* third = nullptr, bool third_is_weight = false) noexcept
        : x_(x),
          y_(y),
          third_(third),
          stride_(stride),
          size_(size),
          third_is_weight_(third_is_weight) {
        SIGNUM_EXPECTS(stride % static_cast<std::ptrdiff_t>(alignof(double)) == 0);
    }

    /// How many sites.
    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    /// Where the first numbers of sites begin.
    [[nodiscard]] const double* x() const noexcept { return x_; }
    /// Where the second ones begin.
    [[nodiscard]] const double* y() const noexcept { return y_; }
    /// Where the third ones begin; null where there are none.
    [[nodiscard]] const double* third() const noexcept { return third_; }
    /// How many bytes lie between the numbers of one site and those of the next.
    [[nodiscard]] std::ptrdiff_t stride() const noexcept { return stride_; }
    /// Whether the third number of a site is a weight, not a radius.
    [[nodiscard]] bool third_is_weight() const noexcept { return third_is_weight_; }
    /// Precondition: i < size().
    [[nodiscard]] Site operator[](std::size_t i) const noexcept {
        return {at(x_, i), at(y_, i), third_ == nullptr ? 0.0 : at(third_, i)};
    }
    /// Site i will be read soon: for who goes through sites in an order that memory does not
    /// foresee.
    void prefetch(std::size_t i) const noexcept {
        __builtin_prefetch(reinterpret_cast<const char*>(x_) +
                           static_cast<std::ptrdiff_t>(i) * stride_);
    }

 private:
    [[nodiscard]] double at(const double* first, std::size_t i) const noexcept {
        const char* bytes = reinterpret_cast<const char*>(first);
        return *reinterpret_cast<const double*>(bytes + static_cast<std::ptrdiff_t>(i) * stride_);
    }

    const double* x_ = nullptr;
    const double* y_ = nullptr;
    const double* third_ = nullptr;
    std::ptrdiff_t stride_ = 0;
    std::size_t size_ = 0;
    bool third_is_weight_ = false;
};

/// Whether all third numbers are the same. O(n).
[[nodiscard]] inline bool equal_radii(const StridedSites& sites) noexcept {
    for (std::size_t i = 1; i < sites.size(); ++i)
        if (sites[i].r != sites[0].r) return false;
    return true;
}

}  // namespace signum
