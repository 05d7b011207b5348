#include "sites.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "paths.hpp"
#include "thinning.hpp"

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
    // A disc whose centre is in the picture covers all of it from this radius on.
    const double largest = 2 * (frame_.width() + frame_.height());
    radii_.reserve(hidden_by_.size());
    for (const Site& site : tessellation.sites())
        radii_.push_back(
            std::min(frame_.length(shapes_.radius(site, tessellation.weight_is())), largest));
    std::vector<double> seen;
    for (std::size_t i = 0; i < radii_.size(); ++i)
        if (is_in_picture(i)) seen.push_back(radii_[i]);
    smallest_ = smallest_drawn(seen, limit, 0.1);
}

/// Whether any of it can be seen; a site that is out of the picture may be any number of pixels
/// away.
bool DrawnSites::is_in_picture(std::size_t site) const {
    const Point at = centre(static_cast<Index>(site));
    const double reach = std::max(radii_[site], pens_.dot) + 1;
    return -reach <= at.x && at.x <= frame_.width() + reach && -reach <= at.y &&
           at.y <= frame_.height() + reach;
}

void DrawnSites::write_site(SvgText& text, const Outline& outline, std::string_view kind,
                            std::size_t site, double radius) const {
    if (!is_in_picture(site)) return;
    text.add(R"(<{} class="{}" )", outline.element, kind);
    outline.write_geometry(text, centre(static_cast<Index>(site)), radius);
    text.add("><title>{}", site);
    if (is_hidden(site)) text.add(", hidden by {}", hidden_by_[site]);
    text.add("</title></{}>\n", outline.element);
}

void DrawnSites::write_outlines(SvgText& text) const {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < radii_.size(); ++i)
        if (radii_[i] >= smallest_ && radii_[i] >= pens_.dot) order.push_back(i);
    std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t i) { return radii_[i]; });
    for (const std::size_t i : order)
        write_site(text, shapes_.outline, is_hidden(i) ? "hidden" : "site", i, radii_[i]);
}

void DrawnSites::write_dots(SvgText& text) const {
    for (const bool hidden : {true, false}) write_crowd(text, hidden);
    for (std::size_t i = 0; i < radii_.size(); ++i)
        if (radii_[i] >= smallest_ && radii_[i] < pens_.dot)
            write_site(text, disc_outline(), is_hidden(i) ? "hidden-dot" : "dot", i, pens_.dot);
}

// The dots without a number: centres of discs large enough to show them, and sites too small to
// have a number. Where they crowd, one stands for all in its square of the raster.
void DrawnSites::write_crowd(SvgText& text, bool hidden) const {
    const auto columns = static_cast<std::size_t>(frame_.width() / raster) + 1;
    const auto rows = static_cast<std::size_t>(frame_.height() / raster) + 1;
    std::vector<bool> taken(smallest_ > 0 ? columns * rows : 0);
    Paths paths(text, hidden ? "hidden-dots" : "dots");
    for (std::size_t i = 0; i < radii_.size(); ++i) {
        const bool numbered = radii_[i] >= smallest_;
        if (is_hidden(i) != hidden || (numbered && (hidden || radii_[i] < 3 * pens_.dot))) continue;
        const Point at = centre(static_cast<Index>(i));
        if (!(0 <= at.x && at.x <= frame_.width() && 0 <= at.y && at.y <= frame_.height()))
            continue;
        if (!taken.empty()) {
            const auto square = static_cast<std::size_t>(at.y / raster) * columns +
                                static_cast<std::size_t>(at.x / raster);
            if (taken[square]) continue;
            taken[square] = true;
        }
        paths.dot(at);
    }
}

void DrawnSites::describe(Legend& legend) const {
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

}  // namespace signum
