#include "document.hpp"

#include <ostream>

#include "axes.hpp"

namespace signum {
namespace {

// Pixels around the frame.
constexpr double left = 86.0;
constexpr double top = 26.0;
constexpr double bottom = 34.0;

}  // namespace

void write_document(std::ostream& out, std::string_view title, const Frame& frame, const Pens& pens,
                    Legend& legend, const SvgText& drawing) {
    const Axes axes(frame);
    axes.describe(legend);
    SvgText around;
    axes.write(around);
    write_document(out, title, frame, pens, legend, drawing, around);
}

void write_document(std::ostream& out, std::string_view title, const Frame& frame, const Pens& pens,
                    const Legend& legend, const SvgText& drawing, const SvgText& around) {
    const double below = top + frame.height() + bottom;
    const double height = below + legend.height();
    SvgText head;
    head.add(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1}" width="{0}" )"
             R"(height="{1}" font-family="system-ui, sans-serif" font-size="{2}">)"
             "\n<title>{3}</title>\n",
             Px{document_width}, Px{height}, Px{font_size}, title);
    write_style(head, pens);
    head.add(R"(<clipPath id="frame"><rect width="{0}" height="{1}"/></clipPath>)"
             "\n<rect width=\"{2}\" height=\"{3}\" fill=\"#fff\"/>\n<g transform=\"translate({4} "
             "{5})\">\n",
             Px{frame.width()}, Px{frame.height()}, Px{document_width}, Px{height}, Px{left},
             Px{top});
    SvgText foot;
    foot.add("</g>\n");
    legend.write(foot, below);
    out << head.view() << "<g clip-path=\"url(#frame)\">\n"
        << drawing.view() << "</g>\n"
        << around.view() << foot.view() << "</svg>\n";
}

}  // namespace signum
