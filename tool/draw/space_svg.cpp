#include "svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "document.hpp"
#include "lines.hpp"
#include "numbers.hpp"
#include "paths.hpp"
#include "shapes.hpp"
#include "space_view.hpp"

namespace signum {
namespace {

/// From far to near, each drawn over those before it.
constexpr std::size_t slices = 12;

struct Seen {
    std::vector<Site> discs;      ///< in the plane of the picture
    std::vector<double> heights;  ///< toward the eye
};

/// All lengths divided by one power of two, and from the middle of the centres.
Seen seen_of(std::span<const Site3> sites, WeightIs weight_is) {
    const Shapes& shapes = shapes_of(Metric::power);
    std::vector<double> radii;
    radii.reserve(sites.size());
    double largest = 0.0;
    for (const auto& [x, y, z, r] : sites) {
        radii.push_back(shapes.radius({0.0, 0.0, r}, weight_is));
        largest = std::max({largest, std::fabs(x), std::fabs(y), std::fabs(z), radii.back()});
    }
    const int exponent = largest > 0.0 ? std::ilogb(largest) : 0;
    const auto scaled = [exponent](double length) { return std::ldexp(length, -exponent); };
    constexpr double none = std::numeric_limits<double>::infinity();
    std::array<double, 3> low = {none, none, none};
    std::array<double, 3> high = {-none, -none, -none};
    for (const auto& [x, y, z, r] : sites)
        for (std::size_t axis = 0; const double each : {x, y, z}) {
            low[axis] = std::min(low[axis], scaled(each));
            high[axis] = std::max(high[axis], scaled(each));
            ++axis;
        }
    Seen seen;
    seen.discs.reserve(sites.size());
    seen.heights.reserve(sites.size());
    for (std::size_t i = 0; i < sites.size(); ++i) {
        const Point3 place = {scaled(sites[i].x) - (low[0] + high[0]) / 2,
                              scaled(sites[i].y) - (low[1] + high[1]) / 2,
                              scaled(sites[i].z) - (low[2] + high[2]) / 2};
        seen.discs.push_back(
            {dot_product(place, to_the_right), dot_product(place, upward), scaled(radii[i])});
        seen.heights.push_back(dot_product(place, to_the_eye));
    }
    return seen;
}

struct EdgesInSpace {
    std::vector<Edge> edges;
    bool of_hull_alone = false;
};

/// Each edge between two sites once, sorted; of too many those of the hull. A cell has about as
/// many edges of its own as one.
EdgesInSpace edges_of(const SpaceTessellation& tessellation, std::size_t limit) {
    EdgesInSpace result;
    result.of_hull_alone = tessellation.dimension == 3 && tessellation.cells.size() > limit;
    const auto vertices = static_cast<std::size_t>(tessellation.dimension + 1);
    for (const SpaceCell& cell : tessellation.cells) {
        if (result.of_hull_alone && cell[0] != infinite) continue;
        for (std::size_t k = 0; k < vertices; ++k)
            for (std::size_t m = k + 1; m < vertices; ++m)
                if (cell[k] != infinite && cell[m] != infinite)
                    result.edges.push_back(
                        {std::min(cell[k], cell[m]), std::max(cell[k], cell[m])});
    }
    std::ranges::sort(result.edges);
    result.edges.erase(std::unique(result.edges.begin(), result.edges.end()), result.edges.end());
    return result;
}

class SpacePicture {
 public:
    SpacePicture(const SpaceTessellation& tessellation, std::span<const Site3> sites,
                 WeightIs weight_is, const SpaceSvgOptions& options)
        : tessellation_(tessellation),
          seen_(seen_of(sites, weight_is)),
          frame_(seen_.discs, picture_width),
          edges_(edges_of(tessellation, options.line_limit)),
          pens_(median_length(lines_of(edges_.edges), picture_width)),
          legend_(document_width, shapes_of(Metric::power).outline),
          hidden_by_(sites.size(), infinite) {
        for (const auto& [site, by] : tessellation.hidden)
            hidden_by_[static_cast<std::size_t>(site)] = by;
        const auto [low, high] = std::ranges::minmax(seen_.heights);
        low_ = low;
        high_ = high;
        choose_sites(options.site_limit);
        choose_edges(options.line_limit);
    }

    void write(std::ostream& out) {
        describe();
        for (std::size_t slice = 0; slice < slices; ++slice) write_slice(slice);
        write_numbers_of_few();
        if (too_large_ > 0)
            legend_.note("sites far larger than the picture, drawn as dots: {}", too_large_);
        SvgText directions;
        write_directions(directions, frame_.height());
        write_document(out,
                       fmt::format("power tessellation of {} sites in space", tessellation_.sites),
                       frame_, pens_, legend_, drawing_, directions);
    }

 private:
    [[nodiscard]] Point centre(std::size_t site) const noexcept {
        return frame_.at({seen_.discs[site].x, seen_.discs[site].y});
    }
    [[nodiscard]] Point centre(Index site) const noexcept {
        return centre(static_cast<std::size_t>(site));
    }
    [[nodiscard]] bool is_hidden(std::size_t site) const { return hidden_by_[site] != infinite; }
    [[nodiscard]] double height_of(const Edge& edge) const {
        const auto at = [&](Index site) { return seen_.heights[static_cast<std::size_t>(site)]; };
        return at(edge[0]) / 2 + at(edge[1]) / 2;
    }
    /// The slice of a height; the last one is the nearest.
    [[nodiscard]] std::size_t slice_of(double height) const noexcept {
        if (!(high_ > low_)) return slices - 1;
        const double share = (height - low_) / (high_ - low_);
        return std::min(slices - 1, static_cast<std::size_t>(share * slices));
    }
    [[nodiscard]] std::vector<Conic> lines_of(std::span<const Edge> edges) const {
        std::vector<Conic> lines;
        lines.reserve(edges.size());
        for (const auto& [a, b] : edges) lines.push_back(Conic::straight(centre(a), centre(b)));
        return lines;
    }

    /// Far ones first; of too many the nearest.
    void choose_sites(std::size_t limit) {
        for (std::size_t i = 0; i < seen_.discs.size(); ++i) order_.push_back(i);
        std::ranges::stable_sort(order_, {}, [&](std::size_t i) { return seen_.heights[i]; });
        if (order_.size() > limit)
            order_.erase(order_.begin(), order_.end() - static_cast<std::ptrdiff_t>(limit));
    }
    void choose_edges(std::size_t limit) {
        all_edges_ = edges_.edges.size();
        std::ranges::stable_sort(edges_.edges, {}, [&](const Edge& e) { return height_of(e); });
        if (all_edges_ > limit)
            edges_.edges.erase(edges_.edges.begin(),
                               edges_.edges.end() - static_cast<std::ptrdiff_t>(limit));
    }

    /// In pixels; 0 of what is so large that a disc would say nothing.
    [[nodiscard]] double radius_of(std::size_t site) const {
        const double radius = frame_.length(seen_.discs[site].r);
        return radius >= 4 * std::hypot(frame_.width(), frame_.height()) ? 0.0 : radius;
    }
    /// Whether some of the sites drawn, hidden or visible ones, are more than dots.
    [[nodiscard]] bool has_discs(bool hidden) const {
        return std::ranges::any_of(order_, [&](std::size_t site) {
            return is_hidden(site) == hidden && radius_of(site) >= pens_.dot;
        });
    }

    void describe() {
        const std::size_t hidden = tessellation_.hidden.size();
        legend_.site(has_discs(false) ? "site" : "dot",
                     fmt::format("visible sites: {}", hidden_by_.size() - hidden));
        if (hidden > 0) {
            legend_.site(has_discs(true) ? "hidden" : "hidden-dot",
                         fmt::format("hidden sites: {}", hidden));
        }
        if (!edges_.edges.empty())
            legend_.line("edge", edges_.of_hull_alone ? "edges of the hull" : "tessellation");
        if (order_.size() < hidden_by_.size())
            legend_.note("sites: the {} nearest of {} drawn", order_.size(), hidden_by_.size());
        if (edges_.of_hull_alone)
            legend_.note("edges inside are not drawn: there are {} cells",
                         tessellation_.cells.size());
        if (edges_.edges.size() < all_edges_)
            legend_.note("edges: the {} nearest of {} drawn", edges_.edges.size(), all_edges_);
        if (tessellation_.dimension == 3)
            legend_.note(
                "seen from far away, 23 degrees to the right of z and 16 above; far is pale");
    }

    void write_slice(std::size_t slice) {
        // The farthest is a third as strong as the nearest.
        const double strength = (slices / 2.0 + static_cast<double>(slice)) / (1.5 * slices - 1);
        drawing_.add("<g opacity=\"{}\">\n", Px{strength});
        while (next_site_ < order_.size() && slice_of(seen_.heights[order_[next_site_]]) == slice)
            write_site(order_[next_site_++]);
        {
            Paths paths(drawing_, "edge");
            for (; next_edge_ < edges_.edges.size() &&
                   slice_of(height_of(edges_.edges[next_edge_])) == slice;
                 ++next_edge_) {
                const auto& [a, b] = edges_.edges[next_edge_];
                paths.line(Conic::straight(centre(a), centre(b)));
            }
        }
        drawing_.add("</g>\n");
    }

    void write_site(std::size_t site) {
        const Point at = centre(site);
        const double radius = radius_of(site);
        if (radius < frame_.length(seen_.discs[site].r)) ++too_large_;
        const auto write_circle = [&](std::string_view kind, double r) {
            drawing_.add(R"(<circle class="{}" cx="{}" cy="{}" r="{}"><title>{})", kind, Px{at.x},
                         Px{at.y}, Px{r}, site);
            if (is_hidden(site)) drawing_.add(", hidden by {}", hidden_by_[site]);
            drawing_.add("</title></circle>\n");
        };
        if (radius >= pens_.dot) write_circle(is_hidden(site) ? "hidden" : "site", radius);
        if (is_hidden(site)) {
            if (radius < pens_.dot) write_circle("hidden-dot", pens_.cross());
            Paths(drawing_, "crosses").cross(at, pens_.cross());
        } else if (radius < pens_.dot) {
            write_circle("dot", pens_.dot);
        } else if (radius >= 3 * pens_.dot) {
            Paths(drawing_, "dots").dot(at);
        }
    }

    /// To the upper right of the centres.
    void write_numbers_of_few() {
        if (order_.size() > most_numbers) return;
        for (const std::size_t site : order_) {
            const Point at = centre(site);
            const double reach = pens_.cross() + 2;
            drawing_.add("<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n",
                         is_hidden(site) ? "hidden-number" : "number",
                         Px{at.x + reach + font_size / 3}, Px{at.y - reach}, site);
        }
    }

    const SpaceTessellation& tessellation_;
    Seen seen_;
    Frame frame_;
    EdgesInSpace edges_;
    std::size_t all_edges_ = 0;
    Pens pens_;
    Legend legend_;
    std::vector<Index> hidden_by_;    // -1 for a visible site
    std::vector<std::size_t> order_;  // of the sites drawn, far ones first
    double low_ = 0.0;                // the heights of the farthest and the nearest centre
    double high_ = 0.0;
    std::size_t next_site_ = 0;  // of order_, the next to be drawn
    std::size_t next_edge_ = 0;
    std::size_t too_large_ = 0;
    SvgText drawing_;
};

}  // namespace

void write_svg(std::ostream& out, const SpaceTessellation& tessellation,
               std::span<const Site3> sites, WeightIs weight_is, const SpaceSvgOptions& options) {
    SpacePicture(tessellation, sites, weight_is, options).write(out);
}

}  // namespace signum
