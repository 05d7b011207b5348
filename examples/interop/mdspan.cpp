// Sites in anything that has a pointer, extents and strides, as std::mdspan does: a column that is
// no part of a site is stepped over, and nothing is copied.

#include <array>
#include <cstddef>
#include <cstdio>
#include <vector>

#include <signum/core/strided_sites.hpp>
#include <signum/triangulation/triangulate.hpp>

namespace {

// As much of std::mdspan as is asked for here.
template <class Number>
class Matrix {
 public:
    using element_type = Number;
    Matrix(Number* data, std::array<std::size_t, 2> extents, std::array<std::size_t, 2> strides)
        : data_(data), extents_(extents), strides_(strides) {}
    Number* data_handle() const { return data_; }
    std::size_t extent(std::size_t dimension) const { return extents_[dimension]; }
    std::size_t stride(std::size_t dimension) const { return strides_[dimension]; }

 private:
    Number* data_;
    std::array<std::size_t, 2> extents_;
    std::array<std::size_t, 2> strides_;
};

/// The rows as sites: x, y and, where there is a third column, the radius.
template <class M>
requires std::is_same_v < std::remove_const_t<typename M::element_type>,
double > signum::StridedSites sites(const M& matrix) {
    const double* first = matrix.data_handle();
    const std::size_t column = matrix.stride(1);
    return {matrix.extent(0), static_cast<std::ptrdiff_t>(matrix.stride(0) * sizeof(double)), first,
            first + column, matrix.extent(1) > 2 ? first + 2 * column : nullptr};
}

}  // namespace

int main() {
    const std::vector<double> rows = {0, 0, 1, -1, 4, 0, 2, -1, 0, 3, 1, -1, 4, 1, 0.5, -1};
    const std::vector<double> columns = {0, 4, 0, 4, 0, 0, 3, 1, 1, 2, 1, 0.5};
    const auto one =
        signum::triangulate(sites(Matrix(rows.data(), {4, 3}, {4, 1})), signum::Euclidean{});
    const auto other =
        signum::triangulate(sites(Matrix(columns.data(), {4, 3}, {1, 4})), signum::Euclidean{});
    for (const auto& [a, b, c] : one.faces()) std::printf("%d %d %d\n", a, b, c);
    std::printf("by columns the same: %d\n", one.arrays() == other.arrays());
}
