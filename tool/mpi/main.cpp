/// signum-mpi: tessellations of sites that many ranks hold together, from one file and into one.

#include <mpi.h>

#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "../../mpi/triangulate.hpp"
#include "../../triangulation/metric.hpp"
#include "../io/errors.hpp"
#include "outputs.hpp"
#include "slices.hpp"

namespace signum::mpi {
namespace {

struct Call {
    std::string sites;
    std::string metric = "power";
    std::string radii;
    std::string weights;
    bool thirds_are_weights = false;
    bool is_quiet = false;
    std::vector<std::string> outputs;
};

/// The metric, by any of its names.
Metric metric_of(const std::string& name) {
    for (const MetricTraits& traits : metric_table) {
        if (name == traits.name) return traits.metric;
        for (const std::string_view alias : traits.aliases)
            if (!alias.empty() && name == alias) return traits.metric;
    }
    throw CLI::ValidationError("--metric", fmt::format("'{}' is none of power, euclidean, manhattan, supremum", name));
}

/// One line: what was built, and what the ranks told one another.
void summarize(Communicator& ranks, const Stretch& stretch, const RankTessellation& built,
               double seconds, const Call& call) {
    const auto owned = static_cast<std::int64_t>(built.sites.size());
    const std::int64_t most_owned = ranks.most(owned);
    const std::int64_t told = ranks.sum(static_cast<std::int64_t>(built.cost.sites_told));
    const std::int64_t sent = ranks.sum(static_cast<std::int64_t>(built.cost.bytes_sent));
    const std::int64_t all = ranks.sum(static_cast<std::int64_t>(1e6 * built.cost.processor_seconds));
    const std::int64_t busiest = ranks.most(static_cast<std::int64_t>(1e6 * built.cost.processor_seconds));
    if (ranks.rank() != 0 || call.is_quiet) return;
    fmt::print(stderr,
               "{} sites, {} hidden, {} faces, {} metric; {} rank{}, {:.3g} s\n"
               "sites a rank: {} at most; told of others: {} in {} rounds; sent: {:.1f} MB; "
               "processor: {:.3g} s, busiest rank {:.3g} s\n",
               built.whole, stretch.hidden_of_all, stretch.faces_of_all, call.metric, ranks.size(),
               ranks.size() == 1 ? "" : "s", seconds, most_owned, told, built.cost.rounds,
               static_cast<double>(sent) / 1e6, static_cast<double>(all) / 1e6,
               static_cast<double>(busiest) / 1e6);
}

void triangulate(Communicator& ranks, const Call& call) {
    const double start = MPI_Wtime();
    const Metric metric = metric_of(call.metric);
    const std::string& thirds = call.weights.empty() ? call.radii : call.weights;
    const Slices slices = read_slices(ranks, call.sites, thirds);
    const bool has_thirds = ranks.most(slices.has_thirds ? 1 : 0) != 0;
    const bool are_weights = call.thirds_are_weights || !call.weights.empty();
    if (ranks.rank() == 0 && !call.is_quiet && has_thirds && thirds.empty())
        fmt::print(stderr, "{}: the third column is taken for {}\n", call.sites,
                   are_weights ? "weights" : "radii");
    RankTessellation built = mpi::triangulate(
        slices.sites, ranks.get(), metric, are_weights ? WeightIs::weight : WeightIs::radius);
    const Stretch stretch = in_order(built, ranks.get());
    for (const std::string& output : call.outputs)
        write(ranks, output,
              {slices.sites, built.whole, stretch, metric,
               are_weights ? WeightIs::weight : WeightIs::radius});
    summarize(ranks, stretch, built, MPI_Wtime() - start, call);
}

/// Says on one rank what is wrong there.
int report(std::size_t rank, const char* message, int code) {
    std::fprintf(stderr, "signum-mpi: rank %zu: %s\n", rank, message);
    return code;
}

int run(Communicator& ranks, int count, char** words) {
    CLI::App tool("Tessellations of the plane from sites that many ranks hold together: the result of\n"
                  "signum triangulate, and the same bytes for every number of ranks.\n"
                  "    mpirun -n 8 signum-mpi triangulate sites.h5:/points --radii /radii -o faces.h5");
    tool.require_subcommand(1);
    tool.set_version_flag("--version", SIGNUM_VERSION);
    Call call;
    CLI::App* const command = tool.add_subcommand(
        "triangulate", "Faces of all sites, from text (x y, x y r), .npy, .f64 or FILE.h5:/path");
    command->add_option("SITES", call.sites, "FILE, or FILE.h5:/path/to/coordinates")->required();
    command->add_option("-m,--metric", call.metric, "power, euclidean, manhattan or supremum (power)");
    command->add_option("--radii", call.radii, "where in FILE.h5 the radii are");
    command->add_option("--weights", call.weights, "the same of weights, in the power metric");
    command->add_flag("--third-is-weight", call.thirds_are_weights, "the third column is a weight, not a radius");
    command->add_option("-o,--output", call.outputs, "FILE.h5 or .vtkhdf, .npy, .i32, .json; more than once if you like")
        ->required()
        ->each([](const std::string& name) {
            if (!can_write(name))
                throw CLI::ValidationError("-o", name + " ends as nothing that is written: .h5, .vtkhdf, .npy, .i32, .json");
        });
    command->add_flag("-q,--quiet", call.is_quiet, "no summary");
    const bool speaks = ranks.rank() == 0;
    try {
        tool.parse(count, words);
        triangulate(ranks, call);
        return 0;
    } catch (const CLI::ParseError& error) {
        if (!speaks) return error.get_exit_code() == 0 ? 0 : 2;
        if (error.get_exit_code() == 0) return tool.exit(error);
        std::fprintf(stderr, "signum-mpi: %s\n", error.what());
        return 2;
    } catch (const OtherFailed&) {
        return 0;  // who has failed says why
    } catch (const InputError& error) {
        return report(ranks.rank(), error.what(), 2);
    } catch (const NameError& error) {
        return report(ranks.rank(), error.what(), 2);
    } catch (const distributed::NoStructure& error) {
        return speaks ? report(0, fmt::format("{}: {}; signum triangulate takes them", call.sites, error.what()).c_str(), 2) : 2;
    } catch (const std::invalid_argument& error) {
        return report(ranks.rank(), error.what(), 2);
    } catch (const std::bad_alloc&) {
        return report(ranks.rank(), "not enough memory; take more ranks, on more machines", 3);
    } catch (const std::exception& error) {
        return report(ranks.rank(), error.what(), 3);
    }
}

}  // namespace
}  // namespace signum::mpi

int main(int count, char** words) {
    MPI_Init(&count, &words);
    int code = 3;
    {
        signum::mpi::Communicator ranks(MPI_COMM_WORLD);
        const int own = signum::mpi::run(ranks, count, words);
        // All end alike.
        MPI_Allreduce(&own, &code, 1, MPI_INT, MPI_MAX, ranks.get());
    }
    MPI_Finalize();
    return code;
}
