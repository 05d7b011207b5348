#include "draw_faults.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include <fmt/format.h>
#include <fmt/ostream.h>

namespace signum {
namespace {

constexpr double fault_width = 900.0;

/// Of the picture: x to the right, y down.
struct FittedSites {
    double left;
    double top;
    double scale;
    double height;

    explicit FittedSites(const StridedSites& sites) {
        constexpr double most = std::numeric_limits<double>::infinity();
        double low_x = most, high_x = -most, low_y = most, high_y = -most;
        for (std::size_t i = 0; i < sites.size(); ++i) {
            const Site s = sites[i];
            low_x = std::min(low_x, s.x);
            high_x = std::max(high_x, s.x);
            low_y = std::min(low_y, s.y);
            high_y = std::max(high_y, s.y);
        }
        // Halves, for a difference may overflow.
        const double across = std::max(high_x / 2 - low_x / 2, high_y / 2 - low_y / 2);
        scale = std::min(across > 0.0 ? (fault_width - 40) / across / 2 : 1.0, 1e300);
        left = low_x;
        top = high_y;
        height = (high_y / 2 - low_y / 2) * 2 * scale + 90;
    }
    [[nodiscard]] double x(double of) const { return 20 + (of / 2 - left / 2) * scale * 2; }
    [[nodiscard]] double y(double of) const { return 20 + (top / 2 - of / 2) * scale * 2; }
};

struct Look {
    FiniteFault fault;
    std::string_view colour;
    std::string_view says;
};
constexpr std::string_view open_colour = "#e69f00";
constexpr std::array<Look, 3> looks = {{{FiniteFault::conflict, "#d55e00", "a site in its circle"},
                                        {FiniteFault::overlap, "#cc79a7", "overlaps"},
                                        {FiniteFault::flat, "#0072b2", "flat"}}};

}  // namespace

void draw_faults(std::ostream& out, std::span<const std::array<Index, 3>> faces,
                 const StridedSites& sites, const FiniteValidation& judged, int numbered_from) {
    const FittedSites frame(sites);
    const auto path_of = [&](std::size_t f) {
        std::string path;
        for (const Index i : faces[f]) {
            if (i < 0 || static_cast<std::size_t>(i) >= sites.size()) return std::string();
            const Site s = sites[static_cast<std::size_t>(i)];
            path += fmt::format("{}{:.2f} {:.2f}", path.empty() ? "M" : "L", frame.x(s.x),
                                frame.y(s.y));
        }
        return path + "Z";
    };
    fmt::print(out,
               "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
               "width=\"{0:.0f}\" height=\"{1:.0f}\">\n<style>text{{font:13px sans-serif}}"
               "path{{stroke-linejoin:round}}</style>\n"
               "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n"
               "<path fill=\"none\" stroke=\"#999\" stroke-width=\"0.7\" d=\"",
               fault_width, frame.height);
    for (std::size_t f = 0; f < std::min(faces.size(), most_faces_drawn); ++f) out << path_of(f);
    out << "\"/>\n";
    for (const Look& look : looks)
        for (const auto& [face, fault] : judged.faults)
            if (fault == look.fault)
                fmt::print(out,
                           "<path fill=\"{0}\" fill-opacity=\"0.35\" stroke=\"{0}\" "
                           "stroke-width=\"2\" d=\"{1}\"><title>face {2}</title></path>\n",
                           look.colour, path_of(static_cast<std::size_t>(face)),
                           face + numbered_from);
    for (const auto& [face, between] : judged.open) {
        const Site a = sites[static_cast<std::size_t>(between[0])];
        const Site b = sites[static_cast<std::size_t>(between[1])];
        fmt::print(out,
                   "<path stroke=\"{}\" stroke-width=\"3\" d=\"M{:.2f} {:.2f}L{:.2f} {:.2f}\">"
                   "<title>face {} has it alone</title></path>\n",
                   open_colour, frame.x(a.x), frame.y(a.y), frame.x(b.x), frame.y(b.y),
                   face + numbered_from);
    }
    for (const std::int64_t missing : judged.missing) {
        const Site s = sites[static_cast<std::size_t>(missing)];
        fmt::print(out,
                   "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"4\" fill=\"none\" stroke=\"#009e73\" "
                   "stroke-width=\"2\"><title>site {}</title></circle>\n",
                   frame.x(s.x), frame.y(s.y), missing + numbered_from);
    }
    double at = 20;
    const double line = frame.height - 30;
    for (const Look& look : looks) {
        fmt::print(out,
                   "<rect x=\"{0:.0f}\" y=\"{1:.0f}\" width=\"14\" height=\"14\" fill=\"{2}\"/>"
                   "<text x=\"{3:.0f}\" y=\"{4:.0f}\">{5}</text>\n",
                   at, line - 12, look.colour, at + 20, line, look.says);
        at += 150;
    }
    fmt::print(out,
               "<path stroke=\"{}\" stroke-width=\"3\" d=\"M{:.0f} {:.0f}h14\"/>"
               "<text x=\"{:.0f}\" y=\"{:.0f}\">nothing behind it</text>\n",
               open_colour, at, line - 5, at + 20, line);
    at += 150;
    fmt::print(out,
               "<circle cx=\"{0:.0f}\" cy=\"{1:.0f}\" r=\"4\" fill=\"none\" stroke=\"#009e73\" "
               "stroke-width=\"2\"/><text x=\"{2:.0f}\" y=\"{3:.0f}\">of no face</text>\n",
               at + 7, line - 5, at + 20, line);
    if (faces.size() > most_faces_drawn)
        fmt::print(out,
                   "<text x=\"20\" y=\"{:.0f}\">the first {} of {} faces are drawn, and all at "
                   "fault</text>\n",
                   line + 20, most_faces_drawn, faces.size());
    out << "</svg>\n";
}

}  // namespace signum
