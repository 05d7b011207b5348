#include "lines.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "paths.hpp"

namespace signum {
namespace {

constexpr double invisible = 0.01;  // pixels: shorter lines are points
constexpr double coarse = 20;       // pixels between doubles: cells would be nonsense
constexpr double flat = 0.05;       // pixels from an arc to the parabola that is drawn

double length(const Conic& line) {
    return std::hypot(line.to.x - line.from.x, line.to.y - line.from.y);
}

/// How near a line is to the middle of the picture: 1 there, 0 at the border.
double nearness(const Conic& line, const Frame& frame) {
    const double x = (line.from.x + line.to.x) / frame.width() - 1;
    const double y = (line.from.y + line.to.y) / frame.height() - 1;
    return std::max(0.0, 1 - std::max(std::abs(x), std::abs(y)));
}

}  // namespace

Conic in_pixels(const Conic& divided, int exponent, const Frame& frame) noexcept {
    return {frame.at(divided.from, exponent), frame.at(divided.control, exponent),
            frame.at(divided.to, exponent), divided.weight};
}

std::optional<ClippedVoronoi> clipped_to(const Frame& frame, const Voronoi& voronoi, int threads) {
    const Box box = frame.box(voronoi.exponent());
    if (frame.rounding() > coarse || !is_of_usual_size(box)) return std::nullopt;
    return ClippedVoronoi(voronoi, box, Lengths::divided, threads);
}

void note_rounding(Legend& legend, const Frame& frame) {
    if (frame.rounding() > coarse)
        legend.note("cells are not drawn: doubles are too coarse beside such coordinates");
    else if (frame.rounding() > 0.5)
        legend.note("cells are up to {} px off: doubles are no finer beside such coordinates",
                    Px{std::ceil(frame.rounding())});
}

std::vector<Conic> cell_edges(const Voronoi& voronoi, const Frame& frame, int threads) {
    return cell_edges(clipped_to(frame, voronoi, threads), frame);
}

std::vector<Conic> cell_edges(const std::optional<ClippedVoronoi>& clipped, const Frame& frame) {
    std::vector<Conic> lines;
    if (!clipped) return lines;
    const Voronoi& voronoi = clipped->voronoi();
    for (std::size_t e = 0; e < voronoi.edges().size(); ++e)
        for (const Conic& part : clipped->edge(static_cast<Index>(e)))
            lines.push_back(in_pixels(part, voronoi.exponent(), frame));
    return lines;
}

void write_stretch(SvgText& text, const Conic& conic) {
    if (conic.is_straight()) {
        text.add("L{} {}", Px{conic.to.x}, Px{conic.to.y});
        return;
    }
    for (const Conic& part : parabolas(conic, flat))
        text.add("Q{} {} {} {}", Px{part.control.x}, Px{part.control.y}, Px{part.to.x},
                 Px{part.to.y});
}

double median_length(std::span<const Conic> lines, double otherwise) {
    if (lines.empty()) return otherwise;
    std::vector<double> lengths(lines.size());
    std::ranges::transform(lines, lengths.begin(), length);
    const auto median = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::ranges::nth_element(lengths, median);
    return *median;
}

void write_lines(SvgText& text, Legend& legend, std::string_view kind, std::string_view label,
                 std::span<const Conic> lines, const Frame& frame, std::size_t limit) {
    if (lines.empty()) return;
    std::vector<double> lengths(lines.size());
    std::ranges::transform(lines, lengths.begin(), length);
    const double shortest = std::min(smallest_drawn(lengths, limit, 0.1), 1.0);

    std::vector<Conic> seen;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (lengths[i] >= std::max(shortest, invisible)) seen.push_back(lines[i]);
    std::vector<double> near(seen.size());
    std::ranges::transform(seen, near.begin(),
                           [&](const Conic& line) { return nearness(line, frame); });
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

double smallest_drawn(std::span<const double> sizes, std::size_t limit, double step) {
    if (sizes.size() <= limit) return 0.0;
    std::vector<double> falling(sizes.begin(), sizes.end());
    const auto first_too_many = falling.begin() + static_cast<std::ptrdiff_t>(limit);
    std::nth_element(falling.begin(), first_too_many, falling.end(), std::greater<>());
    // Rounding up hides the last digits in which sizes that should be equal may differ.
    return (std::floor(*first_too_many / step + 1e-6) + 1) * step;
}

}  // namespace signum
