/// Builds the tessellation of the sites of a file of doubles, x and y in turn, each time a line
/// comes on standard input, and says how many seconds it took: what benchmarks/python.py compares
/// with.

#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "../triangulation/triangulate.hpp"

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "python_rival FILE METRIC\n");
        return 2;
    }
    std::ifstream file(argv[1], std::ios::binary | std::ios::ate);
    const auto metric = signum::metric_named(argv[2]);
    if (!file || !metric) {
        std::fprintf(stderr, "python_rival: no such file or metric\n");
        return 2;
    }
    std::vector<signum::Point> sites(static_cast<std::size_t>(file.tellg()) /
                                     sizeof(signum::Point));
    file.seekg(0);
    file.read(reinterpret_cast<char*>(sites.data()),
              static_cast<std::streamsize>(sites.size() * sizeof(signum::Point)));
    for (std::string line; std::getline(std::cin, line);) {
        const auto start = std::chrono::steady_clock::now();
        const signum::Tessellation result = signum::triangulate(sites, *metric, {.threads = 1});
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        std::printf("%.6f %zu\n", taken.count(), result.faces().size());
        std::fflush(stdout);
    }
}
