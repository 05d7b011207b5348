/// signum-mpi: tessellations of sites that many ranks hold together, from one file and into one.

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "../../mpi/triangulate.hpp"
#include "../../mpi/validate.hpp"
#include "../../triangulation/metric.hpp"
#include "../io/errors.hpp"
#include "../io/output_file.hpp"
#include "cells.hpp"
#include "outputs.hpp"
#include "read_stretch.hpp"
#include "shared_file.hpp"
#include "slices.hpp"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace signum::mpi {
namespace {

struct Call {
    std::string tessellation;  ///< that is judged
    std::string sites;
    std::string metric;  ///< power, where nothing is said, in space; Euclid's in the plane
    int dimension = 2;
    std::string radii;
    std::string weights;
    bool last_is_weight = false;
    bool is_quiet = false;
    std::vector<std::string> outputs;
};

/// The metric, by any of its names.
Metric metric_of(const Call& call) {
    const bool is_space = call.dimension == 3;
    const auto metric = metric_named(!call.metric.empty() ? call.metric
                                     : is_space           ? "power"
                                                          : "euclidean");
    if (!metric)
        throw CLI::ValidationError(
            "--metric",
            fmt::format("'{}' is none of power, euclidean, manhattan, supremum", call.metric));
    if (is_space && !traits_of(*metric).edges_are_straight)
        throw CLI::ValidationError("--metric",
                                   "in space there are tessellations of the power "
                                   "metric alone");
    return *metric;
}

/// What was built, and what the ranks told one another.
void summarize(Communicator& ranks, const std::string& result, const RankTessellation& built,
               double seconds, const Call& call) {
    const auto owned = static_cast<std::int64_t>(built.sites.size());
    const std::int64_t most_owned = ranks.most(owned);
    const std::int64_t told = ranks.sum(static_cast<std::int64_t>(built.cost.sites_told));
    const std::int64_t sent = ranks.sum(static_cast<std::int64_t>(built.cost.bytes_sent));
    const std::int64_t all =
        ranks.sum(static_cast<std::int64_t>(1e6 * built.cost.processor_seconds));
    const std::int64_t busiest =
        ranks.most(static_cast<std::int64_t>(1e6 * built.cost.processor_seconds));
    if (ranks.rank() != 0 || call.is_quiet) return;
    fmt::print(stderr,
               "{} sites, {}, {} metric; {} rank{}, {:.3g} s\n"
               "sites a rank: {} at most; told of others: {} in {} rounds; sent: {:.1f} MB; "
               "processor: {:.3g} s, busiest rank {:.3g} s\n",
               built.whole, result, name_of(metric_of(call)), ranks.size(),
               ranks.size() == 1 ? "" : "s", seconds, most_owned, told, built.cost.rounds,
               static_cast<double>(sent) / 1e6, static_cast<double>(all) / 1e6,
               static_cast<double>(busiest) / 1e6);
}

/// Sites, and of what kind they are.
struct Input {
    std::vector<distributed::Placed> sites;
    distributed::Kind kind;
};
Input read(Communicator& ranks, const Call& call) {
    const std::string& radii = call.weights.empty() ? call.radii : call.weights;
    Slices slices;
    ranks.together([&] { slices = read_slices(ranks, call.sites, call.dimension, radii); });
    const bool has_radii = ranks.most(slices.has_radii ? 1 : 0) != 0;
    const bool are_weights = call.last_is_weight || !call.weights.empty();
    if (ranks.rank() == 0 && !call.is_quiet && has_radii && radii.empty())
        fmt::print(stderr, "{}: the last column is taken for {}{}\n", call.sites,
                   are_weights ? "weights" : "radii",
                   call.dimension == 2 ? "; --dimension 3 takes x, y, z" : "");
    return {std::move(slices.sites),
            {metric_of(call), are_weights ? WeightIs::weight : WeightIs::radius,
             static_cast<std::size_t>(call.dimension)}};
}

bool asks_for(const Call& call, std::string_view ending) {
    return std::ranges::any_of(call.outputs,
                               [&](const std::string& output) { return output.ends_with(ending); });
}

void triangulate(Communicator& ranks, const Call& call) {
    const double start = MPI_Wtime();
    const Input input = read(ranks, call);
    const auto& kind = input.kind;
    RankTessellation built;
    Stretch stretch;
    VtkGrid piece;
    ranks.together([&] {
        built = mpi::triangulate(input.sites, ranks.get(), kind);
        if (asks_for(call, ".pvtu") && !built.sites.empty())
            piece = grid_of_faces(built.part->known(), kind);
        stretch = in_order(built, ranks.get(), kind);
    });
    for (const std::string& output : call.outputs)
        ranks.together([&] {
            write(ranks, output,
                  {input.sites, built.whole, stretch, kind.metric, kind.weight_is, piece});
        });
    summarize(ranks,
              fmt::format("{} hidden, {} {}", stretch.hidden_of_all, stretch.faces_of_all,
                          call.dimension == 3 ? "cells" : "faces"),
              built, MPI_Wtime() - start, call);
}

void voronoi(Communicator& ranks, const Call& call) {
    const double start = MPI_Wtime();
    const Input input = read(ranks, call);
    const auto& kind = input.kind;
    ranks.together([&] {
        const RankTessellation built = mpi::triangulate(input.sites, ranks.get(), kind);
        const RankCells cells(ranks, built, kind, asks_for(call, ".csv"), asks_for(call, ".pvtu"));
        for (const std::string& output : call.outputs)
            ranks.together([&] {
                if (output.ends_with(".csv"))
                    cells.write_table(ranks, output);
                else
                    complete(ranks, output, [&] { write_pieces(ranks, output, cells.grid()); });
            });
        const std::int64_t hidden =
            ranks.sum(static_cast<std::int64_t>(built.part->hidden().size()));
        summarize(ranks, fmt::format("{} cells", built.whole - hidden), built, MPI_Wtime() - start,
                  call);
    });
}

/// The judgement is: not valid.
class CheckFailure : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

void validate(Communicator& ranks, const Call& typed) {
    Call call = typed;
    const double start = MPI_Wtime();
    ReadStretch tessellation =
        read_stretch(ranks, call.tessellation, static_cast<std::size_t>(call.dimension));
    if (const auto& says = tessellation.says) {
        if (!call.metric.empty() && name_of(metric_of(call)) != name_of(says->kind.metric))
            throw CLI::ValidationError(
                "--metric", fmt::format("{} says that it is of the {} metric", call.tessellation,
                                        name_of(says->kind.metric)));
        const bool has_weights = says->kind.weight_is == WeightIs::weight;
        if (has_weights ? !call.radii.empty() : !call.weights.empty())
            throw CLI::ValidationError(
                has_weights ? "--radii" : "--weights",
                fmt::format("{} was made of {}", call.tessellation,
                            has_weights ? "weights (--weights)" : "radii (--radii)"));
        call.metric = name_of(says->kind.metric);
        call.dimension = static_cast<int>(says->kind.dimension);
        call.last_is_weight = has_weights;
    }
    const Input input = read(ranks, call);
    const auto& kind = input.kind;
    const std::int64_t whole = ranks.sum(static_cast<std::int64_t>(input.sites.size()));
    Validation result;
    if (tessellation.says && tessellation.says->sites != whole)
        result.message = fmt::format("the tessellation speaks of {} sites, the input has {}",
                                     tessellation.says->sites, whole);
    else
        result = mpi::validate(input.sites, std::move(tessellation.stretch),
                               tessellation.says.has_value(), ranks.get(), kind);
    if (ranks.rank() == 0) {
        fmt::print("{}\n", !result.valid       ? "not valid: " + result.message
                           : !result.canonical ? "valid, not canonical: " + result.message
                                               : "valid, canonical");
        std::fflush(stdout);
        if (!call.is_quiet)
            fmt::print(stderr,
                       "{} sites, {} metric; {} questions, {} of them in exact numbers; "
                       "{} rank{}, {:.3g} s\n",
                       whole, name_of(kind.metric), result.filtered + result.multiprecision,
                       result.multiprecision, ranks.size(), ranks.size() == 1 ? "" : "s",
                       MPI_Wtime() - start);
    }
    if (!result.valid)
        throw CheckFailure(
            fmt::format("{} is not a valid tessellation of {}", call.tessellation, call.sites));
}

/// How a rank has ended.
struct End {
    int code = 0;
    std::string message;  ///< what there is to say; of ranks that have the same, one says it
};

/// Help and version, and calls that cannot be, are the same on all ranks.
End end_of_parsing(const CLI::App& tool, const CLI::ParseError& error, bool speaks) {
    if (error.get_exit_code() != 0) return {2, error.what()};
    if (speaks) tool.exit(error);
    return {};
}

End run(Communicator& ranks, int count, char** words) {
    CLI::App tool(
        "Tessellations of the plane and of space from sites that many ranks hold together: the "
        "result of\n"
        "signum triangulate, and the same bytes for every number of ranks.\n"
        "    mpirun -n 8 signum-mpi triangulate sites.h5:/points --radii /radii -o faces.h5");
    tool.require_subcommand(1);
    tool.set_version_flag("--version", SIGNUM_VERSION);
    Call call;
    struct Command {
        CLI::App* app;
        std::string endings;  ///< of what is written
        void (*run)(Communicator&, const Call&);
    };
    const std::array<Command, 3> commands = {
        {{tool.add_subcommand("triangulate",
                              "Faces of all sites, in space cells, from text (x y [r], x y z [r]), "
                              ".npy, .f64 or\nFILE.h5:/path"),
          endings(), triangulate},
         {tool.add_subcommand("voronoi",
                              "Cells of all sites in a box around them: areas or volumes, "
                              "neighbours, polygons or polyhedra"),
          ".csv, .pvtu", voronoi},
         {tool.add_subcommand("validate",
                              "Judges a tessellation from scratch, whoever made it: the .h5 of "
                              "triangulate,\nor .npy, .i32, faces alone"),
          "", validate}}};
    for (const Command& command : commands) {
        if (command.endings.empty())
            command.app
                ->add_option("TESSELLATION", call.tessellation, "FILE.h5, or FILE.npy, FILE.i32")
                ->required();
        command.app->add_option("SITES", call.sites, "FILE, or FILE.h5:/path/to/coordinates")
            ->required();
        command.app->add_option(
            "-m,--metric", call.metric,
            "power, euclidean, manhattan or supremum; default: euclidean, in space power");
        command.app
            ->add_option("--dimension", call.dimension, "2, or 3 of sites in space: x y z [r]")
            ->capture_default_str()
            ->check(CLI::IsMember({2, 3}));
        command.app->add_option("--radii", call.radii, "Where in FILE.h5 the radii are");
        command.app->add_option("--weights", call.weights,
                                "The same of weights, in the power metric");
        command.app->add_flag("--third-is-weight,--last-is-weight", call.last_is_weight,
                              "The last column is a weight, not a radius");
        command.app->add_flag("--quiet", call.is_quiet, "No summary on standard error");
        if (command.endings.empty()) continue;
        command.app
            ->add_option("-o,--output", call.outputs,
                         fmt::format("FILE that ends in one of {}; more than once if you like",
                                     command.endings))
            ->required();
    }
    try {
        const Command* command = nullptr;
        ranks.together([&] {
            tool.parse(count, words);
            static_cast<void>(metric_of(call));
            command = std::ranges::find_if(commands,
                                           [](const Command& each) { return each.app->parsed(); });
            if (!call.radii.empty() && !call.weights.empty())
                throw CLI::ValidationError("--radii", "give it or --weights, not both");
            for (const std::string& name : call.outputs) {
                const std::size_t dot = name.find_last_of("./");
                if (dot == std::string::npos || name[dot] != '.' ||
                    fmt::format("{},", command->endings).find(name.substr(dot) + ",") ==
                        std::string::npos)
                    throw CLI::ValidationError(
                        "-o", fmt::format("'{}' ends as nothing that is written: {}", name,
                                          command->endings));
            }
        });
        ranks.together([&] {
            // Before the work: what cannot be written after it.
            for (const std::string& name : call.outputs) {
                if (ranks.rank() != 0) break;
                std::error_code none;
                if (std::filesystem::equivalent(name, file_of(call.sites), none))
                    throw NameError(
                        fmt::format("-o {} would overwrite the input; give another name", name));
                const OutputFile can_be_written(name);
            }
        });
        ranks.together([&] { command->run(ranks, call); });
        return {};
    } catch (const CLI::ParseError& error) {
        return end_of_parsing(tool, error, ranks.rank() == 0);
    } catch (const OtherFailed&) {
        return {2, ""};  // who has failed says why
    } catch (const CheckFailure& failure) {
        return {1, failure.what()};
    } catch (const InputError& error) {
        return {2, error.what()};
    } catch (const NameError& error) {
        return {2, error.what()};
    } catch (const distributed::NoStructure& error) {
        return {2, fmt::format("{}: {}; signum triangulate takes them", call.sites, error.what())};
    } catch (const std::invalid_argument& error) {
        return {2, error.what()};
    } catch (const std::bad_alloc&) {
        return {3, "not enough memory; take more ranks, on more machines"};
    } catch (const std::exception& error) {
        return {3, error.what()};
    }
}

/// All ranks end alike, and the first that knows why says so.
int end(Communicator& ranks, const End& own) {
    const auto say = [&] {
        std::fprintf(stderr, "signum-mpi: rank %zu: %s\n", ranks.rank(), own.message.c_str());
    };
    if (own.code != 0 && !ranks.has_failed()) {
        // The others wait for what this rank will not send.
        say();
        MPI_Abort(MPI_COMM_WORLD, own.code);
    }
    const int most = static_cast<int>(ranks.size());
    const std::array<int, 2> mine = {-own.code,
                                     own.message.empty() ? most : static_cast<int>(ranks.rank())};
    std::array<int, 2> all{};
    MPI_Allreduce(mine.data(), all.data(), 2, MPI_INT, MPI_MIN, ranks.get());
    if (static_cast<std::size_t>(all[1]) == ranks.rank()) say();
    return -all[0];
}

}  // namespace
}  // namespace signum::mpi

int main(int count, char** words) {
#ifdef __GLIBC__
    // Memory that is given back is taken again, array after array: pages that the system has to
    // clear anew took half of the time of writing a million sites' cells.
    mallopt(M_MMAP_THRESHOLD, 1 << 30);
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
#endif
    MPI_Init(&count, &words);
    int code = 3;
    {
        signum::mpi::Communicator ranks(MPI_COMM_WORLD);
        code = signum::mpi::end(ranks, signum::mpi::run(ranks, count, words));
    }
    MPI_Finalize();
    return code;
}
