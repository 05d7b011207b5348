#include "outputs.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "../io/input_file.hpp"

#include "commands.hpp"

namespace signum::cli {

bool is_same_file(const std::string& a, const std::string& b) {
    struct stat first = {};
    struct stat second = {};
    return ::stat(a.c_str(), &first) == 0 && ::stat(b.c_str(), &second) == 0 &&
           S_ISREG(first.st_mode) && first.st_dev == second.st_dev && first.st_ino == second.st_ino;
}

bool is_same_path(const std::string& a, const std::string& b) {
    std::error_code ignored;
    const auto full = [&](const std::string& path) {
        return std::filesystem::weakly_canonical(std::filesystem::absolute(path, ignored), ignored);
    };
    return a == b || full(a) == full(b);
}

namespace {

/// What png and pdf are; nothing for other formats.
std::optional<Converted> converted(std::string_view format) {
    if (format == "png") return Converted::png;
    if (format == "pdf") return Converted::pdf;
    return std::nullopt;
}

/// ".a, .b or .c"
std::string listed(std::span<const Format> formats) {
    std::string text;
    for (std::size_t i = 0; i < formats.size(); ++i) {
        if (i > 0) text += i + 1 < formats.size() ? ", " : " or ";
        text += fmt::format(".{}", formats[i].name);
    }
    return text;
}

bool has_format(std::span<const Format> formats, std::string_view name) {
    return std::ranges::find(formats, name, &Format::name) != formats.end();
}

/// Precondition: where --format is given and standard output is no target, --format is for the
/// file.
std::string format_of_file(const OutputsCall& call, const std::string& path,
                           std::span<const Format> formats) {
    const std::string ending = ending_of(path);
    const bool is_for_files =
        !call.format.empty() && std::ranges::count(call.outputs, standard_output) == 0;
    if (!is_for_files) {
        if (has_format(formats, ending)) return ending;
        throw CallError(
            fmt::format("-o {}: the ending says what to write; give it {}, or say it with --format",
                        path, listed(formats)));
    }
    if (call.outputs.size() > 1 && ending != call.format && has_format(formats, ending)) {
        throw CallError(fmt::format(
            "--format {} and -o {}: with several files either their endings say what "
            "to write, or --format does; leave --format out, or name the file otherwise",
            call.format, path));
    }
    return call.format;
}

}  // namespace

void add_outputs(CLI::App& command, OutputsCall& call, std::span<const Format> formats,
                 std::string_view without) {
    std::size_t width = 0;
    for (const Format& format : formats) width = std::max(width, format.name.size());
    std::string description = "Where the result goes, by its ending:\n";
    std::vector<std::string> names;
    for (const Format& format : formats) {
        const std::string_view name = format.name;
        names.emplace_back(name);
        description += fmt::format(".{:<{}}  ", name, width);
        for (const char c : format.writes) {
            description += c;
            if (c == '\n') description += std::string(width + 3, ' ');
        }
        description += "\n";
    }
    command
        .add_option(
            "-o,--output", call.outputs,
            fmt::format("{}Several are allowed, - is standard output;\n{}", description, without))
        ->type_name("FILE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->allow_extra_args(false);
    command
        .add_option("--format", call.format,
                    "What goes to standard output, or to files whatever\ntheir ending: its name "
                    "without the point")
        ->transform(one_of(names))
        ->type_name("NAME");
}

std::vector<Target> targets_of(const OutputsCall& call, const std::string& input,
                               std::span<const Format> formats) {
    const std::string first = call.format.empty() ? std::string(formats[0].name) : call.format;
    if (call.outputs.empty()) return {{std::string(standard_output), first}};
    std::vector<Target> targets;
    for (const std::string& path : call.outputs) {
        for (const Target& target : targets) {
            if (!is_same_path(target.path, path)) continue;
            throw CallError(fmt::format("-o {} is given twice; give it once", path));
        }
        if (path == standard_output) {
            targets.push_back({path, first});
            continue;
        }
        targets.push_back({path, format_of_file(call, path, formats)});
        if (is_same_file(input, path)) {
            throw CallError(
                fmt::format("-o {} would overwrite the input; give another name", path));
        }
    }
    return targets;
}

void require_formats_of(Dimension dimension, std::span<const Target> targets,
                        std::span<const Format> formats, const std::string& input) {
    const auto named = [](Dimension sites) {
        return sites == Dimension::three ? "space" : "the plane";
    };
    for (const Target& target : targets) {
        const Format& format = *std::ranges::find(formats, target.format, &Format::name);
        if (format.dimension == Dimension::any || format.dimension == dimension) continue;
        throw CallError(fmt::format(
            "{} is written of sites in {}, and those of {} lie in {}; write {}", format.name,
            named(format.dimension), input, named(dimension), format.instead));
    }
}

bool is_picture_written(std::span<const Target> targets) {
    return std::ranges::any_of(targets, [](const Target& target) {
        return target.format == "svg" || converted(target.format);
    });
}

bool is_written(std::span<const Target> targets, std::string_view format) {
    return std::ranges::find(targets, format, &Target::format) != targets.end();
}

std::string written(std::span<const Target> targets) {
    std::string text;
    for (const Target& target : targets) {
        if (target.path == standard_output) continue;
        text += (text.empty() ? "written  " : ", ") + target.path;
    }
    return text.empty() ? text : text + "\n";
}

void print(std::string_view text) {
    DescriptorStream out(1, "standard output");
    out << text;
    out.flush();
}

Outputs::Outputs(std::span<const Target> targets, const std::string& folder) : targets_(targets) {
    for (const Target& target : targets) {
        if (converted(target.format) && !converter_) converter_.emplace();
        files_.push_back(target.path == standard_output
                             ? nullptr
                             : std::make_unique<OutputFile>(target.path, folder));
    }
}

void Outputs::write(std::initializer_list<Writer> writers) const {
    const auto write_one = [&](std::ostream& out, std::string_view format) {
        const auto writer = std::ranges::find(writers, format, &Writer::format);
        if (writer == writers.end())
            throw std::logic_error(fmt::format("a format that nothing writes: {}", format));
        writer->write(out);
    };
    const auto write = [&](std::ostream& out, std::string_view format) {
        const std::optional<Converted> made_of_svg = converted(format);
        if (!made_of_svg) return write_one(out, format);
        std::ostringstream svg;
        write_one(svg, "svg");
        out << converter_->convert(std::move(svg).str(), *made_of_svg);
    };
    for (std::size_t i = 0; i < targets_.size(); ++i) {
        if (files_[i]) {
            write(files_[i]->stream(), targets_[i].format);
            files_[i]->finish();
        } else {
            DescriptorStream out(1, "standard output");
            write(out, targets_[i].format);
            out.flush();
        }
    }
    for (const auto& file : files_)
        if (file) file->publish();
}

}  // namespace signum::cli
