#pragma once
/// Where results go, by -o and --format: checked, opened before the work, complete or not there.

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "../io/output_file.hpp"
#include "../io/svg_converter.hpp"

namespace signum::cli {

/// The path of standard output.
inline constexpr std::string_view standard_output = "-";

/// In how many dimensions sites lie.
enum class Dimension : std::uint8_t { any, two, three };

/// A format that a subcommand writes. Its name is that of --format and, after a point, the ending
/// of its files.
struct Format {
    std::string_view name;
    std::string_view writes;               ///< for the help; lines end with \n
    Dimension dimension = Dimension::any;  ///< of the sites of which it is written
    std::string_view instead = {};         ///< of other sites
};

/// The part of a call that says where its results go.
struct OutputsCall {
    std::vector<std::string> outputs;
    std::string format;
};

/// A place that a result goes to.
struct Target {
    std::string path;    ///< or standard_output
    std::string format;  ///< the name of one of the formats
};

/// Adds the options -o, which may be given several times, and --format. `without` says what happens
/// without -o.
void add_outputs(CLI::App& command, OutputsCall& call, std::span<const Format> formats,
                 std::string_view without);

/// Whether both are there, and are the same file.
[[nodiscard]] bool is_same_file(const std::string& a, const std::string& b);
/// Whether both mean the same place, be something there or not.
[[nodiscard]] bool is_same_path(const std::string& a, const std::string& b);

/// The targets of a call, at least one: without -o it is standard output, and without --format
/// either the first of the formats. Files have the format that their ending names; --format is that
/// of standard output and, where nothing goes there, of all files.
/// Throws CallError where a file has no format, is named twice, or is the input.
std::vector<Target> targets_of(const OutputsCall& call, const std::string& input,
                               std::span<const Format> formats);

/// Throws CallError where a format is not written of sites of this dimension, as those of the
/// input.
void require_formats_of(Dimension dimension, std::span<const Target> targets,
                        std::span<const Format> formats, const std::string& input);

/// Whether a picture is written: svg, or what is made of it.
bool is_picture_written(std::span<const Target> targets);

/// Whether anything is written in that format.
bool is_written(std::span<const Target> targets, std::string_view format);

/// "written  a.json, b.svg\n" for the summary; empty where everything goes to standard output.
std::string written(std::span<const Target> targets);

/// Writes a result to standard output.
void print(std::string_view text);

/// What writes a format.
struct Writer {
    std::string_view format;
    std::function<void(std::ostream& out)> write;
};

class Outputs {
 public:
    /// Opens all files, and finds the program that makes png and pdf: a directory that cannot be
    /// written should not cost minutes. The targets must outlive the object. Unfinished files lie
    /// in `folder`, or each beside its target.
    explicit Outputs(std::span<const Target> targets, const std::string& folder = {});

    /// Writes every target; files appear under their names when all are complete. What is made of a
    /// picture is written by the writer of svg.
    /// Throws std::logic_error where a target's format has no writer.
    void write(std::initializer_list<Writer> writers) const;

 private:
    std::span<const Target> targets_;
    std::optional<SvgConverter> converter_;
    std::vector<std::unique_ptr<OutputFile>> files_;  ///< one a target; null for standard output
};

}  // namespace signum::cli
