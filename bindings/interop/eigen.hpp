#pragma once
/// Eigen's matrices as sites, and results as Eigen's matrices; without a copy but where it is said.
///
/// Laws:
///  1. A row is a site: x y, and perhaps a radius or a weight; in space x y z, and perhaps the
///  same.
///  2. Matrices, maps, Refs and blocks of them are legal, by rows or by columns, with any strides.
///     Numbers must be doubles: others do not compile, for nothing is to be rounded, or copied,
///     behind the caller's back.
///  3. What views something does not own it: it is valid as long as that is, and no longer than the
///     matrix keeps its memory.

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <Eigen/Core>

#include <signum/core/index.hpp>
#include <signum/core/site.hpp>
#include <signum/core/strided_sites.hpp>
#include <signum/triangulation/metric.hpp>
#include <signum/triangulation/space/triangulate.hpp>
#include <signum/triangulation/tessellation.hpp>

namespace signum::eigen {

namespace details {

/// Says in a sentence what is wrong with a matrix, when it is compiled.
template <class Derived, int least, int greatest>
constexpr void expect_matrix() {
    static_assert(
        std::same_as<typename Derived::Scalar, double>,
        "signum takes sites from matrices of double: convert it first, by .cast<double>()");
    static_assert((Derived::Flags & Eigen::DirectAccessBit) != 0,
                  "signum takes sites from numbers in memory: evaluate the expression first");
    static_assert(
        Derived::ColsAtCompileTime == Eigen::Dynamic ||
            (Derived::ColsAtCompileTime >= least && Derived::ColsAtCompileTime <= greatest),
        "a site is a row, of x and y or of x, y and a radius or weight; in space a z comes third");
}

/// For matrices whose number of columns is known only when the program runs.
inline void expect_columns(Eigen::Index columns, Eigen::Index least, Eigen::Index greatest) {
    if (columns >= least && columns <= greatest) return;
    throw std::invalid_argument(
        "a matrix of " + std::to_string(columns) + " columns is no list of sites, of " +
        (least == greatest ? std::to_string(least)
                           : std::to_string(least) + " or " + std::to_string(greatest)));
}

template <class Derived>
[[nodiscard]] std::ptrdiff_t between_rows(const Derived& matrix) {
    return Derived::IsRowMajor ? matrix.outerStride() : matrix.innerStride();
}
template <class Derived>
[[nodiscard]] const double* column(const Derived& matrix, Eigen::Index k) {
    return matrix.data() + k * (Derived::IsRowMajor ? matrix.innerStride() : matrix.outerStride());
}

/// The numbers of a point or site of space.
template <class S>
inline constexpr Eigen::Index numbers_of = static_cast<Eigen::Index>(sizeof(S) / sizeof(double));

template <class S>
concept SpaceSite =
    std::same_as<S, Point3> || std::same_as<S, signum::Site3> || std::same_as<S, power::Site3>;

template <class Number, int columns>
using Rows = Eigen::Map<const Eigen::Matrix<Number, Eigen::Dynamic, columns, Eigen::RowMajor>>;

}  // namespace details

/// An N×2 or N×3 matrix as the sites of triangulate(), not copied. Throws std::invalid_argument for
/// another number of columns. O(1).
template <class Derived>
[[nodiscard]] StridedSites sites(const Eigen::DenseBase<Derived>& matrix,
                                 WeightIs third = WeightIs::radius) {
    details::expect_matrix<Derived, 2, 3>();
    const Derived& rows = matrix.derived();
    details::expect_columns(rows.cols(), 2, 3);
    if (rows.rows() == 0) return {};
    return {static_cast<std::size_t>(rows.rows()),
            details::between_rows(rows) * static_cast<std::ptrdiff_t>(sizeof(double)),
            details::column(rows, 0),
            details::column(rows, 1),
            rows.cols() == 3 ? details::column(rows, 2) : nullptr,
            third == WeightIs::weight};
}

/// Sites of space, as the span that triangulation/space/triangulate.hpp takes: the matrix itself
/// where its rows lie one behind the other (row-major and without gaps), otherwise a copy of it.
template <details::SpaceSite S>
class SpaceSites {
 public:
    template <class Derived>
    explicit SpaceSites(const Derived& rows) : size_(static_cast<std::size_t>(rows.rows())) {
        constexpr Eigen::Index width = details::numbers_of<S>;
        if (Derived::IsRowMajor && rows.innerStride() == 1 && rows.outerStride() == width) {
            first_ = rows.data();
            return;
        }
        copy_.reserve(size_ * static_cast<std::size_t>(width));
        for (Eigen::Index i = 0; i < rows.rows(); ++i)
            for (Eigen::Index k = 0; k < width; ++k) copy_.push_back(rows.coeff(i, k));
    }

    [[nodiscard]] bool is_copy() const noexcept { return !copy_.empty(); }
    // NOLINTNEXTLINE(google-explicit-constructor): they are what triangulate() takes
    [[nodiscard]] operator std::span<const S>() const noexcept {
        static_assert(std::is_standard_layout_v<S> && alignof(S) == alignof(double));
        return {reinterpret_cast<const S*>(is_copy() ? copy_.data() : first_), size_};
    }

 private:
    const double* first_ = nullptr;
    std::size_t size_ = 0;
    std::vector<double> copy_;
};

/// An N×3 matrix as points of space (S = Point3), an N×4 matrix as balls (Site3) or as sites that
/// carry a weight (power::Site3). Throws std::invalid_argument for another number of columns. O(1),
/// or O(N) where it is copied.
template <details::SpaceSite S, class Derived>
[[nodiscard]] SpaceSites<S> space_sites(const Eigen::DenseBase<Derived>& matrix) {
    constexpr int width = static_cast<int>(details::numbers_of<S>);
    details::expect_matrix<Derived, width, width>();
    details::expect_columns(matrix.cols(), width, width);
    return SpaceSites<S>(matrix.derived());
}

/// Faces or their neighbours as an N×3 matrix of 32-bit integers, a view.
[[nodiscard]] inline details::Rows<Index, 3> matrix(std::span<const Face> faces) {
    return {faces.empty() ? nullptr : faces.front().data(), static_cast<Eigen::Index>(faces.size()),
            3};
}
/// Cells of space or their neighbours as an N×4 matrix, a view.
[[nodiscard]] inline details::Rows<Index, 4> matrix(std::span<const SpaceCell> cells) {
    return {cells.empty() ? nullptr : cells.front().data(), static_cast<Eigen::Index>(cells.size()),
            4};
}
/// Edges, or hidden sites and who hides them, as an N×2 matrix, a view.
[[nodiscard]] inline details::Rows<Index, 2> matrix(std::span<const Edge> edges) {
    return {edges.empty() ? nullptr : edges.front().data(), static_cast<Eigen::Index>(edges.size()),
            2};
}
[[nodiscard]] inline details::Rows<Index, 2> matrix(std::span<const Hidden> hidden) {
    static_assert(sizeof(Hidden) == 2 * sizeof(Index));
    return {hidden.empty() ? nullptr : &hidden.front().site,
            static_cast<Eigen::Index>(hidden.size()), 2};
}

/// Points and sites as the rows of a matrix, a view: N×2 of Point, N×3 of Site, power::Site and
/// Point3, N×4 of Site3 and power::Site3.
template <class S>
requires std::same_as<S, Point> || std::same_as<S, Site> || std::same_as<S, power::Site> ||
    details::SpaceSite<S>
[[nodiscard]] auto matrix(std::span<const S> sites) {
    return details::Rows<double, static_cast<int>(details::numbers_of<S>)>(
        sites.empty() ? nullptr : &sites.front().x, static_cast<Eigen::Index>(sites.size()),
        details::numbers_of<S>);
}

/// The other way: rows of a matrix of 32-bit integers as faces, neighbours (N×3) or cells (N×4),
/// copied. Throws std::invalid_argument for another number of columns. What the numbers say
/// Tessellation and validate() look at. O(N).
template <class Row, class Derived>
requires std::same_as<Row, Face> || std::same_as<Row, SpaceCell>
[[nodiscard]] std::vector<Row> rows(const Eigen::DenseBase<Derived>& matrix) {
    static_assert(
        std::same_as<typename Derived::Scalar, Index>,
        "faces and cells are 32-bit integers: convert the matrix, by .cast<std::int32_t>()");
    constexpr auto width = static_cast<Eigen::Index>(std::tuple_size_v<Row>);
    details::expect_columns(matrix.cols(), width, width);
    std::vector<Row> result(static_cast<std::size_t>(matrix.rows()));
    for (Eigen::Index i = 0; i < matrix.rows(); ++i)
        for (Eigen::Index k = 0; k < width; ++k)
            result[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] =
                matrix.derived().coeff(i, k);
    return result;
}

}  // namespace signum::eigen
