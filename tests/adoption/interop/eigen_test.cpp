/// Eigen's matrices as sites: whatever their strides, what is told is what is told of the same
/// sites in a vector.

#include <cmath>
#include <cstdint>
#include <random>
#include <span>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "../../../bindings/interop/eigen.hpp"
#include "../../../triangulation/triangulate.hpp"
#include "../../../triangulation/validate.hpp"

namespace {

using signum::Index;
using signum::Site;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Spread, on a grid, on a line, at one place; with four numbers a row.
Rows numbers(int kind, int count) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> spread(0.0, 1.0);
    std::uniform_int_distribution<int> whole(0, 4);
    Rows result(count, 4);
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < 4; ++k)
            result(i, k) = kind == 0   ? spread(random)
                           : kind == 1 ? whole(random)
                           : kind == 2 ? i
                                       : 1.0;
    return result;
}
std::vector<Site> plain(const Rows& rows) {
    std::vector<Site> result;
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
        result.push_back({rows(i, 0), rows(i, 1), rows(i, 2) / 4.0});
    return result;
}

constexpr int kinds = 4;
constexpr int counts[] = {0, 1, 2, 50};

TEST(Eigen, SitesOfThePlaneWhateverTheStrides) {
    for (int kind = 0; kind < kinds; ++kind)
        for (const int count : counts) {
            SCOPED_TRACE(testing::Message() << "kind " << kind << ", " << count << " sites");
            Rows rows = numbers(kind, count);
            rows.col(2) /= 4.0;
            const std::vector<Site> same = plain(numbers(kind, count));
            const auto expected = signum::triangulate(same, signum::Euclidean{}).arrays();
            const auto check = [&](const auto& matrix) {
                const signum::StridedSites sites = signum::eigen::sites(matrix);
                EXPECT_EQ(signum::triangulate(sites, signum::Euclidean{}).arrays(), expected);
            };
            const Eigen::MatrixXd columns = rows;
            check(rows.leftCols(3));
            check(columns.leftCols(3));
            check(Eigen::Matrix<double, Eigen::Dynamic, 3>(columns.leftCols(3)));
            check(Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>(columns.leftCols(3)));
            check(Eigen::Ref<const Eigen::MatrixXd>(columns.leftCols(3)));
            // Every second row of a larger matrix, and every second column of one.
            Rows larger = Rows::Constant(2 * count + 1, 9, -7.0);
            for (int i = 0; i < count; ++i)
                for (int k = 0; k < 3; ++k) larger(2 * i + 1, 2 * k + 1) = rows(i, k);
            using Strides = Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>;
            check(Eigen::Map<const Rows, 0, Strides>(larger.data() + 9 + 1, count, 3,
                                                     Strides(18, 2)));
        }
}

TEST(Eigen, ThirdColumnIsARadiusOrAWeightOrMissing) {
    const Rows rows = numbers(0, 50);
    std::vector<signum::power::Site> weights;
    std::vector<signum::Point> points;
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
        weights.push_back({rows(i, 0), rows(i, 1), rows(i, 2)});
        points.push_back({rows(i, 0), rows(i, 1)});
    }
    const auto of_weights = signum::triangulate(
        signum::eigen::sites(rows.leftCols(3), signum::WeightIs::weight), signum::Power{});
    EXPECT_EQ(of_weights.arrays(), signum::triangulate(weights, signum::Power{}).arrays());
    const auto of_points =
        signum::triangulate(signum::eigen::sites(rows.leftCols<2>()), signum::Power{});
    EXPECT_EQ(of_points.arrays(), signum::triangulate(points, signum::Power{}).arrays());
    EXPECT_THROW((void)signum::eigen::sites(rows), std::invalid_argument);
    EXPECT_THROW((void)signum::eigen::sites(rows.leftCols(1)), std::invalid_argument);
    EXPECT_THROW((void)signum::eigen::space_sites<signum::Point3>(rows.leftCols(2)),
                 std::invalid_argument);
}

template <class S>
void expect_space(const Rows& rows) {
    constexpr auto width = static_cast<Eigen::Index>(sizeof(S) / sizeof(double));
    std::vector<S> same;
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
        if constexpr (width == 3)
            same.push_back({rows(i, 0), rows(i, 1), rows(i, 2)});
        else
            same.push_back({rows(i, 0), rows(i, 1), rows(i, 2), rows(i, 3)});
    }
    const auto expected = signum::triangulate(std::span<const S>(same));
    const Rows packed = rows.leftCols(width);
    const Eigen::MatrixXd columns = packed;
    const auto as_it_lies = signum::eigen::space_sites<S>(packed);
    const auto by_columns = signum::eigen::space_sites<S>(columns);
    const auto copied = signum::eigen::space_sites<S>(rows.leftCols(width));
    EXPECT_FALSE(as_it_lies.is_copy());
    if (rows.rows() > 0) {
        EXPECT_EQ(static_cast<const void*>(std::span<const S>(as_it_lies).data()),
                  static_cast<const void*>(packed.data()));
        EXPECT_TRUE(by_columns.is_copy());
    }
    EXPECT_EQ(signum::triangulate(as_it_lies), expected);
    EXPECT_EQ(signum::triangulate(by_columns), expected);
    EXPECT_EQ(signum::triangulate(copied), expected);
}
TEST(Eigen, SitesOfSpace) {
    for (int kind = 0; kind < kinds; ++kind)
        for (const int count : counts) {
            SCOPED_TRACE(testing::Message() << "kind " << kind << ", " << count << " sites");
            const Rows rows = numbers(kind, count);
            expect_space<signum::Point3>(rows);
            expect_space<signum::Site3>(rows);
            expect_space<signum::power::Site3>(rows);
        }
}

TEST(Eigen, ResultsAreViewsOfTheArrays) {
    const std::vector<Site> sites = plain(numbers(1, 50));
    const auto plane = signum::triangulate(sites, signum::Power{});
    const auto faces = signum::eigen::matrix(plane.faces());
    EXPECT_EQ(faces.data(), plane.faces().front().data());
    ASSERT_EQ(faces.rows(), std::ssize(plane.faces()));
    for (Eigen::Index f = 0; f < faces.rows(); ++f)
        for (Eigen::Index k = 0; k < 3; ++k)
            EXPECT_EQ(faces(f, k),
                      plane.faces()[static_cast<std::size_t>(f)][static_cast<std::size_t>(k)]);
    ASSERT_FALSE(plane.hidden().empty());
    const auto hidden = signum::eigen::matrix(plane.hidden());
    EXPECT_EQ(hidden(0, 0), plane.hidden()[0].site);
    EXPECT_EQ(hidden(0, 1), plane.hidden()[0].by);
    const auto back = signum::eigen::matrix(plane.sites());
    EXPECT_EQ(back(7, 2), sites[7].r);
    EXPECT_EQ(signum::eigen::matrix(std::span<const signum::Point>()).rows(), 0);
}

TEST(Eigen, FacesFromAMatrix) {
    const std::vector<Site> sites = plain(numbers(0, 50));
    const auto plane = signum::triangulate(sites, signum::Power{});
    const Eigen::Matrix<Index, Eigen::Dynamic, Eigen::Dynamic> columns =
        signum::eigen::matrix(plane.faces());
    signum::TessellationArrays arrays = plane.arrays();
    arrays.faces = signum::eigen::rows<signum::Face>(columns);
    EXPECT_EQ(arrays, plane.arrays());
    EXPECT_TRUE(signum::validate(arrays, sites).canonical);
    EXPECT_THROW((void)signum::eigen::rows<signum::SpaceCell>(columns), std::invalid_argument);
}

}  // namespace
