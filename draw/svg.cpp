#include <signum/draw/frame.hpp>
#include <signum/draw/legend.hpp>
#include <signum/draw/shapes.hpp>
#include <signum/draw/style.hpp>
#include <signum/draw/svg.hpp>
#include <signum/draw/svg_text.hpp>
#include <signum/draw/thinning.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <ostream>
#include <span>
#include <string_view>
#include <vector>

namespace signum {
namespace {

constexpr double picture_width = 900.0;
constexpr double raster = 1.5;      // pixels: of crowded dots one is drawn
constexpr double invisible = 0.01;  // pixels: shorter lines are points
// Browsers stroke many short paths faster than a long one.
constexpr std::size_t lines_in_a_path = 500;

double length(const Segment& line) {
    return std::hypot(line.to.x - line.from.x, line.to.y - line.from.y);
}

double median_length(std::span<const Segment> lines) {
    if (lines.empty()) return picture_width;
    std::vector<double> lengths(lines.size());
    std::ranges::transform(lines, lengths.begin(), length);
    const auto median = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::ranges::nth_element(lengths, median);
    return *median;
}

/// Lines of one class, chunk by chunk.
class Paths {
 public:
    Paths(SvgText& text, std::string_view kind) : text_(text), kind_(kind) {}
    Paths(const Paths&) = delete;
    Paths& operator=(const Paths&) = delete;
    ~Paths() {
        if (drawn_ > 0) text_.add("\"/>\n");
    }

    void line(const Segment& line) {
        begin();
        text_.add("M{} {}L{} {}", Px{line.from.x}, Px{line.from.y}, Px{line.to.x}, Px{line.to.y});
    }
    void dot(Point at) {
        begin();
        text_.add("M{} {}h0", Px{at.x}, Px{at.y});
    }
    [[nodiscard]] std::size_t drawn() const noexcept { return drawn_; }

 private:
    void begin() {
        if (drawn_ % lines_in_a_path == 0)
            text_.add(R"({}<path class="{}" d=")", drawn_ == 0 ? "" : "\"/>\n", kind_);
        ++drawn_;
    }

    SvgText& text_;
    std::string_view kind_;
    std::size_t drawn_ = 0;
};

/// How near a line is to the middle of the picture: 1 there, 0 at the border.
double nearness(const Segment& line, const Frame& frame) {
    const double x = (line.from.x + line.to.x) / frame.width() - 1;
    const double y = (line.from.y + line.to.y) / frame.height() - 1;
    return std::max(0.0, 1 - std::max(std::abs(x), std::abs(y)));
}

/// The lines of one kind. Of too many, those too short to be seen go first; of still too many, all
/// but those in the middle of the picture, so that a part of it is complete.
void write_lines(SvgText& text, Legend& legend, std::string_view kind, std::string_view label,
                 std::span<const Segment> lines, const Frame& frame, std::size_t limit) {
    if (lines.empty()) return;
    std::vector<double> lengths(lines.size());
    std::ranges::transform(lines, lengths.begin(), length);
    const double shortest = std::min(smallest_drawn(lengths, limit, 0.1), 1.0);

    std::vector<Segment> seen;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (lengths[i] >= std::max(shortest, invisible)) seen.push_back(lines[i]);
    std::vector<double> near(seen.size());
    std::ranges::transform(seen, near.begin(),
                           [&](const Segment& line) { return nearness(line, frame); });
    const double border = smallest_drawn(near, limit, 0.01);

    Paths paths(text, kind);
    for (std::size_t i = 0; i < seen.size(); ++i)
        if (near[i] >= border) paths.line(seen[i]);
    legend.line(kind, label);
    if (shortest > 0)
        legend.note("{}: {} of {} lines drawn, left out those under {} px{}", label, paths.drawn(),
                    lines.size(), Px{shortest},
                    border > 0
                        ? fmt::format(" and those outside the middle {:.0f} %", 100 * (1 - border))
                        : "");
}

/// What the picture of one tessellation is made from.
class Picture {
 public:
    Picture(const Tessellation& tessellation, const SvgOptions& options);
    void write(std::ostream& out) const;

 private:
    [[nodiscard]] Point centre(Index site) const {
        const Site& s = tessellation_.sites()[static_cast<std::size_t>(site)];
        return frame_.at({s.x, s.y});
    }
    [[nodiscard]] bool is_hidden(std::size_t site) const { return hidden_by_[site] != infinite; }
    [[nodiscard]] std::vector<Segment> straight(std::span<const Edge> edges) const;
    void write_discs(SvgText& text) const;
    void write_dots(SvgText& text) const;
    void write_crowd(SvgText& text, bool hidden) const;
    void write_site(SvgText& text, const Outline& outline, std::string_view kind, std::size_t site,
                    double radius) const;
    void describe(Legend& legend) const;

    const Tessellation& tessellation_;
    const SvgOptions& options_;
    const Shapes& shapes_;
    std::vector<Index> hidden_by_;  // -1 for a visible site
    Frame frame_;
    std::vector<Segment> edges_;
    Pens pens_;
    std::vector<double> radii_;  // in pixels
    double smallest_ = 0.0;      // smaller sites are dots without a number
};

std::vector<Site> drawn_sites(const Tessellation& tessellation, const Shapes& shapes) {
    std::vector<Site> discs(tessellation.sites().begin(), tessellation.sites().end());
    for (Site& disc : discs) disc.r = shapes.radius(disc, tessellation.weight_is());
    return discs;
}

Picture::Picture(const Tessellation& tessellation, const SvgOptions& options)
    : tessellation_(tessellation),
      options_(options),
      shapes_(shapes_of(tessellation.metric())),
      hidden_by_(tessellation.sites().size(), infinite),
      frame_(drawn_sites(tessellation, shapes_), picture_width),
      edges_(straight(tessellation.edges())),
      pens_(median_length(edges_)) {
    for (const auto& [site, by] : tessellation.hidden())
        hidden_by_[static_cast<std::size_t>(site)] = by;
    // A disc whose centre is in the picture covers all of it from this radius on.
    const double largest = 2 * (frame_.width() + frame_.height());
    radii_.reserve(hidden_by_.size());
    for (const Site& site : tessellation.sites())
        radii_.push_back(
            std::min(frame_.length(shapes_.radius(site, tessellation.weight_is())), largest));
    smallest_ = smallest_drawn(radii_, options.site_limit, 0.1);
}

// Two sites may share several edges, which stand one after another: one line will do.
std::vector<Segment> Picture::straight(std::span<const Edge> edges) const {
    std::vector<Segment> lines;
    Edge before = {infinite, infinite};
    for (const Edge& edge : edges) {
        const auto& [a, b] = edge;
        if (a != infinite && b != infinite && edge != before)
            lines.push_back({centre(a), centre(b)});
        before = edge;
    }
    return lines;
}

void Picture::write_site(SvgText& text, const Outline& outline, std::string_view kind,
                         std::size_t site, double radius) const {
    const Point at = centre(static_cast<Index>(site));
    text.add(R"(<{} class="{}" )", outline.element, kind);
    outline.write_geometry(text, at, radius);
    text.add("><title>{}", site);
    if (is_hidden(site)) text.add(", hidden by {}", hidden_by_[site]);
    text.add("</title></{}>\n", outline.element);
}

// The largest first, so that every disc can be reached by the pointer.
void Picture::write_discs(SvgText& text) const {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < radii_.size(); ++i)
        if (radii_[i] >= smallest_ && radii_[i] >= pens_.dot) order.push_back(i);
    std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t i) { return radii_[i]; });
    for (const std::size_t i : order)
        write_site(text, shapes_.outline, is_hidden(i) ? "hidden" : "site", i, radii_[i]);
}

// Centres of visible discs, and the sites too small for a disc.
void Picture::write_dots(SvgText& text) const {
    for (const bool hidden : {true, false}) write_crowd(text, hidden);
    for (std::size_t i = 0; i < radii_.size(); ++i)
        if (radii_[i] >= smallest_ && radii_[i] < pens_.dot)
            write_site(text, disc_outline(), is_hidden(i) ? "hidden-dot" : "dot", i, pens_.dot);
}

// The dots without a number: centres of discs large enough to show them, and sites too small to
// have a number. Where they crowd, one stands for all in its square of the raster.
void Picture::write_crowd(SvgText& text, bool hidden) const {
    const auto columns = static_cast<std::size_t>(frame_.width() / raster) + 1;
    const auto rows = static_cast<std::size_t>(frame_.height() / raster) + 1;
    std::vector<bool> taken(smallest_ > 0 ? columns * rows : 0);
    Paths paths(text, hidden ? "hidden-dots" : "dots");
    for (std::size_t i = 0; i < radii_.size(); ++i) {
        const bool numbered = radii_[i] >= smallest_;
        if (is_hidden(i) != hidden || (numbered && (hidden || radii_[i] < 3 * pens_.dot))) continue;
        const Point at = centre(static_cast<Index>(i));
        if (!taken.empty()) {
            const auto square = static_cast<std::size_t>(at.y / raster) * columns +
                                static_cast<std::size_t>(at.x / raster);
            if (taken[square]) continue;
            taken[square] = true;
        }
        paths.dot(at);
    }
}

void Picture::describe(Legend& legend) const {
    const std::size_t hidden = tessellation_.hidden().size();
    legend.site("site", fmt::format("visible sites: {}", radii_.size() - hidden));
    if (hidden > 0) legend.site("hidden", fmt::format("hidden sites: {}", hidden));
    const double diagonal = shapes_.norm({frame_.width(), frame_.height()});
    const auto covering = std::ranges::count_if(radii_, [&](double r) { return r > diagonal; });
    if (covering > 0)
        legend.note("sites whose {} covers the whole picture: {}", shapes_.site, covering);
    if (smallest_ > 0)
        legend.note("sites: those under {} px radius are dots without a number, one to {} by {} px",
                    Px{smallest_}, Px{raster}, Px{raster});
}

void Picture::write(std::ostream& out) const {
    Legend legend(frame_.width(), shapes_.outline);
    describe(legend);
    SvgText drawing;
    write_discs(drawing);
    write_lines(drawing, legend, "cell", shapes_.cells, shapes_.cell_edges(tessellation_, frame_),
                frame_, options_.line_limit);
    write_lines(drawing, legend, "edge", "tessellation", edges_, frame_, options_.line_limit);
    write_lines(drawing, legend, "flipped", "flipped edges", straight(options_.flipped), frame_,
                options_.line_limit);
    write_lines(drawing, legend, "wrong", "wrong edges", straight(options_.wrong), frame_,
                options_.line_limit);
    write_dots(drawing);

    SvgText head;
    const double height = frame_.height() + legend.height();
    head.add(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1}" width="{0}" )"
             R"(height="{1}" font-family="system-ui, sans-serif" font-size="13">)"
             "\n<title>{2} tessellation of {3} sites</title>\n",
             Px{frame_.width()}, Px{height}, name_of(tessellation_.metric()), radii_.size());
    write_style(head, pens_);
    head.add(R"(<clipPath id="frame"><rect width="{0}" height="{1}"/></clipPath>)"
             "\n<rect width=\"{0}\" height=\"{2}\" fill=\"#fff\"/>\n",
             Px{frame_.width()}, Px{frame_.height()}, Px{height});
    SvgText foot;
    legend.write(foot, frame_.height());
    out << head.view() << "<g clip-path=\"url(#frame)\">\n"
        << drawing.view() << "</g>\n"
        << foot.view() << "</svg>\n";
}

}  // namespace

void write_svg(std::ostream& out, const Tessellation& tessellation, const SvgOptions& options) {
    Picture(tessellation, options).write(out);
}

}  // namespace signum
