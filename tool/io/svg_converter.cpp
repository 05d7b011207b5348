#include "svg_converter.hpp"

#include <array>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "errors.hpp"
#include "output_file.hpp"
#include "program.hpp"

namespace signum {
namespace {

constexpr std::string_view rsvg = "rsvg-convert";
constexpr std::array converters = {rsvg, std::string_view("inkscape")};

/// Both write to standard output. Without --unlimited the first one refuses large pictures.
std::vector<std::string> arguments(std::string_view program, std::string_view format,
                                   const std::string& drawing) {
    if (program == rsvg) return {"--unlimited", fmt::format("--format={}", format), drawing};
    return {fmt::format("--export-type={}", format), "--export-filename=-", drawing};
}

}  // namespace

SvgConverter::SvgConverter() {
    for (const std::string_view program : converters) {
        if (!has_program(std::string(program), "--version")) continue;
        program_ = program;
        return;
    }
    throw MachineError(
        "png and pdf are made from svg by rsvg-convert or inkscape, and neither is there; install "
        "one of them (Debian: apt-get install librsvg2-bin), or write svg");
}

std::string SvgConverter::convert(std::string_view svg, Converted format) const {
    const ScratchFolder folder("picture");
    const std::string drawing = folder.file("picture.svg");
    OutputFile file(drawing);
    file.stream() << svg;
    file.publish();
    const std::string_view name = format == Converted::png ? "png" : "pdf";
    ProgramEnd end = run_program(program_, arguments(program_, name, drawing));
    if (end.status != 0 || end.output.empty())
        throw MachineError(fmt::format("{} failed at a {}; write svg", program_, name));
    return std::move(end.output);
}

}  // namespace signum
