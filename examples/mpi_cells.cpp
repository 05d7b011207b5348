/// A program whose sites lie on many ranks already, and which takes its own cells: how many
/// neighbours each site has, of sites that every rank throws into its own strip.
///
///     mpirun -n 4 mpi_cells 10000

#include <mpi.h>

#include <cstdio>
#include <cstdlib>
#include <random>
#include <span>
#include <vector>

#include "../mpi/triangulate.hpp"

int main(int count, char** words) {
    MPI_Init(&count, &words);
    int rank = 0;
    int ranks = 1;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);

    // Numbers are the program's own, all different: ties are decided by them.
    const long own = count > 1 ? std::atol(words[1]) : 1000;
    if (own < 3) {
        if (rank == 0) std::fprintf(stderr, "usage: mpi_cells [SITES A RANK], 3 or more\n");
        MPI_Finalize();
        return 2;
    }
    std::mt19937_64 random(static_cast<std::uint64_t>(rank));
    std::uniform_real_distribution<double> number(0.0, 1.0);
    std::vector<signum::distributed::Placed> sites;
    for (long i = 0; i < own; ++i)
        sites.push_back({signum::Site{rank + number(random), number(random), 0.0}, rank * own + i});

    const auto built = signum::mpi::triangulate(sites, MPI_COMM_WORLD, {signum::Metric::power});

    // Each site is somebody's, with all its neighbours in the whole.
    long long own_neighbours = 0;
    built.part->each_star([&](std::int64_t, std::span<const std::int64_t> neighbours) {
        for (const std::int64_t each : neighbours) own_neighbours += each >= 0 ? 1 : 0;
    });
    long long all = 0;
    MPI_Reduce(&own_neighbours, &all, 1, MPI_LONG_LONG, MPI_SUM, 0, MPI_COMM_WORLD);
    if (rank == 0)
        std::printf("%lld sites, %.3f neighbours each\n", static_cast<long long>(built.whole),
                    static_cast<double>(all) / static_cast<double>(built.whole));
    MPI_Finalize();
    return 0;
}
