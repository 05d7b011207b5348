#include "sites.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "lines.hpp"
#include "paths.hpp"

namespace signum {
namespace {

constexpr double raster = 1.5;  // pixels: of crowded dots one is drawn

}  // namespace

std::vector<Site> drawn_sites(const Tessellation& tessellation) {
    std::vector<Site> discs(tessellation.sites().begin(), tessellation.sites().end());
    const Shapes& shapes = shapes_of(tessellation.metric());
    for (Site& disc : discs) disc.r = shapes.radius(disc, tessellation.weight_is());
    return discs;
}

DrawnSites::DrawnSites(const Tessellation& tessellation, const Frame& frame, const Pens& pens,
                       std::size_t limit)
    : tessellation_(tessellation),
      frame_(frame),
      pens_(pens),
      shapes_(shapes_of(tessellation.metric())),
      hidden_by_(tessellation.sites().size(), infinite) {
    for (const auto& [site, by] : tessellation.hidden())
        hidden_by_[static_cast<std::size_t>(site)] = by;
    radii_.reserve(hidden_by_.size());
    for (const Site& site : tessellation_.sites())
        radii_.push_back(frame_.length(shapes_.radius(site, tessellation_.weight_is())));
    std::vector<double> seen;
    for (std::size_t i = 0; i < radii_.size(); ++i)
        if (is_in_picture(i)) seen.push_back(radii_[i]);
    smallest_ = smallest_drawn(seen, limit, 0.1);
}

double DrawnSites::nearest(std::size_t site) const {
    const Point at = centre(static_cast<Index>(site));
    return shapes_.outline.norm({std::max({0.0, -at.x, at.x - frame_.width()}),
                                 std::max({0.0, -at.y, at.y - frame_.height()})});
}

double DrawnSites::farthest(std::size_t site) const {
    const Point at = centre(static_cast<Index>(site));
    return shapes_.outline.norm(
        {std::max(at.x, frame_.width() - at.x), std::max(at.y, frame_.height() - at.y)});
}

/// Whether any of it can be seen; a site that is out of the picture may be any number of pixels
/// away.
bool DrawnSites::is_in_picture(std::size_t site) const {
    return nearest(site) <= std::max(radii_[site], pens_.dot) + 1;
}

std::vector<Index> DrawnSites::centred_in_picture() const {
    std::vector<Index> result;
    for (std::size_t i = 0; i < radii_.size(); ++i)
        if (nearest(i) == 0) result.push_back(static_cast<Index>(i));
    return result;
}

void DrawnSites::write_title(SvgText& text, std::size_t site) const {
    text.add("><title>{}", site);
    if (is_hidden(site)) text.add(", hidden by {}", hidden_by_[site]);
    text.add("</title>");
}

void DrawnSites::write_outline(SvgText& text, std::size_t site) const {
    constexpr double beyond = 20;  // pixels: no border of a part is seen
    const Outline& outline = shapes_.outline;
    const Point at = centre(static_cast<Index>(site));
    const double radius = radii_[site];
    const std::string_view kind = is_hidden(site) ? "hidden" : "site";
    const double diagonal = std::hypot(frame_.width(), frame_.height());
    if (radius < 4 * diagonal) {
        text.add(R"(<{} class="{}" )", outline.element, kind);
        outline.write_geometry(text, at, radius);
        write_title(text, site);
        text.add("</{}>\n", outline.element);
        return;
    }
    const std::vector<Point> part = part_inside(
        outline, at, radius, {-beyond, -beyond, frame_.width() + beyond, frame_.height() + beyond});
    if (part.empty()) return;
    text.add(R"(<path class="{}" d=")", kind);
    for (std::size_t i = 0; i < part.size(); ++i)
        text.add("{}{} {}", i == 0 ? 'M' : 'L', Px{part[i].x}, Px{part[i].y});
    text.add("Z\"");
    write_title(text, site);
    text.add("</path>\n");
}

void DrawnSites::write_outlines(SvgText& text) const {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < radii_.size(); ++i)
        if (radii_[i] >= smallest_ && radii_[i] >= pens_.dot && is_in_picture(i))
            order.push_back(i);
    std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t i) { return radii_[i]; });
    for (const std::size_t i : order) write_outline(text, i);
}

void DrawnSites::write_dots(SvgText& text) const {
    for (const bool hidden : {true, false}) write_crowd(text, hidden);
    for (std::size_t i = 0; i < radii_.size(); ++i) {
        if (radii_[i] < smallest_ || radii_[i] >= pens_.dot || !is_in_picture(i)) continue;
        const Point at = centre(static_cast<Index>(i));
        text.add(R"(<circle class="{}" cx="{}" cy="{}" r="{}")",
                 is_hidden(i) ? "hidden-dot" : "dot", Px{at.x}, Px{at.y},
                 Px{is_hidden(i) ? pens_.cross() : pens_.dot});
        write_title(text, i);
        text.add("</circle>\n");
    }
}

// The marks without a number: centres of discs large enough to show them, of all hidden sites, and
// sites too small to have a number. Where they crowd, one stands for all in its square of the
// raster.
void DrawnSites::write_crowd(SvgText& text, bool hidden) const {
    const auto columns = static_cast<std::size_t>(frame_.width() / raster) + 1;
    const auto rows = static_cast<std::size_t>(frame_.height() / raster) + 1;
    std::vector<bool> taken(smallest_ > 0 ? columns * rows : 0);
    Paths paths(text, hidden ? "crosses" : "dots");
    for (std::size_t i = 0; i < radii_.size(); ++i) {
        const bool numbered = radii_[i] >= smallest_;
        if (is_hidden(i) != hidden || (numbered && !hidden && radii_[i] < 3 * pens_.dot)) continue;
        const Point at = centre(static_cast<Index>(i));
        if (nearest(i) > 0) continue;
        if (!taken.empty()) {
            const auto square = static_cast<std::size_t>(at.y / raster) * columns +
                                static_cast<std::size_t>(at.x / raster);
            if (taken[square]) continue;
            taken[square] = true;
        }
        if (hidden)
            paths.cross(at, pens_.cross());
        else
            paths.dot(at);
    }
}

void DrawnSites::describe(Legend& legend) const {
    const std::size_t hidden = tessellation_.hidden().size();
    std::array<std::size_t, 2> shown = {0, 0};
    std::size_t covering = 0;
    for (std::size_t i = 0; i < radii_.size(); ++i) {
        shown[is_hidden(i) ? 1 : 0] += static_cast<std::size_t>(is_in_picture(i));
        covering += static_cast<std::size_t>(farthest(i) <= radii_[i]);
    }
    const auto describe = [&](std::string_view kind, std::string_view name, std::size_t all,
                              std::size_t here) {
        legend.site(kind, here == all ? fmt::format("{} sites: {}", name, all)
                                      : fmt::format("{} sites: {} of {}", name, here, all));
    };
    describe("site", "visible", radii_.size() - hidden, shown[0]);
    if (hidden > 0) describe("hidden", "hidden", hidden, shown[1]);
    if (covering > 0)
        legend.note("sites whose {} covers the whole picture: {}", shapes_.site, covering);
    if (smallest_ > 0)
        legend.note("sites: those under {} px radius are dots without a number, one to {} by {} px",
                    Px{smallest_}, Px{raster}, Px{raster});
}

}  // namespace signum
