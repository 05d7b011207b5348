/// signum study: all experiments from one command, and their report.

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "../io/errors.hpp"
#include "../io/number.hpp"
#include "../io/output_file.hpp"
#include "../study/measure.hpp"
#include "../study/page.hpp"
#include "../study/plan.hpp"

#include "commands.hpp"
#include "progress.hpp"
#include "sites_call.hpp"

namespace signum::cli {
namespace {

namespace fs = std::filesystem;

/// The call as it was typed.
struct StudyCall {
    std::string directory = "signum-study";
    bool motion = false;
    int dimension = 2;  ///< of the sites
    bool quick = false;
    std::vector<std::string> metrics;
    std::string sites;
    double seconds = 0.0;  ///< 0: as long as it takes
    bool fresh = false;
    bool no_report = false;
    bool quiet = false;
};

study::Scope scope_of(const StudyCall& call) {
    study::Scope scope;
    scope.quick = call.quick;
    if (call.dimension == 3) {
        for (const std::string& metric : call.metrics)
            if (metric != name_of(Metric::power))
                throw CallError(fmt::format(
                    "--metric {}: in space the study is of the power metric alone; leave --metric "
                    "out, or --dimension 3",
                    metric));
        scope.metrics = {Metric::power};
    }
    if (call.dimension == 2 && !call.metrics.empty()) {
        scope.metrics.clear();
        for (const Metric metric : all_metrics)
            if (std::count(call.metrics.begin(), call.metrics.end(), name_of(metric)) > 0)
                scope.metrics.push_back(metric);
    }
    if (call.sites.empty()) return scope;
    const std::size_t colon = call.sites.find(':');
    const auto number = [&](const std::string& text) {
        const Number value = parse_number(text);
        if (value.fault != NumberFault::none || value.value < 1 || value.value > 1e9)
            throw CallError(
                fmt::format("--sites {}: give two numbers of sites, as in 100:10000", call.sites));
        return static_cast<std::int64_t>(value.value);
    };
    scope.least_sites = number(call.sites.substr(0, colon));
    scope.most_sites =
        colon == std::string::npos ? scope.least_sites : number(call.sites.substr(colon + 1));
    if (scope.least_sites > scope.most_sites)
        throw CallError(fmt::format("--sites {}: give the smaller number first", call.sites));
    return scope;
}

/// The command that makes the same study.
std::string command_of(const StudyCall& call, const study::Scope& scope) {
    std::string command = "signum study";
    if (call.motion) command += " --motion";
    if (call.dimension == 3) command += " --dimension 3";
    if (call.quick) command += " --quick";
    if (call.dimension == 2 && scope.metrics.size() < all_metrics.size())
        for (const Metric metric : scope.metrics)
            command += fmt::format(" --metric {}", name_of(metric));
    if (!call.sites.empty()) command += " --sites " + call.sites;
    return command;
}

/// What the results of a directory belong to; others are not mixed with them.
std::string identity(const study::Account& account) {
    std::string text = fmt::format(
        "{{\"format\": \"signum.study\", \"version\": 3, \"signum\": \"{}\",\n\"command\": "
        "\"{}\",\n"
        "\"machine\": {{",
        account.version, account.command);
    for (std::size_t i = 0; i < account.machine.size(); ++i)
        text += fmt::format("{}\"{}\": \"{}\"", i > 0 ? ", " : "", account.machine[i].first,
                            account.machine[i].second);
    return text + "}";
}

std::string contents_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return {};
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void write_file(const fs::path& path, std::string_view text) {
    OutputFile file(path.string());
    file.stream() << text;
    file.publish();
}

/// The directory of a study: what was measured so far, and what comes to it, line by line.
class Measurements {
 public:
    Measurements(const fs::path& directory, study::Of of, const std::string& identity, bool fresh)
        : of_(of) {
        std::error_code error;
        if (fs::exists(directory, error) && !fs::is_directory(directory, error))
            throw CallError(
                fmt::format("-o {}: that is a file; give a directory, which is made "
                            "where there is none",
                            directory.string()));
        fs::create_directories(directory / "figures", error);
        if (error)
            throw MachineError(fmt::format("cannot make the directory {}: {}", directory.string(),
                                           error.message()));
        const fs::path table = directory / "measurements.csv";
        const fs::path mark = directory / "study.json";
        if (fresh) {
            for (const char* name :
                 {"measurements.csv", "study.json", "results.csv", "results.json", "report.html"})
                fs::remove(directory / name, error);
        }
        const std::string old = contents_of(mark);
        if (!old.empty() && old != identity + "}\n")
            throw CallError(fmt::format(
                "{} holds the results of another study (version, options or machine differ: see "
                "{}); --fresh starts anew there, -o names another directory",
                directory.string(), mark.string()));
        if (fs::exists(table, error)) {
            try {
                table_ = study::read_csv(contents_of(table), of_);
            } catch (const std::invalid_argument& wrong) {
                throw CallError(
                    fmt::format("{}: {}; --fresh starts anew there", table.string(), wrong.what()));
            }
            fs::resize_file(table, table_.bytes, error);
            if (error)
                throw MachineError(
                    fmt::format("cannot write {}: {}", table.string(), error.message()));
        }
        if (old.empty()) write_file(mark, identity + "}\n");
        for (const study::Row& row : table_.rows) note(row);
        descriptor_ = ::open(table.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
        if (descriptor_ < 0)
            throw MachineError(
                fmt::format("cannot write {}: {}", table.string(), std::strerror(errno)));
        stream_.emplace(descriptor_, table.string());
        if (table_.bytes == 0) *stream_ << study::csv_header(of_) << std::flush;
    }
    Measurements(const Measurements&) = delete;
    Measurements& operator=(const Measurements&) = delete;
    ~Measurements() { ::close(descriptor_); }

    [[nodiscard]] const std::vector<study::Row>& rows() const { return table_.rows; }

    /// The pass over the cell that is to come next.
    [[nodiscard]] study::Pass next(const study::Setting& setting) const {
        const auto found = done_.find(setting);
        if (found == done_.end()) return {};
        return {found->second.passes + 1, found->second.breaks};
    }

    void add(const std::vector<study::Row>& rows) {
        for (const study::Row& row : rows) {
            *stream_ << study::csv_line(row, of_) << std::flush;
            table_.rows.push_back(row);
            note(row);
        }
    }

 private:
    struct Done {
        std::size_t passes = 0;
        bool breaks = false;
    };

    void note(const study::Row& row) {
        if (row.quantity == study::end_of_cell)
            ++done_[row.setting].passes;
        else if (row.quantity == study::broken_percent && row.value.median > 0.0)
            done_[row.setting].breaks = true;
    }

    study::Of of_;
    std::map<study::Setting, Done> done_;
    study::Table table_;
    int descriptor_ = -1;
    std::optional<DescriptorStream> stream_;
};

void write_report(const fs::path& directory, study::Page page, const study::Account& account) {
    for (study::Figure& figure : page.figures) {
        if (figure.plot.panels.empty()) continue;
        const std::string& name = figure.plot.name;
        const fs::path script = directory / "figures" / (name + ".gnuplot");
        write_file(script, study::gnuplot_script(figure.plot));
        const std::string svg = study::run_gnuplot(script.string());
        write_file(directory / "figures" / (name + ".svg"), svg);
        figure.svg = study::inline_svg(svg, name, figure.description);
    }
    write_file(directory / "report.html", study::html_report(page, account));
}

/// Measures what is not yet measured of a plan, and writes what all of it says.
void carry_out(const StudyCall& call, study::Account account,
               const std::vector<study::Cell>& cells) {
    const study::Of of = call.motion ? study::Of::balls : study::Of::sites;
    if (cells.empty())
        throw CallError(
            fmt::format("--sites {}: no experiment has so many; give a wider range", call.sites));
    const fs::path directory = call.directory;
    const std::string mark = identity(account);
    Measurements measurements(directory, of, mark, call.fresh);
    const bool draws = !call.no_report && study::has_gnuplot();
    constexpr std::string_view missing =
        "gnuplot is missing, so that there will be no report: install it (Debian: apt-get install "
        "gnuplot-nox) and type the same command again, which measures nothing twice\n";
    if (!draws && !call.no_report) say("signum: {}", missing);

    // Pass after pass over all cells, so that what is cut off has something of every figure.
    std::size_t most_passes = 0;
    for (const study::Cell& cell : cells) most_passes = std::max(most_passes, cell.passes);
    double all = 0.0;
    double done = 0.0;
    std::vector<std::pair<const study::Cell*, std::size_t>> open;
    for (std::size_t pass = 1; pass <= most_passes; ++pass)
        for (const study::Cell& cell : cells) {
            if (pass > cell.passes) continue;
            ++account.planned;
            const double expected = study::expected_seconds(cell, pass);
            all += expected;
            if (pass < measurements.next(cell.setting).number)
                done += expected;
            else
                open.emplace_back(&cell, pass);
        }
    account.measured = account.planned - open.size();
    if (account.measured > 0 && !call.quiet)
        say("goes on: {} of {} measurements are there\n", account.measured, account.planned);
    {
        Progress progress(call.quiet);
        const auto start = std::chrono::steady_clock::now();
        for (const auto& [cell, pass] : open) {
            if (call.seconds > 0.0 && study::seconds_since(start) >= call.seconds) break;
            progress.show(done / all);
            measurements.add(study::measure(*cell, measurements.next(cell->setting)));
            done += study::expected_seconds(*cell, pass);
            ++account.measured;
        }
    }
    const std::vector<study::Row> results = study::combined(measurements.rows());
    std::string table = study::csv_header(of);
    for (const study::Row& row : results) table += study::csv_line(row, of);
    write_file(directory / "results.csv", table);
    for (const study::Row& row : results)
        if (row.quantity == study::end_of_cell) account.seconds += row.value.median;
    write_file(directory / "results.json",
               fmt::format("{},\n\"rows\": {}}}\n", mark, study::json_array(results, of)));
    if (draws) {
        const bool is_plane = !call.motion && call.dimension == 2;
        write_report(directory,
                     study::page_of(call.motion ? "motion"
                                    : is_plane  ? "plane"
                                                : "space",
                                    results, is_plane ? study::wrong_picture() : study::Values()),
                     account);
    }
    if (call.quiet) return;
    say("study    {} of {} measurements, {:.0f} s of measuring\n", account.measured,
        account.planned, account.seconds);
    if (account.measured < account.planned) say("to do    the rest: the same command goes on\n");
    say("results  {0}/results.csv, {0}/results.json\n", call.directory);
    if (draws) say("report   {}/report.html\n", call.directory);
}

void run(const StudyCall& call) {
    if (call.directory == "-")
        throw CallError("-o -: a study is a directory of files; give its name");
    study::Scope scope = scope_of(call);
    study::Account account;
    account.version = SIGNUM_VERSION;
    account.command = command_of(call, scope);
    account.machine = study::describe_machine();
    carry_out(call, account,
              call.motion           ? study::plan_motion(scope)
              : call.dimension == 3 ? study::plan_in_space(scope)
                                    : study::plan(scope));
}

}  // namespace

void add_study(CLI::App& tool) {
    auto call = std::make_shared<StudyCall>();
    CLI::App* command = tool.add_subcommand(
        "study", "Measures what accuracy costs, and what goes wrong without it: a report");
    CLI::Option* motion = command->add_flag("--motion", call->motion,
                                            "Of balls that move: structures, accuracy, time steps");
    add_checked(*command, "--dimension", call->dimension, "2|3", one_of({"2", "3"}),
                "2: of sites in the plane; 3: in space, in the power\nmetric")
        ->excludes(motion)
        ->capture_default_str();
    command
        ->add_option("-o,--output", call->directory,
                     "Where results.csv, results.json and\nreport.html go")
        ->type_name("DIR")
        ->capture_default_str();
    command->add_flag("--quick", call->quick, "Every figure with fewer points: minutes");
    add_checked(*command, "--metric", call->metrics, "NAME ...", name_of_metric(),
                "These metrics alone; all without it")
        ->excludes(motion);
    command
        ->add_option("--sites", call->sites,
                     "Leaves out experiments on fewer or more sites, or\nballs")
        ->type_name("A:B");
    add_checked(*command, "--seconds", call->seconds, "N", number_from(0.0, 1e9),
                "Begins nothing new after so long; the same\ncommand goes on later");
    command->add_flag("--fresh", call->fresh, "Throws away the results that DIR holds");
    command->add_flag("--no-report", call->no_report, "Numbers alone; the report needs gnuplot");
    command->add_flag("--quiet", call->quiet, "No summary and no progress on standard error");
    command->footer(
        "A study that was cut off goes on where it stopped. Leave the machine alone while it "
        "runs.\n\n"
        "Examples:\n"
        "  signum study --quick -o my-study && xdg-open my-study/report.html\n"
        "  signum study --dimension 3 --quick -o in-space");
    command->callback([call] { run(*call); });
}

}  // namespace signum::cli
