#include "clip.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "../core/parallel.hpp"
#include "../exact/floating_environment.hpp"
#include "in_ieee.hpp"
#include "vector.hpp"

namespace signum {
namespace {

/// The largest coordinate of a box.
double extent_of(const Box& box) {
    return std::max({std::abs(box.x0), std::abs(box.y0), std::abs(box.x1), std::abs(box.y1)});
}

/// Times 2^exponent.
Conic scaled(const Conic& conic, int exponent) {
    if (exponent == 0) return conic;
    return {scaled(conic.from, exponent), scaled(conic.control, exponent),
            scaled(conic.to, exponent), conic.weight};
}

/// That of the largest coordinate, 0 where it is of ordinary size.
int exponent_of(const CellShape& shape) {
    double largest = 0;
    for (const auto& loop : shape.loops)
        for (const Conic& conic : loop)
            largest = std::max({largest, std::abs(conic.from.x), std::abs(conic.from.y)});
    const int exponent = largest > 0 ? std::ilogb(largest) : 0;
    return std::abs(exponent) > 200 ? exponent : 0;
}

Box box_of_loops(std::span<const std::vector<Conic>> loops) {
    Box box = {no_box.x1, no_box.y1, no_box.x0, no_box.y0};
    for (const auto& loop : loops)
        for (const Conic& conic : loop)
            for (const Point p : {conic.from, conic.control})
                box = {std::min(box.x0, p.x), std::min(box.y0, p.y), std::max(box.x1, p.x),
                       std::max(box.y1, p.y)};
    return box;
}

double area_of(const std::vector<Conic>& loop) {
    double area = 0;
    for (const Conic& conic : loop) area += in_ieee::moments(conic, loop.front().from).area;
    return area;
}

}  // namespace

Measure measure(const CellShape& shape) {
    const exact::IeeeEnvironment environment;
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    if (shape.unbounded && !shape.in_box) return {no_box.x1, no_box.x1, {nan, nan}};
    double perimeter = 0;
    Conic::Moments moments = {0, 0, 0};
    Point origin = {0, 0};
    // Moments are products of three lengths, which are to stay within a double's range.
    const int exponent = exponent_of(shape);
    if (!shape.loops.empty()) origin = scaled(shape.loops.front().front().from, -exponent);
    for (const auto& loop : shape.loops)
        for (const Conic& part : loop) {
            const Conic conic = scaled(part, -exponent);
            const Conic::Moments of = in_ieee::moments(conic, origin);
            moments.area += of.area;
            moments.x += of.x;
            moments.y += of.y;
            perimeter += in_ieee::length(conic);
        }
    // No region has less than nothing: a shape narrower than rounding may turn over, and then its
    // area is as small as rounding, below 0.
    if (moments.area <= 0) return {0.0, std::ldexp(perimeter, exponent), {nan, nan}};
    Point centroid = {origin.x + moments.x / moments.area, origin.y + moments.y / moments.area};
    if (moments.area < 0x1p-30 * perimeter * perimeter) {
        // Of next to no area rounding may lead out of the shape.
        const Box around = box_of_loops(shape.loops);
        const Point low = scaled(Point{around.x0, around.y0}, -exponent);
        const Point high = scaled(Point{around.x1, around.y1}, -exponent);
        centroid = {std::clamp(centroid.x, low.x, high.x), std::clamp(centroid.y, low.y, high.y)};
    }
    return {std::ldexp(moments.area, 2 * exponent), std::ldexp(perimeter, exponent),
            scaled(centroid, exponent)};
}

Box default_box(std::span<const Site> sites, int exponent) {
    const exact::IeeeEnvironment environment;
    if (sites.empty()) throw std::invalid_argument("no site, no box");
    Box box = {sites[0].x, sites[0].y, sites[0].x, sites[0].y};
    for (const Site& s : sites) {
        if (!are_finite(Point{s.x, s.y})) throw std::invalid_argument("a centre is not finite");
        box = {std::min(box.x0, s.x), std::min(box.y0, s.y), std::max(box.x1, s.x),
               std::max(box.y1, s.y)};
    }
    const double longer = std::max(box.x1 / 2 - box.x0 / 2, box.y1 / 2 - box.y0 / 2);
    // Doubles are to tell its sides apart.
    const double least =
        std::max(0x1p-50 * extent_of(box), std::numeric_limits<double>::denorm_min());
    const double of_a_point = std::ldexp(1.0, std::min(exponent, 0));
    const double margin = std::max(longer > 0 ? longer / 5 : of_a_point, least);
    constexpr double largest = std::numeric_limits<double>::max();
    return {std::max(box.x0 - margin, -largest), std::max(box.y0 - margin, -largest),
            std::min(box.x1 + margin, largest), std::min(box.y1 + margin, largest)};
}

bool is_of_usual_size(const Box& divided) noexcept {
    // Of such lengths products of two are within a double's range.
    constexpr double longest = 0x1p500;
    return exact::in_ieee_environment(
        [](const Box& box) {
            return extent_of(box) <= longest && box.x1 - box.x0 >= 1 / longest &&
                   box.y1 - box.y0 >= 1 / longest;
        },
        divided);
}

bool fits(const Box& box, const Voronoi& voronoi) noexcept {
    const exact::IeeeEnvironment environment;
    const auto divided = [&](double side) { return std::ldexp(side, -voronoi.exponent()); };
    return is_of_usual_size({divided(box.x0), divided(box.y0), divided(box.x1), divided(box.y1)});
}

ClippedVoronoi::ClippedVoronoi(const Voronoi& voronoi, const Box& box, Lengths lengths, int threads)
    : voronoi_(voronoi),
      box_(box),
      exponent_(lengths == Lengths::of_the_plane ? voronoi.exponent() : 0),
      is_bounded_(box != no_box) {
    const exact::IeeeEnvironment environment;
    if (!(box.x0 < box.x1 && box.y0 < box.y1))
        throw std::invalid_argument("a box needs x0 < x1 and y0 < y1");
    if (is_bounded_ && !are_finite(Point{box.x0, box.y0}, Point{box.x1, box.y1}))
        throw std::invalid_argument("the corners of a box are to be finite");
    for (double* side : {&box_.x0, &box_.y0, &box_.x1, &box_.y1})
        *side = std::ldexp(*side, -exponent_);
    if (is_bounded_ && !is_of_usual_size(box_))
        throw std::invalid_argument(
            "the box is too large or too small beside the coordinates and radii of the sites");
    cut_all(threads);
    // No round share of the sides: on round input such a point lies on an edge.
    const int exponent = voronoi.exponent();
    const auto inside = [&](double low, double high, double share) {
        constexpr double largest = std::numeric_limits<double>::max();
        const double value = (1 - share) * low + share * high;
        return std::clamp(std::ldexp(value, exponent), -largest, largest);
    };
    if (is_bounded_)
        at_point_ = voronoi.tessellation().nearest(
            {inside(box_.x0, box_.x1, 0.3819661), inside(box_.y0, box_.y1, 0.5857865)});
}

bool ClippedVoronoi::contains(Point p) const noexcept {
    return box_.x0 < p.x && p.x < box_.x1 && box_.y0 < p.y && p.y < box_.y1;
}

/// The stretch of the edge without what is certainly far from the box; whether it still begins and
/// ends where the edge does.
std::vector<Conic> ClippedVoronoi::pieces_near_box(Index index, bool& from_start,
                                                   bool& to_end) const {
    const Point focus = {box_.x0 / 2 + box_.x1 / 2, box_.y0 / 2 + box_.y1 / 2};
    auto edge = is_bounded_ ? voronoi_.geometry(index, focus) : voronoi_.geometry(index);
    if (!edge) return {};
    from_start = are_finite(edge->start);
    to_end = are_finite(edge->end);
    if (is_bounded_) {
        const Point origin = std::visit(
            [](const auto& curve) {
                if constexpr (std::is_same_v<std::decay_t<decltype(curve)>, StraightCurve>)
                    return curve.origin;
                else
                    return curve.middle;
            },
            edge->curve);
        const double reach =
            std::hypot(std::max(std::abs(box_.x0 - origin.x), std::abs(box_.x1 - origin.x)),
                       std::max(std::abs(box_.y0 - origin.y), std::abs(box_.y1 - origin.y)));
        const double limit =
            1.01 * std::visit([&](const auto& curve) { return in_ieee::beyond(curve, reach); },
                              edge->curve);
        const auto clamp = [&](double& parameter, Point& point, bool& is_end) {
            if (-limit <= parameter && parameter <= limit) return;
            parameter = std::clamp(parameter, -limit, limit);
            point = std::visit([&](const auto& curve) { return in_ieee::at(curve, parameter); },
                               edge->curve);
            is_end = false;
        };
        clamp(edge->from, edge->start, from_start);
        clamp(edge->to, edge->end, to_end);
    }
    if (!are_finite(edge->start, edge->end)) return {};
    if (!(edge->from < edge->to)) {
        // An edge so short that rounding took its direction still joins its ends.
        if (!from_start || !to_end || edge->start == edge->end) return {};
        return {in_ieee::straight(edge->start, edge->end)};
    }
    return in_ieee::stretch(edge->curve, edge->from, edge->start, edge->to, edge->end);
}

void ClippedVoronoi::cut(Index index, Parts& found) const {
    auto& [conics, runs, runs_of] = found;
    const std::size_t before = runs.size();
    bool from_start = false;
    bool to_end = false;
    const std::vector<Conic> pieces = pieces_near_box(index, from_start, to_end);
    bool continues = false;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const std::vector<Inside> parts =
            is_bounded_ ? in_ieee::parts_inside(pieces[i], box_) : std::vector<Inside>{{0, 1}};
        if (parts.empty() || parts.front().first > 0) continues = false;
        for (const Inside& inside : parts) {
            Conic part = in_ieee::part(pieces[i], inside.first, inside.last);
            const bool at_start = inside.first == 0 && contains(part.from);
            const bool at_end = inside.last == 1 && contains(part.to);
            if (!at_start && is_bounded_) part.from = on_border(part.from);
            if (!at_end && is_bounded_) part.to = on_border(part.to);
            if (part.is_straight()) part = in_ieee::straight(part.from, part.to);
            if (!continues || !at_start)
                runs.push_back({conics.size(), 0, i == 0 && at_start && from_start, false});
            conics.push_back(part);
            runs.back().last = conics.size();
            runs.back().ends_at_vertex = i + 1 == pieces.size() && at_end && to_end;
            continues = at_end;
        }
    }
    runs_of.push_back(runs.size() - before);
}

void ClippedVoronoi::cut_all(int threads) {
    const std::size_t edges = voronoi_.edges().size();
    const Workers workers(threads, edges);
    const std::size_t ranges = workers.range_count(edges);
    std::vector<std::vector<Conic>> conics(ranges);
    std::vector<std::vector<Run>> runs(ranges);
    std::vector<std::vector<std::size_t>> runs_of(ranges);
    workers.each(ranges, [&](std::size_t range) {
        const exact::IeeeEnvironment environment;
        Parts parts;
        const std::size_t end = edges * (range + 1) / ranges;
        for (std::size_t e = edges * range / ranges; e < end; ++e)
            cut(static_cast<Index>(e), parts);
        conics[range] = std::move(parts.conics);
        runs[range] = std::move(parts.runs);
        runs_of[range] = std::move(parts.runs_of);
    });
    // Runs are said in places of all conics.
    std::vector<std::size_t> first_conic(1, 0);
    for (const Loop& of_range : conics) first_conic.push_back(first_conic.back() + of_range.size());
    workers.each(ranges, [&](std::size_t range) {
        for (Run& run : runs[range]) {
            run.first += first_conic[range];
            run.last += first_conic[range];
        }
    });
    conics_ = joined(workers, std::move(conics));
    runs_ = joined(workers, std::move(runs));
    first_run_ = joined(workers, std::move(runs_of));
    first_run_.push_back(0);
    std::exclusive_scan(first_run_.begin(), first_run_.end(), first_run_.begin(), std::size_t{0});
}

std::vector<Conic> ClippedVoronoi::edge(Index index) const {
    const exact::IeeeEnvironment environment;
    std::vector<Conic> parts;
    const std::size_t e = checked("edge", index, voronoi_.edges().size());
    for (std::size_t r = first_run_[e]; r < first_run_[e + 1]; ++r)
        for (std::size_t i = runs_[r].first; i < runs_[r].last; ++i)
            parts.push_back(scaled(conics_[i], exponent_));
    return parts;
}

/// The point of the border next to p.
Point ClippedVoronoi::on_border(Point p) const noexcept {
    p = {std::clamp(p.x, box_.x0, box_.x1), std::clamp(p.y, box_.y0, box_.y1)};
    const double distances[] = {p.y - box_.y0, box_.x1 - p.x, box_.y1 - p.y, p.x - box_.x0};
    const auto side = std::min_element(std::begin(distances), std::end(distances)) - distances;
    switch (side) {
        case 0:
            return {p.x, box_.y0};
        case 1:
            return {box_.x1, p.y};
        case 2:
            return {p.x, box_.y1};
        default:
            return {box_.x0, p.y};
    }
}

/// How far around the border, counterclockwise from the lower left corner, in sides: 0 to 4.
double ClippedVoronoi::position(Point p) const noexcept {
    const double width = box_.x1 - box_.x0;
    const double height = box_.y1 - box_.y0;
    if (p.y == box_.y0) return (p.x - box_.x0) / width;
    if (p.x == box_.x1) return 1 + (p.y - box_.y0) / height;
    if (p.y == box_.y1) return 2 + (box_.x1 - p.x) / width;
    return 3 + (box_.y1 - p.y) / height;
}

/// How far it is along the border, counterclockwise, in sides: from 0 to 4.
double ClippedVoronoi::ahead(Point from, Point to) const noexcept {
    const double distance = position(to) - position(from);
    return distance < 0 ? distance + 4 : distance;
}

/// Leads a loop that ends on the border counterclockwise on to another point of it; all around and
/// over its own end where asked.
void ClippedVoronoi::follow_border(Loop& loop, Point end, bool all_around) const {
    const Point corners[] = {
        {box_.x1, box_.y0}, {box_.x1, box_.y1}, {box_.x0, box_.y1}, {box_.x0, box_.y0}};
    const auto line_to = [&](Point next) {
        if (loop.back().to != next) loop.push_back(in_ieee::straight(loop.back().to, next));
    };
    const double from = position(loop.back().to);
    const double to = position(end);
    int side = std::min(static_cast<int>(from), 3);
    const int last = std::min(static_cast<int>(to), 3);
    int sides = (last - side + 4) % 4;
    const bool is_ahead = ahead(loop.back().to, end) < 2;
    if ((sides == 0 && to < from) || (all_around && is_ahead)) sides += 4;
    for (; sides > 0; --sides) {
        line_to(corners[side]);
        side = (side + 1) % 4;
    }
    line_to(end);
}

/// Closes chains of conics from border to border along the border. Behind the end of one the cell
/// lies along the border up to the next start.
std::vector<ClippedVoronoi::Loop> ClippedVoronoi::closed(std::vector<Loop> open) const {
    std::vector<Loop> loops;
    const double width = box_.x1 - box_.x0;
    const double height = box_.y1 - box_.y0;
    const double tolerance = 0x1p-48 + rounding() / std::min(width, height);
    std::multimap<double, std::size_t> starts;  // of the chains that are left, along the border
    for (std::size_t i = 0; i < open.size(); ++i) starts.emplace(position(open[i].front().from), i);
    while (!starts.empty()) {
        Loop loop = std::move(open[starts.begin()->second]);
        starts.erase(starts.begin());
        for (;;) {
            const Point end = loop.back().to;
            const Point start = loop.front().from;
            double least = ahead(end, start);
            bool all_around = false;
            if (least < tolerance || least > 4 - tolerance) {
                // It is a sliver of the box, or cuts one out.
                all_around = area_of(loop) < -speck();
                least = all_around ? 4 : 0;
            }
            // A start behind the end by no more than rounding is where that is.
            auto next = starts.lower_bound(position(end) - tolerance);
            if (next == starts.end()) next = starts.begin();
            if (next != starts.end()) {
                const double distance = ahead(end, open[next->second].front().from);
                if (const double rounded = distance > 4 - tolerance ? 0 : distance; rounded < least)
                    least = rounded;
                else
                    next = starts.end();
            }
            const bool closes = next == starts.end();
            const Point target = closes ? start : open[next->second].front().from;
            if (least > 0)
                follow_border(loop, target, all_around && closes);
            else if (end != target)
                loop.push_back(in_ieee::straight(end, target));
            if (closes) {
                loops.push_back(std::move(loop));
                break;
            }
            const Loop& chain = open[next->second];
            loop.insert(loop.end(), chain.begin(), chain.end());
            starts.erase(next);
        }
    }
    return loops;
}

/// The loops of a cell that reaches the border. How often they go around it is told from the order
/// of ends along it, which rounding may exchange: beside a side, and where edges lie on one
/// another. Then the loops have a whole box too many or too few, which their area betrays.
std::vector<ClippedVoronoi::Loop> ClippedVoronoi::tiling(std::vector<Loop> open, Index site) const {
    std::vector<Loop> loops = closed(std::move(open));
    const double box = (box_.x1 - box_.x0) * (box_.y1 - box_.y0);
    const double rounding = speck();
    if (site == at_point_) {
        // Of spikes without width nobody can tell on which side of them the cell is.
        if (std::ranges::all_of(loops, [&](const Loop& loop) { return area_of(loop) <= rounding; }))
            loops.clear();
    }
    double most = 0;
    for (const Loop& loop : loops) {
        const Box around = box_of_loops({&loop, 1});
        most += (around.x1 - around.x0) * (around.y1 - around.y0);
    }
    if (most < box - rounding) return loops;
    const auto area = [&] {
        double sum = 0;
        for (const Loop& loop : loops) sum += area_of(loop);
        return sum;
    };
    if (area() > box + rounding) {
        // Without the chains that part no more than rounding from the border the order is right.
        open = open_chains(site, loops);
        std::erase_if(open, [this](const Loop& chain) { return runs_along_border(chain); });
        loops = closed(std::move(open));
    }
    if (site != at_point_ && area() >= box - rounding) loops.clear();
    return loops;
}

/// What rounding may do to a point of the box, and to an area.
double ClippedVoronoi::rounding() const noexcept {
    return 0x1p-48 * extent_of(box_);
}
double ClippedVoronoi::speck() const noexcept {
    return rounding() * ((box_.x1 - box_.x0) + (box_.y1 - box_.y0));
}

/// Whether there is nothing but rounding between a chain and the border from its end back to its
/// start, in whichever direction that is.
bool ClippedVoronoi::runs_along_border(const Loop& chain) const {
    const double box = (box_.x1 - box_.x0) * (box_.y1 - box_.y0);
    Loop loop = chain;
    follow_border(loop, chain.front().from, false);
    const double area = area_of(loop);
    return area <= speck() || area >= box - speck();
}

bool ClippedVoronoi::is_speck(const Loop& chain) const noexcept {
    const double size = rounding();
    const Point first = chain.front().from;
    return std::ranges::all_of(chain, [&](const Conic& conic) {
        return std::hypot(conic.control.x - first.x, conic.control.y - first.y) <= size &&
               std::hypot(conic.to.x - first.x, conic.to.y - first.y) <= size;
    });
}

/// Whether a chain that ends at a vertex goes on at another one. An edge between two vertices on
/// the border may by rounding be outside while they are inside: the cell goes on along the border.
bool ClippedVoronoi::joins(const Loop& chain, Point next) const noexcept {
    const Point end = chain.back().to;
    const auto is_on_border = [this](Point p) {
        const Point q = on_border(p);
        return std::hypot(p.x - q.x, p.y - q.y) <= rounding();
    };
    return end == next || !is_bounded_ || !is_on_border(end) || !is_on_border(next);
}

/// What a cell has of edges, from border to border; into `whole` what closes by itself.
std::vector<ClippedVoronoi::Loop> ClippedVoronoi::open_chains(Index site,
                                                              std::vector<Loop>& whole) const {
    std::vector<Loop> chains;
    bool first_begins_at_vertex = false;
    bool continues = false;  // the last chain ends at a vertex inside the box
    for (const VoronoiStep& step : voronoi_.cell(site)) {
        const auto e = static_cast<std::size_t>(step.edge);
        const std::size_t count = first_run_[e + 1] - first_run_[e];
        for (std::size_t i = 0; i < count; ++i) {
            const Run& run = runs_[step.forward ? first_run_[e] + i : first_run_[e + 1] - 1 - i];
            const bool begins = step.forward ? run.begins_at_vertex : run.ends_at_vertex;
            const Conic& first = conics_[step.forward ? run.first : run.last - 1];
            if (!begins || !continues ||
                !joins(chains.back(), step.forward ? first.from : first.to)) {
                if (chains.empty()) first_begins_at_vertex = begins;
                chains.emplace_back();
            }
            Loop& chain = chains.back();
            if (step.forward)
                chain.insert(chain.end(), conics_.begin() + static_cast<std::ptrdiff_t>(run.first),
                             conics_.begin() + static_cast<std::ptrdiff_t>(run.last));
            else
                for (std::size_t c = run.last; c-- > run.first;)
                    chain.push_back(conics_[c].reversed());
            continues = step.forward ? run.ends_at_vertex : run.begins_at_vertex;
        }
    }
    if (continues && first_begins_at_vertex && joins(chains.back(), chains.front().front().from)) {
        if (chains.size() == 1) {
            whole.push_back(std::move(chains.front()));
            chains.clear();
        } else {
            chains.back().insert(chains.back().end(), chains.front().begin(), chains.front().end());
            chains.erase(chains.begin());
        }
    }
    // Where an edge passes by a corner of the box, rounding may leave a speck of it inside.
    std::erase_if(chains, [this](const Loop& chain) { return is_speck(chain); });
    // What ends inside by rounding ends at the border.
    for (Loop& chain : chains) {
        const auto line = [](Point from, Point to) { return in_ieee::straight(from, to); };
        if (contains(chain.front().from))
            chain.insert(chain.begin(), line(on_border(chain.front().from), chain.front().from));
        if (contains(chain.back().to))
            chain.push_back(line(chain.back().to, on_border(chain.back().to)));
    }
    return chains;
}

CellShape ClippedVoronoi::cell(Index site) const {
    const exact::IeeeEnvironment environment;
    CellShape shape;
    shape.site = site;
    shape.unbounded = voronoi_.is_unbounded(site);
    shape.in_box = is_bounded_;
    if (!is_bounded_ && shape.unbounded) return shape;
    std::vector<Loop> chains = open_chains(site, shape.loops);
    if (!chains.empty()) {
        shape.clipped = true;
        shape.loops = tiling(std::move(chains), site);
    }
    // A cell without an edge in the box, or with mere spikes, has all of it or nothing.
    if (shape.loops.empty() && is_bounded_ && site == at_point_) {
        shape.clipped = true;
        const Point corner = {box_.x0, box_.y0};
        Loop& border = shape.loops.emplace_back(Loop{in_ieee::straight(corner, corner)});
        follow_border(border, corner, true);
        border.erase(border.begin());
    }
    for (Loop& loop : shape.loops)
        for (Conic& conic : loop) conic = scaled(conic, exponent_);
    return shape;
}

std::vector<Measure> measures(const ClippedVoronoi& clipped, int threads) {
    const std::size_t sites = clipped.voronoi().tessellation().sites().size();
    const Workers workers(threads, sites);
    std::vector<Measure> result;
    make_room(workers, sites, result);
    workers.each_range(sites, [&](std::size_t begin, std::size_t end) {
        for (std::size_t s = begin; s < end; ++s)
            result[s] = measure(clipped.cell(static_cast<Index>(s)));
    });
    return result;
}

}  // namespace signum
