/// The files of a diagram, read back by a JSON parser, against the diagram.

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "../../tool/draw/svg.hpp"
#include "../../tool/generate/generate.hpp"
#include "../../tool/io/write_voronoi.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../../voronoi/polygon.hpp"
#include "../by_metric.hpp"

namespace signum {
namespace {

using nlohmann::json;

constexpr Box box = {-50, -50, 750, 750};

class VoronoiFiles : public testing::TestWithParam<Metric> {
 protected:
    Voronoi diagram{triangulate(
        generate(Distribution::random, {.count = 60, .radius_to = 60, .seed = 6}), GetParam())};

    json read_json(const Box& clip) {
        std::ostringstream out;
        write_voronoi_json(out, ClippedVoronoi(diagram, clip), clip);
        return json::parse(out.str());
    }
    json read_geojson(double tolerance) {
        std::ostringstream out;
        write_voronoi_geojson(out, ClippedVoronoi(diagram, box), box, tolerance);
        return json::parse(out.str());
    }
};

Point point_of(const json& value) {
    return {value[0].get<double>(), value[1].get<double>()};
}

TEST_P(VoronoiFiles, JsonSaysEverything) {
    const json whole = read_json(no_box);
    EXPECT_EQ(whole["format"], "signum.voronoi");
    EXPECT_EQ(whole["version"], 1);
    EXPECT_EQ(whole["metric"], name_of(GetParam()));
    EXPECT_EQ(whole["sites"], 60);
    EXPECT_TRUE(whole["clip"].is_null());
    ASSERT_EQ(whole["vertices"].size(), diagram.vertices().size());
    for (std::size_t v = 0; v < diagram.vertices().size(); ++v) {
        EXPECT_EQ(whole["vertices"][v][0], diagram.vertices()[v].x);
        EXPECT_EQ(whole["vertices"][v][2], diagram.vertices()[v].rho);
    }
    ASSERT_EQ(whole["edges"].size(), diagram.edges().size());
    for (std::size_t e = 0; e < diagram.edges().size(); ++e) {
        const json& edge = whole["edges"][e];
        EXPECT_EQ(edge["sites"], (json{diagram.edges()[e].left, diagram.edges()[e].right}));
        EXPECT_EQ(edge["vertices"], (json{diagram.edges()[e].from, diagram.edges()[e].to}));
        const json& curve = edge["curve"];
        const std::string kind = edge["kind"];
        if (kind == "point") {
            EXPECT_TRUE(curve.is_null());
        } else if (kind == "hyperbola") {
            // Its own points lie at both ends.
            const auto at = [&](double t) -> Point {
                const Point m = point_of(curve["middle"]);
                const Point f = point_of(curve["forward"]);
                const Point u = point_of(curve["upward"]);
                const double c = curve["a"].get<double>() * std::cosh(t);
                const double s = curve["b"].get<double>() * std::sinh(t);
                return {m.x + c * f.x + s * u.x, m.y + c * f.y + s * u.y};
            };
            for (const auto& [name, end] :
                 {std::pair{"from", diagram.edges()[e].from}, {"to", diagram.edges()[e].to}}) {
                EXPECT_EQ(curve[name].is_null(), end == at_infinity);
                if (end == at_infinity) continue;
                const Point p = at(curve[name].get<double>());
                EXPECT_NEAR(p.x, diagram.vertices()[static_cast<std::size_t>(end)].x, 1e-8);
                EXPECT_NEAR(p.y, diagram.vertices()[static_cast<std::size_t>(end)].y, 1e-8);
            }
        } else {
            EXPECT_EQ(curve["before"].is_null(), diagram.edges()[e].from != at_infinity);
            EXPECT_EQ(curve["after"].is_null(), diagram.edges()[e].to != at_infinity);
            EXPECT_GE(curve["points"].size(), 1U);
        }
    }
    const json cut = read_json(box);
    EXPECT_EQ(cut["clip"], (json{box.x0, box.y0, box.x1, box.y1}));
    double area = 0;
    ASSERT_EQ(cut["cells"].size(), 60 - diagram.tessellation().hidden().size());
    for (std::size_t c = 0; c < cut["cells"].size(); ++c) {
        area += cut["cells"][c]["area"].get<double>();
        const json& cell = whole["cells"][c];
        EXPECT_EQ(cell["unbounded"], cell["area"].is_null());
        EXPECT_EQ(cell["unbounded"], diagram.is_unbounded(cell["site"]));
        EXPECT_FALSE(cell["clipped"]);
        EXPECT_EQ(cell["edges"].size(), diagram.cell(cell["site"]).size());
    }
    EXPECT_NEAR(area, 640000, 1e-6);
}

TEST_P(VoronoiFiles, RaysRunAlongTheBisector) {
    const json whole = read_json(no_box);
    int rays = 0;
    for (const json& edge : whole["edges"]) {
        if (!edge["curve"].contains("points")) continue;
        for (const auto& [name, index] : {std::pair{"before", 0}, {"after", -1}}) {
            if (edge["curve"][name].is_null()) continue;
            const json& points = edge["curve"]["points"];
            const Point start = point_of(index == 0 ? points.front() : points.back());
            const Point direction = point_of(edge["curve"][name]);
            const Point p = {start.x + 100 * direction.x, start.y + 100 * direction.y};
            const auto distance = [&](Index i) {
                const Site& s = diagram.tessellation().sites()[static_cast<std::size_t>(i)];
                const double x = std::abs(p.x - s.x);
                const double y = std::abs(p.y - s.y);
                const double length = by_metric::length_or_square(GetParam(), x, y);
                return GetParam() == Metric::power       ? length - s.r * s.r
                       : GetParam() == Metric::euclidean ? std::sqrt(length) - s.r
                                                         : length - s.r;
            };
            EXPECT_NEAR(distance(edge["sites"][0]), distance(edge["sites"][1]), 1e-7);
            ++rays;
        }
    }
    EXPECT_EQ(rays > 0, GetParam() != Metric::euclidean);
}

TEST_P(VoronoiFiles, GeoJsonPolygonsAreClosed) {
    const json collection = read_geojson(0.5);
    EXPECT_EQ(collection["type"], "FeatureCollection");
    EXPECT_EQ(collection["bbox"], (json{box.x0, box.y0, box.x1, box.y1}));
    std::size_t points = 0;
    double area = 0;
    for (const json& feature : collection["features"]) {
        EXPECT_EQ(feature["type"], "Feature");
        EXPECT_EQ(feature["id"], feature["properties"]["site"]);
        const json& geometry = feature["geometry"];
        json polygons = geometry["coordinates"];
        if (geometry["type"] == "Polygon")
            polygons = json::array({polygons});
        else
            EXPECT_EQ(geometry["type"], "MultiPolygon");
        for (const json& polygon : polygons) {
            ASSERT_EQ(polygon.size(), 1U);
            const json& ring = polygon[0];
            ASSERT_GE(ring.size(), 4U);
            EXPECT_EQ(ring.front(), ring.back());
            points += ring.size();
            double twice = 0;
            for (std::size_t i = 1; i < ring.size(); ++i) {
                const Point a = point_of(ring[i - 1]);
                const Point b = point_of(ring[i]);
                twice += a.x * b.y - b.x * a.y;
            }
            EXPECT_GT(twice, 0);  // counterclockwise
            area += twice / 2;
        }
        EXPECT_EQ(feature["properties"]["neighbours"].size(),
                  diagram.cell(feature["properties"]["site"]).size());
    }
    EXPECT_NEAR(area, 640000, 1e-6);
    if (GetParam() == Metric::euclidean) {
        std::size_t fine = 0;
        const json finer = read_geojson(0.005);
        for (const json& feature : finer["features"])
            fine += feature["geometry"]["coordinates"][0].size();
        EXPECT_GT(fine, 3 * points);
    }
}

TEST_P(VoronoiFiles, TableHasACellALine) {
    std::ostringstream out;
    write_voronoi_csv(out, ClippedVoronoi(diagram, box), 0.5);
    std::istringstream in(out.str());
    std::string line;
    std::getline(in, line);
    EXPECT_EQ(line,
              "site,x,y,radius,unbounded,clipped,area,perimeter,centroid_x,centroid_y,neighbours,"
              "WKT");
    std::size_t lines = 0;
    double area = 0;
    while (std::getline(in, line)) {
        ++lines;
        std::vector<std::string> fields;
        std::istringstream row(line.substr(0, line.find('"')));
        for (std::string field; std::getline(row, field, ',');) fields.push_back(field);
        ASSERT_EQ(fields.size(), 11U) << line;
        area += std::stod(fields[6]);
        const std::string polygon = line.substr(line.find('"'));
        EXPECT_TRUE(polygon.starts_with("\"POLYGON ((") ||
                    polygon.starts_with("\"MULTIPOLYGON (((") || polygon == "\"POLYGON EMPTY\"")
            << polygon;
        EXPECT_TRUE(polygon.ends_with("\""));
    }
    EXPECT_EQ(lines, 60 - diagram.tessellation().hidden().size());
    EXPECT_NEAR(area, 640000, 1e-6);
}

TEST_P(VoronoiFiles, NeighboursHaveDifferentTints) {
    for (const std::int64_t count : {1, 2, 7, 3000}) {
        const Voronoi many(triangulate(
            generate(Distribution::random, {.count = count, .radius_to = 20, .seed = 9}),
            GetParam()));
        std::ostringstream out;
        write_voronoi_svg(out, many);
        const std::string svg = out.str();
        std::vector<char> tint(static_cast<std::size_t>(count), ' ');
        for (auto at = svg.find("tint tint"); at != svg.npos; at = svg.find("tint tint", at + 1)) {
            const auto title = svg.find("<title>", at) + 7;
            tint[std::stoul(svg.substr(title, 12))] = svg[at + 9];
        }
        int compared = 0;
        for (const VoronoiEdge& edge : many.edges()) {
            const char left = tint[static_cast<std::size_t>(edge.left)];
            if (left == ' ' || tint[static_cast<std::size_t>(edge.right)] == ' ') continue;
            EXPECT_NE(left, tint[static_cast<std::size_t>(edge.right)]);
            ++compared;
        }
        EXPECT_GE(compared, 2 * (static_cast<int>(many.edges().size()) - 2) / 3);
    }
}

TEST_P(VoronoiFiles, PicturesHaveACellForEachSite) {
    std::ostringstream out;
    write_voronoi_svg(out, diagram);
    const std::string svg = out.str();
    std::size_t cells = 0;
    for (auto at = svg.find("class=\"tint "); at != svg.npos;
         at = svg.find("class=\"tint ", at + 1))
        ++cells;
    EXPECT_EQ(cells, 60 - diagram.tessellation().hidden().size());
    EXPECT_EQ(svg.find("nan"), svg.npos);
    EXPECT_EQ(svg.find("inf"), svg.npos);
    EXPECT_EQ(svg.find('Q') != svg.npos, GetParam() == Metric::euclidean);
    std::ostringstream part;
    write_voronoi_svg(part, diagram, Box{100, 100, 300, 200});
    EXPECT_NE(part.str().find("viewBox=\"0 0 900 5"), std::string::npos);  // 450, axis and legend
    std::ostringstream again;
    write_voronoi_svg(again, diagram);
    EXPECT_EQ(again.str(), svg);
}

INSTANTIATE_TEST_SUITE_P(Metrics, VoronoiFiles, testing::ValuesIn(all_metrics),
                         [](const auto& info) { return std::string(name_of(info.param)); });

}  // namespace
}  // namespace signum
