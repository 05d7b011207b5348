/// Cells of random balls in the unit cube, triangulation included, beside voro++ where the system
/// has it: taking turns, medians of their times and of the ratios; how far the numbers differ.
///
/// usage: space_cells_benchmark [balls]
/// A volume, area or face differs by a share of itself, or of the mean cell. Neighbours differ
/// where one list has what the other lacks; so little is the largest face that only one of them
/// has.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include <fmt/format.h>

#include "../voronoi/space/cells.hpp"
#include "measuring.hpp"
#if defined(SIGNUM_WITH_VORO)
#include "peer_voro.hpp"
#endif

namespace signum::benchmarks {
namespace {

struct Kind {
    const char* name;
    double least;  ///< radii, in mean distances of centres
    double greatest;
};
constexpr Kind kinds[] = {{"points", 0.0, 0.0},
                          {"radii 1 : 3, apart", 0.1, 0.3},
                          {"radii 1 : 3, packed", 0.25, 0.75},
                          {"radii 1 : 3, crowded", 0.5, 1.5}};

#if defined(SIGNUM_WITH_VORO)
/// How two results differ.
struct Differences {
    double volume = 0.0;  ///< the largest, of itself
    double volume_of_mean = 0.0;
    double area = 0.0;
    double face_of_mean = 0.0;
    std::int64_t lists = 0;  ///< cells whose neighbours are not the same
    double only_one_has = 0.0;

    Differences(const SpaceCells& ours, const SpaceCells& theirs) {
        const double mean = 1.0 / static_cast<double>(ours.measures.size());
        const auto raise = [](double& largest, double value) {
            largest = std::max(largest, std::fabs(value));
        };
        for (std::size_t s = 0; s < ours.measures.size(); ++s) {
            const SpaceMeasure& a = ours.measures[s];
            const SpaceMeasure& b = theirs.measures[s];
            if (a.volume != b.volume)
                raise(volume, (a.volume - b.volume) / std::max(a.volume, b.volume));
            raise(volume_of_mean, (a.volume - b.volume) / mean);
            if (a.area != b.area) raise(area, (a.area - b.area) / std::max(a.area, b.area));
            const auto site = static_cast<Index>(s);
            bool are_same = true;
            const auto alone = [&](const SpaceFace& face) {
                are_same = false;
                raise(only_one_has, face.area * std::pow(mean, -2.0 / 3));
            };
            const auto one = ours.faces_of(site);
            const auto other = theirs.faces_of(site);
            const auto rank = [](const SpaceFace& face) {
                return std::pair(face.beyond < 0, std::abs(face.beyond));
            };
            std::size_t f = 0;
            for (const SpaceFace& face : one) {
                while (f < other.size() && rank(other[f]) < rank(face)) alone(other[f++]);
                if (f < other.size() && other[f].beyond == face.beyond)
                    raise(face_of_mean, (face.area - other[f++].area) * std::pow(mean, -2.0 / 3));
                else
                    alone(face);
            }
            while (f < other.size()) alone(other[f++]);
            if (!are_same) ++lists;
        }
    }
};
#endif

void measure(const Kind& kind, std::int64_t count) {
    constexpr int rounds = 5;
    const double distance = 1.0 / std::cbrt(static_cast<double>(count));
    const std::vector<Site3> sites =
        random_balls(count, 1, 1.0, distance * kind.least, distance * kind.greatest);
    const std::span<const Site3> all(sites);
    const Box3 box = {{0, 0, 0}, {1, 1, 1}};
    std::vector<double> building;
    std::vector<double> cutting;
    std::vector<double> theirs;
    std::vector<double> ratios;
    SpaceCells cells;
    for (int round = 0; round < rounds; ++round) {
        const double begin = seconds();
        const SpaceTessellation tessellation = triangulate(all, Power{}, {.threads = 1});
        const double middle = seconds();
        cells = space_cells(tessellation, all, box, 1);
        const double end = seconds();
        building.push_back(middle - begin);
        cutting.push_back(end - middle);
#if defined(SIGNUM_WITH_VORO)
        const SpaceCells others = cells_of_voro(sites);
        theirs.push_back(seconds() - end);
        ratios.push_back(theirs.back() / (end - begin));
        if (round + 1 < rounds) continue;
        const Differences d(cells, others);
        fmt::print(
            "| {} | {:.3f} | {:.3f} | {:.3f} | {} | {:.1e} | {:.1e} | "
            "{:.1e} | {:.1e} | {} | {:.1e} |\n",
            kind.name, median(building), median(cutting), median(theirs), median_and_range(ratios),
            d.volume, d.volume_of_mean, d.area, d.face_of_mean, d.lists, d.only_one_has);
#endif
    }
    if (theirs.empty())
        fmt::print("| {} | {:.3f} | {:.3f} |\n", kind.name, median(building), median(cutting));
    std::fflush(stdout);
}

}  // namespace
}  // namespace signum::benchmarks

int main(int count, char** words) {
    const std::int64_t balls = count > 1 ? std::strtoll(words[1], nullptr, 10) : 100'000;
    if (balls < 1 || balls > signum::max_sites) return 2;
    fmt::print("{} balls\n\n| balls | triangulate, s | cells, s |", balls);
#if defined(SIGNUM_WITH_VORO)
    fmt::print(
        " voro++, s | ratio | volumes differ | of the mean | surfaces | faces, of the mean "
        "cell's | lists | largest face in one |\n| --- | --: | --: | --: | --: | --: | --: | "
        "--: | --: | --: | --: |\n");
#else
    fmt::print("\n| --- | --: | --: |\n");
#endif
    for (const auto& kind : signum::benchmarks::kinds) signum::benchmarks::measure(kind, balls);
    return 0;
}
