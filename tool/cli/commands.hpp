#pragma once
/// The subcommands, and how they end.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "../../triangulation/tessellation.hpp"
#include "../io/errors.hpp"
#include "../io/read_sites.hpp"

namespace signum::cli {

/// What the tool returns to the shell.
enum ExitCode : int {
    done = 0,
    check_failed = 1,   ///< a check that was asked for
    wrong_input = 2,    ///< the call or its input
    machine_failed = 3  ///< disk full, no memory
};

/// The call is wrong. The message says what would be right; main() puts "signum: " before it.
class CallError : public ShownError {
 public:
    using ShownError::ShownError;
};

/// A check that was asked for failed; main() puts "signum: " before the message.
class CheckFailure : public ShownError {
 public:
    using ShownError::ShownError;
};

/// Each adds its subcommand to the tool. The subcommand runs at the end of parsing, writes its
/// result to standard output and throws CallError, InputError, NameError, MachineError or
/// CheckFailure.
void add_triangulate(CLI::App& tool);
void add_voronoi(CLI::App& tool);
void add_compare(CLI::App& tool);
void add_sign(CLI::App& tool);
void add_generate(CLI::App& tool);
void add_validate(CLI::App& tool);
void add_study(CLI::App& tool);
void add_simulate(CLI::App& tool);
void add_torture(CLI::App& tool);

/// What is wrong with a call that could not be parsed, in words of our own: what would be right,
/// and where help is. `first_word` is the word after the tool's name.
std::string explain_parse_error(const CLI::App& tool, const CLI::ParseError& error,
                                const std::string& first_word);

/// Accepts these words in any case and no others; as a transform() it turns them into the spelling
/// that is given here.
CLI::Validator one_of(std::vector<std::string> words);

/// Accepts whole numbers that fit into 64 bits, and no sign.
CLI::Validator whole_number();
/// Accepts those up to `most`.
CLI::Validator whole_number_to(std::uint64_t most);

/// Accepts finite numbers as io/number.hpp reads them, those from `least` to `most`.
CLI::Validator number_from(double least, double most);
/// Accepts finite numbers.
CLI::Validator finite_number();

/// Accepts names of files, which are not empty; whether one is there is not looked at.
CLI::Validator name_of_file();

/// Adds an option whose value the help calls `type`, and `check` accepts or turns into its
/// spelling.
template <class Value>
CLI::Option* add_checked(CLI::App& command, const std::string& name, Value& value,
                         const std::string& type, const CLI::Validator& check,
                         const std::string& description) {
    return command.add_option(name, value, description)->transform(check)->type_name(type);
}

/// Accepts the names and aliases of metrics, in any case; as a transform() it turns them into the
/// name.
CLI::Validator name_of_metric();

/// Adds the option --metric with its four names and its default, euclidean.
CLI::Option* add_metric(CLI::App& command, std::string& metric);
/// The metric of a name that add_metric() let through.
Metric metric_of(const std::string& name);

/// Adds the option --threads; 0 stands for every core.
CLI::Option* add_threads(CLI::App& command, int& threads);

/// What a call says about lines of text.
struct TextCall {
    std::string columns;        ///< empty: what a header says, else the first ones
    std::string decimal = ".";  ///< or a comma
    std::int64_t skipped_lines = 0;
    bool skips_missing = false;
    std::vector<std::string>
        radii;  ///< of elements, each EL=R; not of text, but of the same reading
    /// Whether any of it was typed.
    [[nodiscard]] bool is_given() const {
        return !columns.empty() || decimal != "." || skipped_lines > 0 || skips_missing ||
               !radii.empty();
    }
};
/// Adds --columns, which is given back, --decimal, --skip-lines, --skip-missing and --radius.
CLI::Option* add_text(CLI::App& command, TextCall& call);
/// Reads the file as the call says, and says so where a column was left out that may have been
/// meant. Throws InputError, CallError and MachineError.
SitesFile read_sites_of_call(const std::string& path, const TextCall& text,
                             std::optional<int> dimension = 2, SitesInput input = SitesInput::text,
                             bool attributes = false);

/// Adds the option --weight-is; empty when it is not given. `otherwise` says what holds then.
CLI::Option* add_weight_is(CLI::App& command, std::string& weight_is, std::string_view otherwise);
/// Throws CallError where --weight-is is given with a metric that has no weights.
void check_weight_is(const std::string& weight_is, Metric metric);

}  // namespace signum::cli
