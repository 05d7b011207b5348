#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "../../voronoi/polygon.hpp"
#include "text_writer.hpp"
#include "write_tessellation.hpp"
#include "write_voronoi.hpp"

namespace signum {
namespace {

std::string pair_of(Point p) {
    return fmt::format(FMT_COMPILE("[{}, {}]"), number_or_null(p.x), number_or_null(p.y));
}

std::string bounds_of(const Box& box) {
    return fmt::format(FMT_COMPILE("[{}, {}, {}, {}]"), box.x0, box.y0, box.x1, box.y1);
}

const Site& site_of(const Voronoi& voronoi, Index site) {
    return voronoi.tessellation().sites()[static_cast<std::size_t>(site)];
}

/// The visible sites, in order.
std::vector<Index> visible_sites(const Voronoi& voronoi) {
    std::vector<Index> result;
    for (Index site = 0; site < static_cast<Index>(voronoi.tessellation().sites().size()); ++site)
        if (!voronoi.is_hidden(site)) result.push_back(site);
    return result;
}

std::vector<Index> edges_of(const Voronoi& voronoi, Index site) {
    std::vector<Index> result;
    for (const VoronoiStep& step : voronoi.cell(site)) result.push_back(step.edge);
    return result;
}

/// The sites across the edges of a cell, counterclockwise; as often as they share an edge.
std::vector<Index> neighbours_of(const Voronoi& voronoi, Index site) {
    std::vector<Index> result;
    for (const VoronoiStep& step : voronoi.cell(site)) {
        const VoronoiEdge& edge = voronoi.edges()[static_cast<std::size_t>(step.edge)];
        result.push_back(step.forward ? edge.right : edge.left);
    }
    return result;
}

/// A straight edge: its points, and the directions in which it runs on where it does not end.
std::string straight_curve(const EdgeGeometry& edge, const StraightCurve& curve, int exponent) {
    const auto in_plane = [exponent](Point p) -> Point {
        return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
    };
    const bool begins = std::isfinite(edge.from);
    const bool ends = std::isfinite(edge.to);
    std::vector<std::string> points;
    if (begins) points.push_back(pair_of(in_plane(edge.start)));
    if (edge.kind == EdgeKind::polyline)
        for (const double knot : curve.knots)
            if (edge.from < knot && knot < edge.to)
                points.push_back(pair_of(in_plane(curve.at(knot))));
    if (ends) points.push_back(pair_of(in_plane(edge.end)));
    if (points.empty()) points.push_back(pair_of(in_plane(curve.at(0))));
    const auto direction = [&](double sign) {
        const double slope = curve.slopes[sign > 0 ? 1 : 0];
        return pair_of({sign * curve.upward.x + slope * curve.right.x,
                        sign * curve.upward.y + slope * curve.right.y});
    };
    return fmt::format(FMT_COMPILE(R"({{"points": [{}], "before": {}, "after": {}}})"),
                       fmt::join(points, ", "), begins ? "null" : direction(-1),
                       ends ? "null" : direction(1));
}

std::string hyperbola_curve(const EdgeGeometry& edge, const HyperbolaCurve& curve, int exponent) {
    return fmt::format(
        FMT_COMPILE(R"({{"middle": {}, "forward": {}, "upward": {}, "a": {}, "b": {}, )"
                    R"("from": {}, "to": {}}})"),
        pair_of({std::ldexp(curve.middle.x, exponent), std::ldexp(curve.middle.y, exponent)}),
        pair_of(curve.forward), pair_of(curve.upward),
        number_or_null(std::ldexp(curve.a, exponent)),
        number_or_null(std::ldexp(curve.b, exponent)), number_or_null(edge.from),
        number_or_null(edge.to));
}

std::string curve_of(const EdgeGeometry& edge, int exponent) {
    if (edge.kind == EdgeKind::point) return "null";
    if (const auto* straight = std::get_if<StraightCurve>(&edge.curve))
        return straight_curve(edge, *straight, exponent);
    return hyperbola_curve(edge, std::get<HyperbolaCurve>(edge.curve), exponent);
}

void put_edges(TextWriter& text, const Voronoi& voronoi) {
    text.put_long_array(
        "edges", voronoi.edges().size(), [&](TextWriter& piece, std::size_t number) {
            const VoronoiEdge& edge = voronoi.edges()[number];
            const auto geometry = voronoi.geometry(static_cast<Index>(number));
            piece.put(FMT_COMPILE(R"({{"sites": [{}, {}], "vertices": [{}, {}], "kind": "{}", )"
                                  R"("curve": {}}})"),
                      edge.left, edge.right, edge.from, edge.to,
                      geometry ? name_of(geometry->kind) : "point",
                      geometry ? curve_of(*geometry, voronoi.exponent()) : "null");
        });
}

std::string measures_of(const CellShape& shape) {
    const Measure of = measure(shape);
    return fmt::format(
        FMT_COMPILE(R"("area": {}, "perimeter": {}, "centroid": {})"), number_or_null(of.area),
        number_or_null(of.perimeter),
        std::isfinite(of.centroid.x + of.centroid.y) ? pair_of(of.centroid) : "null");
}

/// [[[x, y], ...]] for each polygon, closed; separated by commas.
std::string rings_of(const std::vector<std::vector<Point>>& polygons) {
    std::string result;
    for (const auto& polygon : polygons) {
        result += result.empty() ? "[[" : ", [[";
        for (const Point& p : polygon) result += pair_of(p) + ", ";
        result += pair_of(polygon.front()) + "]]";
    }
    return result;
}

/// Names of attributes beside those that a table or a feature has already, each once.
std::vector<std::string> names_beside(const std::vector<std::string>& taken,
                                      std::span<const Attribute> attributes) {
    std::set<std::string> all(taken.begin(), taken.end());
    std::map<std::string, int> numbers;  // where a header has a name many times
    std::vector<std::string> names;
    for (const Attribute& attribute : attributes) {
        std::string name = attribute.name;
        while (!all.insert(name).second) {
            const int number = ++numbers[attribute.name];
            name = "input_" + attribute.name + (number > 1 ? "_" + std::to_string(number) : "");
        }
        names.push_back(std::move(name));
    }
    return names;
}

std::string json_string(const std::string& text) {
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string json_value(const Attribute& attribute, std::size_t site) {
    const std::string& value = attribute.values.at(site);
    if (attribute.is_number) return value.empty() ? "null" : value;
    return json_string(value);
}

/// In quotes where it has to be.
std::string csv_value(std::string_view text) {
    if (text.find_first_of(",;#\"\t ") == std::string_view::npos) return std::string(text);
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
    return result + '"';
}

/// MULTIPOLYGON, or POLYGON where there is one.
std::string well_known_text(const std::vector<std::vector<Point>>& polygons) {
    if (polygons.empty()) return "POLYGON EMPTY";
    std::string rings;
    for (const auto& polygon : polygons) {
        rings += rings.empty() ? "((" : ", ((";
        for (const Point& p : polygon) rings += fmt::format(FMT_COMPILE("{} {}, "), p.x, p.y);
        rings += fmt::format(FMT_COMPILE("{} {}))"), polygon.front().x, polygon.front().y);
    }
    return polygons.size() == 1 ? "POLYGON " + rings : "MULTIPOLYGON (" + rings + ")";
}

}  // namespace

void write_voronoi_json(std::ostream& out, const ClippedVoronoi& diagram, const Box& box) {
    const Voronoi& voronoi = diagram.voronoi();
    const Tessellation& tessellation = voronoi.tessellation();
    TextWriter text(out);
    text.put(FMT_COMPILE(R"({{"format": "signum.voronoi", "version": 1, "metric": "{}", )"
                         R"("weight_is": "{}", "sites": {}, "clip": {})"),
             name_of(tessellation.metric()), name_of(tessellation.weight_is()),
             tessellation.arrays().sites, box == no_box ? "null" : bounds_of(box));
    text.put_long_array("vertices", voronoi.vertices().size(),
                        [&](TextWriter& piece, std::size_t number) {
                            const DiagramVertex& v = voronoi.vertices()[number];
                            piece.put(FMT_COMPILE("[{}, {}, {}]"), JsonNumber{v.x}, JsonNumber{v.y},
                                      number_or_null(v.rho));
                        });
    put_edges(text, voronoi);
    const std::vector<Index> visible = visible_sites(voronoi);
    text.put_long_array("cells", visible.size(), [&](TextWriter& piece, std::size_t number) {
        const Index site = visible[number];
        const CellShape shape = diagram.cell(site);
        piece.put(
            FMT_COMPILE(R"({{"site": {}, "edges": [{}], "unbounded": {}, "clipped": {}, {}}})"),
            site, fmt::join(edges_of(voronoi, site), ", "), shape.unbounded, shape.clipped,
            measures_of(shape));
    });
    put_hidden(text, tessellation.hidden());
    text.put("}\n");
    text.flush();
}

void write_voronoi_geojson(std::ostream& out, const ClippedVoronoi& diagram, const Box& box,
                           double tolerance, std::span<const Attribute> attributes) {
    const Voronoi& voronoi = diagram.voronoi();
    const std::vector<std::string> names =
        names_beside({"site", "x", "y", std::string(name_of(voronoi.tessellation().weight_is())),
                      "unbounded", "clipped", "area", "perimeter", "centroid", "neighbours"},
                     attributes);
    const auto told_of = [&](Index site) {
        std::string told;
        for (std::size_t i = 0; i < names.size(); ++i)
            told += fmt::format(FMT_COMPILE(", {}: {}"), json_string(names[i]),
                                json_value(attributes[i], static_cast<std::size_t>(site)));
        return told;
    };
    TextWriter text(out);
    text.put(FMT_COMPILE(R"({{"type": "FeatureCollection", "bbox": {})"), bounds_of(box));
    const std::vector<Index> visible = visible_sites(voronoi);
    text.put_long_array("features", visible.size(), [&](TextWriter& piece, std::size_t number) {
        const Index site = visible[number];
        const CellShape shape = diagram.cell(site);
        const auto rings = polygons(shape, tolerance);
        const Site& at = site_of(voronoi, site);
        std::string geometry = "null";
        if (rings.size() == 1)  // the outer brackets are those of the only polygon
            geometry = fmt::format(R"({{"type": "Polygon", "coordinates": {}}})", rings_of(rings));
        else if (rings.size() > 1)
            geometry =
                fmt::format(R"({{"type": "MultiPolygon", "coordinates": [{}]}})", rings_of(rings));
        piece.put(
            FMT_COMPILE(R"({{"type": "Feature", "id": {0}, "properties": {{"site": {0}, )"
                        R"("x": {1}, "y": {2}, "{3}": {4}, "unbounded": {5}, "clipped": {6}, )"
                        R"({7}, "neighbours": [{8}]{9}}}, "geometry": {10}}})"),
            site, at.x, at.y, name_of(voronoi.tessellation().weight_is()), at.r, shape.unbounded,
            shape.clipped, measures_of(shape), fmt::join(neighbours_of(voronoi, site), ", "),
            told_of(site), geometry);
    });
    text.put("}\n");
    text.flush();
}

void write_voronoi_csv(std::ostream& out, const ClippedVoronoi& diagram, double tolerance,
                       std::span<const Attribute> attributes, const SiteNames& names) {
    const Voronoi& voronoi = diagram.voronoi();
    const std::vector<std::string> own = {
        "site",       "x",
        "y",          std::string(name_of(voronoi.tessellation().weight_is())),
        "unbounded",  "clipped",
        "area",       "perimeter",
        "centroid_x", "centroid_y",
        "neighbours"};
    std::vector<std::string> taken = own;
    taken.emplace_back("WKT");
    TextWriter text(out);
    text.put(FMT_COMPILE("{}"), fmt::join(own, ","));
    for (const std::string& name : names_beside(taken, attributes))
        text.put(FMT_COMPILE(",{}"), csv_value(name));
    text.put(",WKT\n");
    std::vector<Index> visible = visible_sites(voronoi);
    std::erase_if(visible, [&](Index site) { return !names.is_written(site); });
    text.put_entries(visible.size(), [&](TextWriter& piece, std::size_t number) {
        const Index site = visible[number];
        const CellShape shape = diagram.cell(site);
        const Measure of = measure(shape);
        const Site& at = site_of(voronoi, site);
        std::vector<std::int64_t> neighbours;
        for (const Index each : neighbours_of(voronoi, site))
            neighbours.push_back(names.number(each));
        piece.put(FMT_COMPILE("{},{},{},{},{},{},{},{},{},{},{}"), names.number(site), at.x, at.y,
                  at.r, shape.unbounded, shape.clipped, number_or_blank(of.area),
                  number_or_blank(of.perimeter), number_or_blank(of.centroid.x),
                  number_or_blank(of.centroid.y), fmt::join(neighbours, " "));
        for (const Attribute& attribute : attributes)
            piece.put(FMT_COMPILE(",{}"),
                      csv_value(attribute.values.at(static_cast<std::size_t>(site))));
        piece.put(FMT_COMPILE(",\"{}\"\n"), well_known_text(polygons(shape, tolerance)));
    });
    text.flush();
}

void write_voronoi_wkt(std::ostream& out, const ClippedVoronoi& diagram, double tolerance) {
    const std::size_t sites = diagram.voronoi().tessellation().sites().size();
    TextWriter text(out);
    text.put_entries(sites, [&](TextWriter& piece, std::size_t site) {
        piece.put(FMT_COMPILE("{}\n"),
                  well_known_text(polygons(diagram.cell(static_cast<Index>(site)), tolerance)));
    });
    text.flush();
}

VtkGrid vtk_grid(const ClippedVoronoi& diagram, double tolerance, const SiteNames& names) {
    const Voronoi& voronoi = diagram.voronoi();
    const Tessellation& tessellation = voronoi.tessellation();
    VtkGrid grid;
    grid.title = fmt::format("signum: {} cells", name_of(tessellation.metric()));
    grid.of_cells = {{"site", true, {}},
                     {std::string(name_of(tessellation.weight_is())), false, {}},
                     {"area", false, {}}};
    for (const Index site : visible_sites(voronoi)) {
        if (!names.is_written(site)) continue;
        const CellShape shape = diagram.cell(site);
        const double area = measure(shape).area;
        for (const auto& polygon : polygons(shape, tolerance)) {
            std::vector<std::int64_t> corners(polygon.size());
            std::iota(corners.begin(), corners.end(),
                      static_cast<std::int64_t>(grid.points.size()));
            for (const Point& p : polygon) grid.points.push_back({p.x, p.y, 0.0});
            grid.add_cell(VtkCell::polygon, corners);
            grid.of_cells[0].values.push_back(static_cast<double>(names.number(site)));
            grid.of_cells[1].values.push_back(site_of(voronoi, site).r);
            grid.of_cells[2].values.push_back(area);
        }
    }
    return grid;
}

}  // namespace signum
