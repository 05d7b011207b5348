#include "within_memory.hpp"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "../../core/parallel.hpp"
#include "../../triangulation/distributed/on_disk.hpp"
#include "../io/array_writer.hpp"
#include "../io/input_file.hpp"
#include "../io/number.hpp"
#include "../io/text_slice.hpp"
#include "../study/timing.hpp"

#include "commands.hpp"
#include "parts_folder.hpp"
#include "progress.hpp"

namespace signum::cli {
namespace {

using distributed::Placed;

/// Bytes, as 512M, 4G or 1T say; nothing where it is no such number, or less than a megabyte.
std::optional<std::uint64_t> bytes_of(std::string_view text) {
    constexpr std::string_view units = "KMGT";
    if (text.empty()) return std::nullopt;
    const std::size_t unit =
        units.find(static_cast<char>(std::toupper(static_cast<unsigned char>(text.back()))));
    if (unit == std::string_view::npos) return std::nullopt;
    const auto number = parse_whole_number(text.substr(0, text.size() - 1));
    const std::size_t shift = 10 * (unit + 1);
    if (!number || *number > (std::uint64_t{1} << 50 >> shift)) return std::nullopt;
    const std::uint64_t bytes = *number << shift;
    return bytes < std::uint64_t{1} << 20 ? std::nullopt : std::optional(bytes);
}

/// Sites of a file, some megabytes at a time.
class Slices {
 public:
    Slices(const SitesCall& call, int dimension, SitesInput input, std::uint64_t bytes)
        : call_(call),
          dimension_(dimension),
          input_(input),
          slices_(static_cast<std::size_t>(bytes / (std::uint64_t{1} << 24) + 1)) {}

    [[nodiscard]] distributed::SlicedSites view() {
        return {slices_, [this](std::size_t slice) { return read(slice); }};
    }

 private:
    std::vector<Placed> read(std::size_t slice) {
        if (slice == 0) id_ = lines_ = 0;
        std::vector<Placed> placed;
        const auto put = [&](const auto& sites) {
            placed.reserve(sites.size());
            for (const auto& site : sites) placed.push_back({site, id_++});
        };
        if (input_ == SitesInput::text) {
            const TextSlice text = read_text_slice(call_.input, dimension_, slice, slices_);
            if (text.wrong) throw wrong_line(call_.input, dimension_, lines_, text);
            lines_ += text.lines;
            put(text.sites);
        } else {
            const SitesFile file = read_sites(
                call_.input, {.dimension = dimension_, .input = input_, .share = {slice, slices_}});
            put(file.sites);
            put(file.in_space);
        }
        return placed;
    }

    const SitesCall& call_;
    int dimension_;
    SitesInput input_;
    std::size_t slices_;
    std::int64_t id_ = 0;
    std::int64_t lines_ = 0;
};

/// Where the pieces of an output lie: on its own file system, so that it can be renamed.
std::string parts_of(const std::string& output) {
    std::error_code ignored;
    const std::string path = std::filesystem::is_symlink(output, ignored)
                                 ? std::filesystem::weakly_canonical(output, ignored).string()
                                 : output;
    return path + ".parts";
}

/// Pieces in a folder whose manifest says which sites and parts they are of.
distributed::Pieces pieces_in(PartsFolder& folder, bool quiet) {
    return {.folder = folder.path(),
            .belong =
                [&folder](const distributed::WholeCounts& counts) {
                    folder.require({{"sites", counts.sites},
                                    {"parts", counts.parts},
                                    {"checksum", fmt::format("{:016x}", counts.checksum)}});
                    folder.write();
                },
            .found =
                [&folder, quiet](const distributed::PiecesFound& found) {
                    // The bar of progress may be there.
                    if (::isatty(STDERR_FILENO) != 0) say("\r\033[K");
                    for (const std::string& name : found.damaged)
                        say("signum: {} is damaged, and is made anew\n", name);
                    if (!quiet)
                        say("taken    {} of {} pieces, from {}\n", found.whole, found.all,
                            folder.path());
                }};
}

}  // namespace

void add_memory(CLI::App& command, MemoryCall& call) {
    command
        .add_option("--memory", call.memory,
                    "How much memory to take, as in 512M or 4G: what\n"
                    "does not fit lies on the disk beside -o meanwhile.\n"
                    "From lines x y [r], of space x y z [r], .npy or\n"
                    ".f64, to one .npy or .i32 of faces or cells")
        ->type_name("SIZE")
        ->check(CLI::Validator(
            [](const std::string& text) {
                return bytes_of(text) ? std::string()
                                      : "'" + text +
                                            "' is no size; give one of 1M or more, as in "
                                            "512M or 4G";
            },
            ""));
    command.add_flag("--resume", call.resume,
                     "With --memory: keeps what is done in a folder\n"
                     "beside -o, FILE.parts. Where a call is cut off, the\n"
                     "same call goes on from there; one that ends well\n"
                     "removes the folder");
}

void triangulate_within(const MemoryCall& memory, const SitesCall& call,
                        std::span<const Target> targets) {
    const std::uint64_t bytes = bytes_of(memory.memory).value();
    const Target& target = targets.front();
    if (targets.size() != 1 || (target.format != "npy" && target.format != "i32"))
        throw CallError(
            "--memory writes faces, or cells, as they come, into one file: -o FILE.npy or "
            "FILE.i32");
    const SitesInput input = input_of(call.input, call.read_as);
    if (input != SitesInput::text && !is_array(input))
        throw CallError(
            fmt::format("--memory reads slices of lines x y [r], of space x y z [r], .npy and "
                        ".f64, and {} is none of these",
                        call.input));
    if (call.text.is_given())
        throw CallError(
            "--memory reads the first columns, x, y (z) and r, of lines of numbers; leave "
            "--columns, --decimal, --skip-lines and --skip-missing out");
    const int dimension = call.dimension.value_or(2);
    const Metric metric = metric_of(call.metric);
    if (dimension == 3 && !traits_of(metric).edges_are_straight)
        refuse_option(call, fmt::format("--metric {}", call.metric), "sites in space",
                      "have tessellations of the power metric alone");
    const bool are_weights = call.weight_is == "weight";
    if (are_weights && !traits_of(metric).has_weights) throw CallError(no_weights(metric));
    const std::optional<std::uint64_t> bytes_of_file =
        InputFile(call.input, "a file of sites", Contents::bytes).size();
    if (!bytes_of_file)
        throw InputError(call.input, "this is no regular file, which --memory reads twice");
    const std::uint64_t size = *bytes_of_file;

    const distributed::Kind kind = {metric, are_weights ? WeightIs::weight : WeightIs::radius,
                                    static_cast<std::size_t>(dimension)};
    // Of a float a coordinate, at the least, or of a digit and what parts it from the next.
    const auto most_sites =
        static_cast<double>(size) / ((input == SitesInput::text ? 2.0 : 4.0) * dimension);
    const Workers workers(call.threads, static_cast<std::size_t>(most_sites));
    // A quarter is for what all parts know, and for reading and sorting.
    const double fit = 0.75 * static_cast<double>(bytes) /
                       static_cast<double>(distributed::bytes_a_site(kind)) / workers.count();
    const auto parts = [&](std::int64_t sites) {
        const double count = std::max(std::ceil(static_cast<double>(sites) / fit), 1.0);
        if (count <= static_cast<double>(distributed::most_parts))
            return static_cast<std::size_t>(count);
        throw CallError(
            fmt::format("--memory {} is too little for the {} sites of {}: its parts "
                        "would be more than {}",
                        memory.memory, sites, call.input, distributed::most_parts));
    };

    const auto start = std::chrono::steady_clock::now();
    std::optional<PartsFolder> kept;
    if (memory.resume) {
        if (target.path == standard_output)
            throw CallError("--resume keeps pieces beside a file; give one by -o");
        kept.emplace(parts_of(target.path));
        kept->require({{"format", "signum.parts"},
                       {"version", 1},
                       {"input_bytes", size},
                       {"metric", name_of(metric)},
                       {"weight_is", are_weights ? "weight" : "radius"},
                       {"dimension", dimension}});
        kept->note({{"memory", memory.memory}, {"threads", workers.count()}});
    }
    const Outputs outputs(targets, kept ? kept->path() : std::string());
    distributed::WholeCounts counts;
    Slices slices(call, dimension, input, size);
    const auto write = [&](std::ostream& out) {
        with_progress(call.quiet, [&](const std::function<void(double)>& show) {
            distributed::triangulate_on_disk(
                slices.view(), kind,
                {.parts = parts,
                 .threads = call.threads,
                 .folder = kept ? kept->path()
                                : std::filesystem::absolute(target.path).parent_path().string(),
                 .pieces = kept ? pieces_in(*kept, call.quiet) : distributed::Pieces(),
                 .progress = show},
                [&](const distributed::WholeCounts& known) {
                    counts = known;
                    if (target.format == "npy")
                        put_npy_head(out, SiteNumbers(counts.sites).type(),
                                     static_cast<std::size_t>(counts.faces), kind.dimension + 1);
                },
                [&](std::span<const std::int64_t> numbers) {
                    put_bytes(out, std::span<const char>(SiteNumbers(counts.sites).bytes(numbers)));
                });
            return 0;
        });
    };
    constexpr std::string_view goes_on = "; the same call goes on from what is done";
    try {
        outputs.write({{"npy", write}, {"i32", write}});
        if (kept) kept->remove();
    } catch (const distributed::NoStructure& error) {
        if (kept) kept->remove();
        throw CallError(fmt::format("{}: {}; leave --memory out", call.input, error.what()));
    } catch (const distributed::SitesChanged&) {
        throw InputError(call.input, "it changed while it was read");
    } catch (const std::system_error& error) {
        throw MachineError(
            fmt::format("beside {}: {}{}", target.path, error.what(), kept ? goes_on : ""));
    } catch (const MachineError& error) {
        if (!kept) throw;
        throw MachineError(fmt::format("{}{}", error.what(), goes_on));
    }
    if (call.quiet) return;
    say("sites    {}{}\n", counts.sites, are_weights ? ", the last number a weight" : "");
    say("visible  {}\n", counts.sites - counts.hidden);
    say("hidden   {}\n", counts.hidden);
    say("{}    {}, {} of them infinite\n", dimension == 3 ? "cells" : "faces", counts.faces,
        counts.infinite_faces);
    say("parts    {}\n", counts.parts);
    say("seconds  {:.3g}\n", study::seconds_since(start));
    say("{}", written(targets));
}

}  // namespace signum::cli
