/// The diagram of random balls beside the program `voronota` (apt install voronota): seconds of one
/// processor, and
/// every quadruple that one has and the other has not.
///
///     ball_diagram_benchmark [n [seed [side]]]
///
/// n balls with radii from 1 to 3, their centres in a cube: as dense that a tenth is hidden, unless
/// the side is given. voronota reads and writes text, so that its time holds some of that; to see
/// how much, the time to print ours follows.

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <signum/predicates/space.hpp>
#include <signum/voronoi/balls/diagram.hpp>

#include "measuring.hpp"

namespace {

using signum::BallDiagram;
using signum::Index;
using signum::Site3;
using Quadruple = std::array<Index, 4>;
using signum::benchmarks::random_balls;
using signum::benchmarks::seconds_of;
using Spheres = std::map<Quadruple, std::vector<Site3>>;

/// Of the processor, by the programs that this process has called: other work on the machine counts
/// less than it does on the clock.
double seconds_of_children() {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

/// What the exact predicates say of a quadruple: how many of its spheres exist, and how many of
/// these are empty.
std::string judged(const std::vector<Site3>& balls, const Quadruple& four) {
    int existing = 0, empty = 0, conflicts = 0;
    for (const bool positive : {true, false}) {
        const auto at = [&](std::size_t k) -> const Site3& {
            return balls[static_cast<std::size_t>(four[k])];
        };
        const Site3 &a = at(0), &b = at(positive ? 1 : 2), &c = at(positive ? 2 : 1), &d = at(3);
        if (!signum::euclidean::exists(a, b, c, d)) continue;
        ++existing;
        int inside = 0;
        for (const Site3& q : balls) inside += signum::euclidean::in_sphere(a, b, c, d, q) > 0;
        empty += inside == 0;
        conflicts += inside;
    }
    return std::to_string(existing) + " spheres, " + std::to_string(empty) + " of them empty, " +
           std::to_string(conflicts) + " conflicts";
}

}  // namespace

int main(int argc, char** argv) {
    const std::int64_t n = argc > 1 ? std::strtoll(argv[1], nullptr, 10) : 10000;
    const std::uint64_t seed = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1;
    const double side = argc > 3 ? std::atof(argv[3]) : 2.5 * std::cbrt(static_cast<double>(n));
    const std::vector<Site3> balls = random_balls(n, seed, side, 1.0, 3.0);
    BallDiagram diagram;
    double ours = HUGE_VAL;
    for (int run = 0; run < 3; ++run)
        ours = std::min(ours,
                        seconds_of([&] { diagram = signum::ball_diagram(balls, {.threads = 1}); }));
    std::size_t closed = 0, infinite = 0;
    for (const auto& ends : diagram.ends) {
        closed += ends[0] == signum::no_end;
        infinite += ends[0] == signum::infinite;
    }
    std::printf("%zu balls, %zu hidden: %zu vertices, %zu edges (%zu closed, %zu to infinity)\n",
                balls.size(), diagram.hidden.size(), diagram.vertices.size(), diagram.edges.size(),
                closed, infinite);
    std::printf("signum    %8.3f s\n", ours);

    Spheres mine;
    for (std::size_t v = 0; v < diagram.vertices.size(); ++v) {
        Quadruple four;
        std::copy_n(diagram.vertices[v].begin(), 4, four.begin());
        mine[four].push_back(diagram.spheres[v]);
    }
    const double printing = seconds_of([&] {
        std::FILE* out = std::fopen("/dev/null", "w");
        for (const auto& [four, spheres] : mine)
            for (const Site3& s : spheres)
                std::fprintf(out, "%d %d %d %d %.15f %.15f %.15f %.15f\n", four[0], four[1],
                             four[2], four[3], s.x, s.y, s.z, s.r);
        std::fclose(out);
    });
    std::printf("  printed %8.3f s\n", printing);
    if (std::system("command -v voronota > /dev/null") != 0) return 0;

    const std::string folder = [] {
        char name[] = "/tmp/balls_XXXXXX";
        return std::string(mkdtemp(name));
    }();
    const std::string input = folder + "/balls.txt", output = folder + "/vertices.txt";
    if (std::FILE* file = std::fopen(input.c_str(), "w")) {
        for (const Site3& b : balls)
            std::fprintf(file, "%.17g %.17g %.17g %.17g\n", b.x, b.y, b.z, b.r);
        std::fclose(file);
    }
    const std::string command = "voronota calculate-vertices < " + input + " > " + output;
    const double before = seconds_of_children();
    const int status = std::system(command.c_str());
    const double theirs = seconds_of_children() - before;
    std::printf("voronota  %8.3f s   %.1f times as long%s\n", theirs, theirs / ours,
                status == 0 ? "" : ", failed");

    Spheres other;
    std::ifstream vertices(output);
    for (std::string line; std::getline(vertices, line);) {
        std::istringstream words(line);
        Quadruple four;
        Site3 s;
        words >> four[0] >> four[1] >> four[2] >> four[3] >> s.x >> s.y >> s.z >> s.r;
        if (!words) continue;
        std::sort(four.begin(), four.end());
        other[four].push_back(s);
    }
    std::size_t same = 0, differ = 0;
    double farthest = 0.0;
    const auto tell = [&](const char* what, const Quadruple& four) {
        ++differ;
        std::printf("%s %d %d %d %d: %s\n", what, four[0], four[1], four[2], four[3],
                    judged(balls, four).c_str());
    };
    for (const auto& [four, spheres] : mine) {
        const auto found = other.find(four);
        if (found == other.end()) {
            tell("signum alone:  ", four);
            continue;
        }
        if (found->second.size() != spheres.size()) {
            tell(found->second.size() < spheres.size() ? "signum has two: " : "voronota has two:",
                 four);
            continue;
        }
        ++same;
        for (const Site3& s : spheres) {
            double nearest = HUGE_VAL;
            for (const Site3& o : found->second)
                nearest = std::min(nearest, std::hypot(s.x - o.x, s.y - o.y, s.z - o.z) /
                                                (1.0 + std::hypot(s.x, s.y, s.z)));
            farthest = std::max(farthest, nearest);
        }
    }
    for (const auto& [four, spheres] : other)
        if (!mine.contains(four)) tell("voronota alone:", four);
    std::printf(
        "%zu quadruples of both, %zu not; centres of both differ by a part of %.1e at most\n", same,
        differ, farthest);
    std::remove(input.c_str());
    std::remove(output.c_str());
    std::remove(folder.c_str());
}
