// Sites in a matrix of Eigen's, faces in another, none of them copied.

#include <signum/interop/eigen.hpp>

#include <cstdio>

#include <signum/triangulation/triangulate.hpp>

int main() {
    // A table by columns, of which x, y and the radius are some.
    Eigen::MatrixXd table(4, 5);
    table << 7, 0, 0, 1, 7,  //
        7, 4, 0, 2, 7,       //
        7, 0, 3, 1, 7,       //
        7, 4, 1, 0.5, 7;
    const auto plane =
        signum::triangulate(signum::eigen::sites(table.middleCols(1, 3)), signum::Euclidean{});
    const auto faces = signum::eigen::matrix(plane.faces());  // a map, N×3
    for (Eigen::Index f = 0; f < faces.rows(); ++f)
        std::printf("%d %d %d\n", faces(f, 0), faces(f, 1), faces(f, 2));

    // Points of space: rows one behind the other are taken as they lie, others are copied once.
    Eigen::Matrix<double, 5, 3, Eigen::RowMajor> points;
    points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1;
    const auto space = signum::triangulate(signum::eigen::space_sites<signum::Point3>(points));
    const auto cells = signum::eigen::matrix(std::span(space.cells));  // N×4
    std::printf("%d finite cells of %d\n", static_cast<int>((cells.col(0).array() >= 0).count()),
                static_cast<int>(cells.rows()));
}
