/// signum's insertion with every ccw and in_circle asked of Shewchuk's adaptive predicates
/// (Shewchuk 1997), so that nothing but the predicates differs. Exact zeros go to signum's tie
/// rule. TetGen's package has them in a shared library; no call of them can be inlined.

#include "../triangulation/construction/constructions.hpp"

#include "construction.hpp"

void exactinit(int verbose, int noexact, int nofilter, double max_x, double max_y, double max_z);
double orient2d(double* a, double* b, double* c);
double incircle(double* a, double* b, double* c, double* d);

namespace signum::benchmarks {
namespace {

using triangulation::PowerKernel;

class ShewchukKernel : public PowerKernel<triangulation::PowerSigns<Point>, filters::NoTally> {
 public:
    using PowerKernel::PowerKernel;

    [[nodiscard]] Sign ccw(Index a, Index b, Index q) const noexcept {
        double points[3][2];
        take(a, points[0]);
        take(b, points[1]);
        take(q, points[2]);
        return sign_of(orient2d(points[0], points[1], points[2]));
    }

    [[nodiscard]] bool conflicts(Index i, Index j, Index k, Index q) const noexcept {
        double points[4][2];
        const Index numbers[4] = {i, j, k, q};
        for (int m = 0; m < 4; ++m) take(numbers[m], points[m]);
        const Sign sign = sign_of(incircle(points[0], points[1], points[2], points[3]));
        if (sign != 0) [[likely]]
            return sign > 0;
        std::array<Index, 4> ranks{};
        for (std::size_t a = 0; a < 4; ++a)
            for (std::size_t b = 0; b < a; ++b) ++ranks[precedes(numbers[a], numbers[b]) ? b : a];
        return power::in_circle_tie(centre(i), centre(j), centre(k), centre(q), ranks) > 0;
    }

    [[nodiscard]] bool conflicts_infinite(Index a, Index b, Index q) noexcept {
        const Sign side = ccw(a, b, q);
        return side != 0 ? side < 0 : conflicts_on_line(a, b, q);
    }

 private:
    [[nodiscard]] static Sign sign_of(double value) noexcept { return (value > 0) - (value < 0); }
    void take(Index i, double* to) const noexcept {
        const Point point = centre(i);
        to[0] = point.x;
        to[1] = point.y;
    }
};

}  // namespace

Construction prepare_shewchuk(const std::vector<Site>& sites) {
    exactinit(0, 0, 0, 1.0, 1.0, 1.0);  // the largest coordinates count in space alone
    return [sites] {
        return built(triangulation::construct_with_kernel<ShewchukKernel>(
            Metric::power, sites, Options{.threads = 1}, triangulation::PowerSigns<Point>{}));
    };
}

}  // namespace signum::benchmarks
