#include "document.hpp"

#include <ostream>

namespace signum {

void write_document(std::ostream& out, std::string_view title, const Frame& frame, const Pens& pens,
                    const Legend& legend, const SvgText& drawing) {
    SvgText head;
    const double height = frame.height() + legend.height();
    head.add(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1}" width="{0}" )"
             R"(height="{1}" font-family="system-ui, sans-serif" font-size="13">)"
             "\n<title>{2}</title>\n",
             Px{frame.width()}, Px{height}, title);
    write_style(head, pens);
    head.add(R"(<clipPath id="frame"><rect width="{0}" height="{1}"/></clipPath>)"
             "\n<rect width=\"{0}\" height=\"{2}\" fill=\"#fff\"/>\n",
             Px{frame.width()}, Px{frame.height()}, Px{height});
    SvgText foot;
    legend.write(foot, frame.height());
    out << head.view() << "<g clip-path=\"url(#frame)\">\n"
        << drawing.view() << "</g>\n"
        << foot.view() << "</svg>\n";
}

}  // namespace signum
