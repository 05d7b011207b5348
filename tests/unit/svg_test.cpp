/// Pictures: well-formed, of every site, the same bytes twice, without a number that a browser
/// cannot draw, and bounded however many sites there are. The cells are checked against their
/// definition.

#include "../../tool/draw/svg.hpp"
#include "../../tool/draw/frame.hpp"
#include "../../tool/draw/lines.hpp"
#include "../../tool/draw/shapes.hpp"
#include "../../tool/draw/lines.hpp"
#include "../../tool/generate/generate.hpp"
#include "../../triangulation/triangulate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <random>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using namespace signum;

std::string drawn(const Tessellation& tessellation, const SvgOptions& options = {}) {
    std::ostringstream out;
    write_svg(out, tessellation, options);
    return out.str();
}
std::string drawn(StridedSites sites, const SvgOptions& options = {}) {
    return drawn(triangulate(sites, Power{}), options);
}

/// Two sites of the Euclidean metric, or three whose faces are given with all neighbours.
Tessellation euclidean(std::vector<Site> sites, std::vector<Face> faces = {{-1, 0, 1}, {-1, 1, 0}},
                       std::vector<Face> neighbours = {{1, 1, 1}, {0, 0, 0}}) {
    TessellationArrays arrays;
    arrays.metric = Metric::euclidean;
    arrays.sites = static_cast<std::int64_t>(sites.size());
    arrays.faces = std::move(faces);
    arrays.neighbours = std::move(neighbours);
    return {std::move(arrays), std::move(sites), {}};
}

std::vector<Site> random_sites(std::size_t count, double extent, double largest_radius) {
    std::mt19937_64 random(7);
    const auto uniform = [&](double end) {
        return end * static_cast<double>(random() >> 11) * 0x1p-53;
    };
    std::vector<Site> sites(count);
    for (Site& site : sites) site = {uniform(extent), uniform(extent), uniform(largest_radius)};
    return sites;
}

/// A few sites of every kind: apart, nested, touching, a dot.
std::vector<Site> few_sites(double scale) {
    std::vector<Site> sites = {{0, 0, 3}, {1, 0, 1}, {9, 2, 2}, {6, 8, 1}, {2, 7, 0}, {4, 2, 1.5}};
    for (Site& site : sites) site = {site.x * scale, site.y * scale, site.r * scale};
    return sites;
}

std::size_t count(std::string_view text, std::string_view part) {
    std::size_t found = 0;
    for (auto at = text.find(part); at != text.npos; at = text.find(part, at + part.size()))
        ++found;
    return found;
}

/// How many sites are drawn with a number of their own.
std::size_t numbered(std::string_view svg, std::string_view kind,
                     std::string_view element = "circle") {
    std::size_t found = 0;
    const std::string start = "<" + std::string(element) + " class=\"" + std::string(kind) + "\"";
    for (auto at = svg.find(start); at != svg.npos; at = svg.find(start, at + 1))
        found += svg.substr(svg.find('>', at)).starts_with("><title>");
    return found;
}

/// Lines of one kind, the sample in the legend aside.
std::size_t lines(std::string_view svg, std::string_view kind) {
    std::size_t found = 0;
    const std::string start = "<path class=\"" + std::string(kind) + "\" d=\"";
    for (auto at = svg.find(start); at != svg.npos; at = svg.find(start, at + 1)) {
        const auto begin = at + start.size();
        found += count(svg.substr(begin, svg.find('"', begin) - begin), "L");
    }
    return found;
}

/// What lies in the frame, without axes and legend.
std::string picture(const std::string& svg) {
    const auto begin = svg.find("<g clip-path");
    return svg.substr(begin, svg.find("<g class=\"axes\"") - begin);
}

/// The words of the legend, rows joined by blanks.
std::string legend(const std::string& svg) {
    std::string words;
    for (auto at = svg.find("<text", svg.find("<g class=\"legend\"")); at != svg.npos;
         at = svg.find("<text", at + 1)) {
        const auto begin = svg.find('>', at) + 1;
        words += svg.substr(begin, svg.find('<', begin) - begin) + " ";
    }
    return words;
}

/// The numbers along an axis, `x` or `y`, and where they stand, with ticks there.
std::vector<std::pair<std::string, double>> ticks(const std::string& svg, char axis) {
    const auto axes = svg.find("<g class=\"axes\"");
    const auto group =
        svg.find(axis == 'x' ? "<g text-anchor=\"middle\"" : "<g text-anchor=\"end\"", axes);
    const std::string texts = svg.substr(group, svg.find("</g>", group) - group);
    std::vector<std::pair<std::string, double>> found;
    for (auto at = texts.find("<text"); at != texts.npos; at = texts.find("<text", at + 1)) {
        const auto begin = texts.find('>', at) + 1;
        const std::string number = texts.substr(begin, texts.find('<', begin) - begin);
        const std::string attribute = std::string(1, axis) + "=\"";
        const double place = std::stod(texts.substr(texts.find(attribute, at) + 3));
        if (number != "x" && number != "y")
            found.emplace_back(number, axis == 'x' ? place : place - 6);
    }
    return found;
}

/// The degrees of a colour of the style on the circle of hues.
double hue(const std::string& svg, const std::string& kind) {
    const auto rule = svg.find("." + kind);
    const auto colour = svg.find("stroke: #", rule) + 9;
    double rgb[3];
    for (std::size_t i = 0; i < 3; ++i)
        rgb[i] = std::stoi(svg.substr(colour + 2 * i, 2), nullptr, 16);
    return std::atan2(std::sqrt(3.0) * (rgb[1] - rgb[2]), 2 * rgb[0] - rgb[1] - rgb[2]) * 180 /
           3.141592653589793;
}

/// Empty when every element is closed by its own name and every attribute quoted, else what is not.
std::string malformed(std::string_view svg) {
    std::vector<std::string> open;
    while (!svg.empty()) {
        const auto start = svg.find('<');
        const std::string_view text = svg.substr(0, start);
        if (text.find('>') != text.npos || text.find('&') != text.npos) return std::string(text);
        if (start == svg.npos) break;
        const auto end = svg.find('>', start);
        if (end == svg.npos) return "an open tag";
        const std::string_view tag = svg.substr(start + 1, end - start - 1);
        svg.remove_prefix(end + 1);
        if (count(tag, "\"") % 2 != 0 || tag.find('<') != tag.npos) return std::string(tag);
        const bool closes = tag.starts_with('/');
        const bool is_empty = tag.ends_with('/');
        const std::string name(
            tag.substr(closes ? 1 : 0, tag.find_first_of(" /", 1) - (closes ? 1 : 0)));
        if (closes) {
            if (open.empty() || open.back() != name) return std::string(tag);
            open.pop_back();
        } else if (!is_empty) {
            open.push_back(name);
        }
    }
    return open.empty() ? "" : open.back();
}

/// The largest magnitude among the numbers in attributes; infinity when one is not finite.
double largest_number(const std::string& svg) {
    double largest = 0;
    bool quoted = false;
    for (const char* at = svg.c_str(); *at != '\0'; ++at) {
        if (*at == '"') quoted = !quoted;
        if (quoted && (std::strncmp(at, "nan", 3) == 0 || std::strncmp(at, "inf", 3) == 0))
            return INFINITY;
        if (!quoted || std::isalpha(static_cast<unsigned char>(*(at + 1))) != 0) continue;
        char* end = nullptr;
        const double value = std::strtod(at + 1, &end);
        if (end == at + 1) continue;
        largest = std::max(largest, std::abs(value));
        at = end - 1;
    }
    return largest;
}

void expect_drawable(const std::string& svg) {
    EXPECT_EQ(malformed(svg), "");
    EXPECT_LT(largest_number(svg), 5000.0);
    EXPECT_NE(svg.find("viewBox=\"0 0 900 "), svg.npos);
}

TEST(Svg, ScansForFaultsThatItIsToFind) {
    EXPECT_EQ(malformed("<a b=\"1\"><c/><d>text</d></a>\n"), "");
    EXPECT_NE(malformed("<a><c></a>"), "");
    EXPECT_NE(malformed("<a b=\"1></a>"), "");
    EXPECT_NE(malformed("<a>"), "");
    EXPECT_EQ(largest_number("<a b=\"M3 -12.5L4 7\">99</a>"), 12.5);
    EXPECT_EQ(largest_number("<a b=\"3 nan\">"), INFINITY);
}

TEST(Svg, DrawsEverySiteOnceAndHiddenOnesHatched) {
    const auto sites = random_sites(60, 100, 14);
    const auto tessellation = triangulate(sites, Power{});
    ASSERT_GT(tessellation.hidden().size(), 5U);
    const std::string svg = drawn(sites);
    expect_drawable(svg);
    EXPECT_EQ(numbered(svg, "hidden") + numbered(svg, "hidden-dot"), tessellation.hidden().size());
    EXPECT_EQ(numbered(svg, "site") + numbered(svg, "dot"),
              sites.size() - tessellation.hidden().size());
    EXPECT_EQ(count(svg, ", hidden by "), tessellation.hidden().size());
    EXPECT_EQ(count(svg, "<pattern id=\"hatch\""), 1U);
    EXPECT_NE(svg.find(".hidden { fill: url(#hatch)"), svg.npos);
    EXPECT_NE(svg.find("hidden sites: "), svg.npos);
    EXPECT_EQ(svg.find("left out"), svg.npos);
}

TEST(Svg, DrawsTheTessellation) {
    const auto sites = random_sites(40, 100, 1);
    const auto edges = triangulate(sites, Power{}).edges();
    const auto finite = std::ranges::count_if(edges, [](Edge edge) { return edge[0] != infinite; });
    EXPECT_EQ(lines(drawn(sites), "edge"), static_cast<std::size_t>(finite));
}

TEST(Svg, IsTheSameTwice) {
    const auto sites = random_sites(200, 100, 9);
    EXPECT_EQ(drawn(sites), drawn(sites));
}

TEST(Svg, OneSite) {
    const std::string disc = drawn(std::vector<Site>{{3, 4, 1}});
    expect_drawable(disc);
    EXPECT_EQ(numbered(disc, "site"), 1U);
    const std::string dot = drawn(std::vector<Site>{{3, 4, 0}});
    expect_drawable(dot);
    EXPECT_EQ(numbered(dot, "dot"), 1U);
}

TEST(Svg, TwoSitesAreSeparatedByOneLine) {
    const std::string svg = drawn(std::vector<Site>{{0, 0, 1}, {3, 1, 2}});
    expect_drawable(svg);
    EXPECT_EQ(lines(svg, "edge"), 1U);
    EXPECT_EQ(lines(svg, "cell"), 1U);
}

TEST(Svg, CollinearSitesAreSeparatedByParallels) {
    std::vector<Site> sites;
    for (int i = 0; i < 5; ++i) sites.push_back({1.0 * i, 2.0 * i, 0.1 * i});
    const std::string svg = drawn(sites);
    expect_drawable(svg);
    EXPECT_EQ(lines(svg, "edge"), 4U);
    EXPECT_EQ(lines(svg, "cell"), 4U);
}

TEST(Svg, EqualSites) {
    const std::string svg = drawn(std::vector<Site>(4, {1, 1, 1}));
    expect_drawable(svg);
    EXPECT_EQ(numbered(svg, "hidden"), 3U);
}

TEST(Svg, ScaleDoesNotMatter) {
    const std::string svg = drawn(few_sites(1));
    expect_drawable(svg);
    for (const double scale : {0x1p990, 0x1p-990, 0x1p-1060})
        EXPECT_EQ(picture(drawn(few_sites(scale))), picture(svg)) << scale;
    expect_drawable(drawn(few_sites(1e300)));
    expect_drawable(drawn(few_sites(1e-300)));
    expect_drawable(drawn(few_sites(0x1p-1074)));
}

TEST(Svg, ExtremesOfADouble) {
    constexpr double most = 1.7976931348623157e308;
    expect_drawable(drawn(std::vector<Site>{{-most, 0, most}, {most, most, 0}, {0, -most, most}}));
    expect_drawable(drawn(std::vector<Site>{{0, 0, 0}, {1, 5e-324, 0}, {1e-200, 0, 0}}));
    expect_drawable(drawn(std::vector<Site>{{1e300, 0, 1}, {1e300, 1, 1e-300}, {0, 0, 2}}));
    expect_drawable(drawn(std::vector<power::Site>{{0, 0, -most}, {1, 0, most}, {0, 1, -most}}));
}

TEST(Svg, AlmostCollinearSitesHaveTheirVerticesFarAway) {
    std::vector<Site> sites;
    for (int i = 0; i < 10; ++i) sites.push_back({1e300 * i, 1e285 * i * i, 0});
    const std::string svg = drawn(sites);
    expect_drawable(svg);
    EXPECT_EQ(lines(svg, "cell"), 9U);  // those of the other ten edges are beyond all doubles
}

TEST(Svg, ShowsABoxAndCutsEdgesThere) {
    const std::vector<Site> sites = {{0, 0, 1}, {1e6, 1e6, 2}, {0, 1e6, 1}, {5, 1, 1}};
    const std::string svg = drawn(sites, {.box = Box{-2, -2, 8, 6}});
    expect_drawable(svg);
    // Two sites lie outside of it; the edge between them passes it by.
    EXPECT_EQ(lines(svg, "edge"), 4U);
    EXPECT_EQ(numbered(svg, "site"), 2U);
    expect_drawable(drawn(few_sites(1e300), {.box = Box{0, 0, 1e160, 1e160}}));
}

/// A planet, of which the box shows a stretch of the rim.
TEST(Svg, ShowsTheSitesThatReachIntoABox) {
    const std::vector<Site> sites = {{0, 0, 1e6}, {1'000'001, 0, 1}, {1'000'002, -5, 2}, {0, 5, 3}};
    const Box box = {999'990, -10, 1'000'010, 10};
    for (const Metric metric : all_metrics) {
        const std::string svg = drawn(triangulate(sites, metric), {.box = box});
        expect_drawable(svg);
        EXPECT_EQ(count(svg, "<path class=\"site\" d=\"M"), 1U);
        EXPECT_EQ(count(svg, "<title>0</title>"), 1U);
        EXPECT_NE(legend(svg).find("visible sites: 3"), svg.npos);
    }
}

TEST(Svg, PartsOfLargeOutlinesAreThoseNearTheCentre) {
    std::mt19937_64 random(5);
    const auto uniform = [&](double from, double to) {
        return from + (to - from) * static_cast<double>(random() >> 11) * 0x1p-53;
    };
    const Box box = {-20, -20, 920, 620};
    const double diagonal = std::hypot(940.0, 640.0);
    for (const Outline& outline : {disc_outline(), square_outline(), diamond_outline()})
        for (int round = 0; round < 60; ++round) {
            const double radius = diagonal * std::pow(10, uniform(0.61, 6));
            // On the outline somewhere in the box, mostly.
            const double angle = uniform(0, 6.3);
            const Point to = {std::cos(angle), std::sin(angle)};
            const double away = radius / outline.norm(to);
            const Point centre = {uniform(-200, 1100) - away * to.x,
                                  uniform(-200, 800) - away * to.y};
            const auto part = part_inside(outline, centre, radius, box);
            const auto depth = [&](Point p) {  // in the polygon, which is convex
                double least = part.empty() ? -1 : 1e9;
                for (std::size_t i = 0; i < part.size(); ++i) {
                    const Point a = part[i];
                    const Point b = part[(i + 1) % part.size()];
                    const double length = std::hypot(b.x - a.x, b.y - a.y);
                    if (length < 1e-9) continue;
                    least = std::min(
                        least, ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / length);
                }
                return least;
            };
            for (int i = 0; i < 200; ++i) {
                const Point p = {uniform(-20, 920), uniform(-20, 620)};
                const double inside = radius - outline.norm({p.x - centre.x, p.y - centre.y});
                EXPECT_TRUE(std::abs(inside) < 0.2 || (depth(p) > 0) == (inside > 0)) << radius;
            }
        }
}

TEST(Svg, NumbersTheSitesOfASmallSet) {
    const auto sites = random_sites(60, 100, 9);
    const auto tessellation = triangulate(sites, Power{});
    const std::string svg = drawn(tessellation);
    EXPECT_EQ(count(svg, "<text class=\"number\"") + count(svg, "<text class=\"hidden-number\""),
              60U);
    EXPECT_EQ(count(svg, "<text class=\"hidden-number\""), tessellation.hidden().size());
    EXPECT_EQ(count(drawn(random_sites(61, 100, 9)), "<text class=\"number\""), 0U);
    // In a part of many, too.
    const std::string part = drawn(random_sites(1000, 100, 0), {.box = Box{40, 40, 55, 55}});
    EXPECT_GT(count(part, "<text class=\"number\""), 10U);
    // Equal sites leave room for eight at most.
    const std::string equal = drawn(std::vector<Site>(20, {1, 1, 1}));
    const auto numbers = count(equal, "number\" x=");
    EXPECT_TRUE(4 <= numbers && numbers <= 8);
    EXPECT_NE(legend(equal).find("numbers of " + std::to_string(numbers) + " sites"), svg.npos);
}

TEST(Svg, CrossesTheCentresOfHiddenSites) {
    EXPECT_EQ(count(drawn(triangulate(few_sites(1), Euclidean{})), "<path class=\"crosses\" d=\"M"),
              2U);
    EXPECT_EQ(count(drawn(std::vector<Site>{{0, 0, 1}, {5, 0, 1}}), "<path class=\"crosses\""), 0U);
    // A site too small for an outline: a cross and no dot.
    const std::vector<Site> sites = {{0, 0, 3}, {0.5, 0, 0}, {9, 9, 1}};
    const std::string svg = drawn(triangulate(sites, Euclidean{}));
    EXPECT_EQ(numbered(svg, "hidden-dot"), 1U);
    EXPECT_EQ(numbered(svg, "dot"), 0U);
    EXPECT_EQ(count(picture(svg), "m0 "), 1U);
}

TEST(Svg, SaysWhereStraightEdgesStandForCurvedOnes) {
    const std::vector<Site> equal = {{0, 0, 1}, {5, 0, 1}, {2, 6, 1}, {0.2, 0, 0.2}};
    const std::vector<Site> unequal = {{0, 0, 1}, {5, 0, 1}, {2, 6, 2}};
    for (const Metric metric : all_metrics) {
        const auto says = [&](const std::vector<Site>& sites) {
            return legend(drawn(triangulate(sites, metric))).find("drawn straight") !=
                   std::string::npos;
        };
        EXPECT_EQ(says(unequal), metric != Metric::power);
        EXPECT_FALSE(says(equal));  // the smaller one is hidden
    }
}

TEST(Axes, NameRoundNumbersWhereTheyAre) {
    const std::vector<Site> sites = {{0, 0, 0}, {1, 1, 0}};
    using Ticks = std::vector<std::pair<std::string, double>>;
    EXPECT_EQ(
        ticks(drawn(sites, {.box = Box{0, 0, 10, 5}}), 'x'),
        (Ticks{{"0", 0}, {"2", 157.6}, {"4", 315.2}, {"6", 472.8}, {"8", 630.4}, {"10", 788}}));
    EXPECT_EQ(ticks(drawn(sites, {.box = Box{0, 0, 10, 5}}), 'y'),
              (Ticks{{"0", 394}, {"2", 236.4}, {"4", 78.8}}));
    EXPECT_EQ(ticks(drawn(sites, {.box = Box{-0.3, -0.3, 0.3, 0}}), 'y'),
              (Ticks{{"-0.3", 394}, {"-0.2", 262.67}, {"-0.1", 131.33}, {"0.0", 0}}));
    // Neither the smallest nor the largest doubles, nor those far from 0, make them long.
    const std::string tiny = drawn(std::vector<Site>{{0, 0, 0}, {5e-324, 0, 0}, {0, 1e-323, 0}});
    EXPECT_EQ(ticks(tiny, 'y').size(), 3U);
    EXPECT_EQ(ticks(tiny, 'y')[1].first, "0.5");
    EXPECT_NE(legend(tiny).find("axes × 1e-323 "), tiny.npos);
    const std::string huge = drawn(std::vector<Site>{{-1.7e308, 0, 0}, {1.7e308, 0, 0}});
    EXPECT_EQ(ticks(huge, 'x').size(), 7U);
    EXPECT_EQ(ticks(huge, 'x')[6].first, "1.5");
    EXPECT_NE(legend(huge).find("axes × 1e308 "), huge.npos);
    const double far = 0x1p52;
    const std::string shifted = drawn(std::vector<Site>{{far, 3, 0}, {far + 1000, 500, 0}});
    EXPECT_EQ(ticks(shifted, 'x')[0].first, "600");
    EXPECT_NE(legend(shifted).find(" x = 4503599627370000 + axis "), shifted.npos);
    EXPECT_EQ(legend(shifted).find(" y = "), shifted.npos);
    // A site at the double nearest to 1.000001e-200 lies where the tick of that name does.
    const std::string small = drawn(std::vector<Site>{{1e-200, 0, 0}, {1.000002e-200, 0, 0}});
    EXPECT_NE(legend(small).find(" x = 1e-200 + axis × 1e-206 y = axis × 1e-206"), small.npos)
        << legend(small);
}

/// Whatever the picture shows: from two numbers on, none long, evenly spaced.
TEST(Axes, HaveAFewNumbersOfAnySize) {
    std::mt19937_64 random(11);
    for (int round = 0; round < 300; ++round) {
        const double size = std::ldexp(1 + static_cast<double>(random() >> 11) * 0x1p-53,
                                       static_cast<int>(random() % 2090) - 1070);
        const double shift = round % 3 == 0 ? 0 : std::ldexp(size, static_cast<int>(random() % 50));
        const Box box = {shift, -size / 2, shift + size, size / 2};
        if (!(box.x0 < box.x1 && box.y0 < 0 && std::isfinite(box.x1))) continue;
        const Frame frame(box, 788);
        std::vector<Site> sites = {{box.x0, box.y0, 0}, {box.x1, box.y1, 0}};
        const std::string svg = drawn(sites, {.box = box});
        expect_drawable(svg);
        for (const char axis : {'x', 'y'}) {
            const auto found = ticks(svg, axis);
            const bool coarse = size < 1e-322 || shift > std::ldexp(size, 48);
            EXPECT_TRUE(coarse || found.size() >= 2) << axis << ": " << size << " at " << shift;
            EXPECT_LE(found.size(), 10U);
            for (const auto& [number, place] : found) EXPECT_LE(number.size(), 6U) << number;
        }
    }
}

TEST(Svg, SaysWhereDoublesAreTooCoarseForCells) {
    const auto note = [](double shift) {
        std::vector<Site> sites = random_sites(30, 100, 0);
        for (Site& s : sites) s = {std::floor(s.x) + shift, std::floor(s.y) + shift, 0};
        return legend(drawn(sites));
    };
    EXPECT_EQ(note(0x1p40).find("doubles"), std::string::npos);
    EXPECT_NE(note(0x1p52).find("cells are up to 7 px off: doubles are no finer"),
              std::string::npos)
        << note(0x1p52);
    EXPECT_NE(note(0x1p56).find("cells are not drawn: doubles are too coarse"), std::string::npos);
}

TEST(Svg, WeightsBelowZeroAreDots) {
    const std::string svg = drawn(std::vector<power::Site>{{0, 0, -1}, {5, 0, 4}, {2, 6, 0}});
    expect_drawable(svg);
    EXPECT_EQ(numbered(svg, "site"), 1U);
    EXPECT_EQ(numbered(svg, "dot"), 2U);
}

TEST(Svg, AnEnormousDiscIsCutOff) {
    auto sites = few_sites(1);
    sites.push_back({5, 5, 1e9});
    const std::string svg = drawn(sites);
    expect_drawable(svg);
    EXPECT_NE(legend(svg).find("covers the whole picture: 1"), svg.npos);
}

TEST(Svg, MarksEdgesOnRequest) {
    const std::vector<Edge> wrong = {{-1, 2}, {0, 1}};
    const std::vector<Edge> flipped = {{0, 2}, {1, 2}};
    const std::vector<Edge> different = {{1, 2}};
    const std::string svg = drawn(std::vector<Site>{{0, 0, 1}, {5, 0, 1}, {2, 6, 1}},
                                  {.wrong = wrong, .different = different, .flipped = flipped});
    expect_drawable(svg);
    EXPECT_EQ(lines(svg, "wrong"), 1U);
    EXPECT_EQ(lines(svg, "flipped"), 2U);
    EXPECT_EQ(lines(svg, "different"), 1U);
    EXPECT_NE(svg.find(">wrong edges<"), svg.npos);
    EXPECT_NE(svg.find(">different edges<"), svg.npos);
    EXPECT_GT(std::abs(hue(svg, "cell") - hue(svg, "wrong")), 60);
}

TEST(Svg, ThinsOutAndSaysSo) {
    const auto sites = random_sites(3000, 1000, 10);
    const std::string svg = drawn(sites, {.site_limit = 500, .line_limit = 1000});
    expect_drawable(svg);
    for (const auto kind : {"site", "dot", "hidden", "hidden-dot"})
        EXPECT_LE(numbered(svg, kind), 500U);
    EXPECT_GT(numbered(svg, "site"), 100U);
    for (const auto kind : {"edge", "cell"}) {
        EXPECT_LE(lines(svg, kind), 1000U);
        EXPECT_GT(lines(svg, kind), 500U);
    }
    EXPECT_EQ(count(legend(svg), "left out"), 2U);
    EXPECT_NE(legend(svg).find("dots without a number"), svg.npos);
}

TEST(Svg, AHundredThousandSitesAreBounded) {
    const std::string svg = drawn(random_sites(100'000, 1e5, 200));
    expect_drawable(svg);
    EXPECT_LT(svg.size(), 10'000'000U);
    EXPECT_LT(count(svg, "<"), 50'000U);
    EXPECT_NE(svg.find("tessellation: "), svg.npos);
}

TEST(Svg, SquaresAndDiamondsHaveTheirShapes) {
    const auto sites = random_sites(60, 100, 14);
    const auto squares = triangulate(sites, Supremum{});
    const auto diamonds = triangulate(sites, Manhattan{});
    ASSERT_GT(squares.hidden().size(), 3U);
    ASSERT_GT(diamonds.hidden().size(), 3U);
    const auto expect = [&](const Tessellation& t, std::string_view element,
                            std::string_view cells) {
        const std::string svg = drawn(t);
        expect_drawable(svg);
        EXPECT_EQ(numbered(svg, "hidden", element) + numbered(svg, "hidden-dot"),
                  t.hidden().size());
        EXPECT_EQ(numbered(svg, "site", element) + numbered(svg, "dot"),
                  sites.size() - t.hidden().size());
        EXPECT_EQ(numbered(svg, "site") + numbered(svg, "hidden"), 0U);
        EXPECT_NE(svg.find(cells), svg.npos);
    };
    expect(squares, "rect", ">supremum cells<");
    expect(diamonds, "polygon", ">Manhattan cells<");
    const std::string discs = drawn(euclidean({{0, 0, 1}, {3, 1, 2}}));
    expect_drawable(discs);
    EXPECT_EQ(numbered(discs, "site"), 2U);
    EXPECT_NE(discs.find(">Euclidean cells<"), discs.npos);
}

TEST(Svg, OutlinesTouchWhatLiesARadiusAway) {
    SvgText text;
    square_outline().write_geometry(text, {10, 20}, 3);
    diamond_outline().write_geometry(text, {10, 20}, 3);
    EXPECT_EQ(text.view(),
              "x=\"7\" y=\"17\" width=\"6\" height=\"6\""
              "points=\"10,17 13,20 10,23 7,20\"");
}

/// A site between two others, around which they meet twice.
TEST(Svg, EdgesBetweenTheSameSitesAreDrawnOnce) {
    const std::vector<Site> sites = {{0, 0, 5}, {16, 0, 5}, {8, 0, 1}};
    const auto t = triangulate(sites, Supremum{});
    ASSERT_EQ(t.edges().size(), 6U);
    ASSERT_EQ(std::ranges::count(t.edges(), Edge{0, 1}), 2);
    const std::string svg = drawn(t);
    expect_drawable(svg);
    EXPECT_EQ(lines(svg, "edge"), 3U);
    // The cell of the one between is an octagon's upper and lower half, with a line up and down.
    EXPECT_EQ(lines(svg, "cell"), 8U);
}

TEST(Svg, NegativeRadiiAreDots) {
    const std::vector<Site> sites = {{0, 0, -3}, {5, 0, -2}, {2, 6, 1}};
    for (const auto& t : {triangulate(sites, Supremum{}), triangulate(sites, Manhattan{})}) {
        const std::string svg = drawn(t);
        expect_drawable(svg);
        EXPECT_EQ(numbered(svg, "dot"), 2U);
    }
}

TEST(Svg, AlignedSquaresAreSeparatedByTheLineOfTheTieRule) {
    // The bisector bends around the later site, or around the smaller square.
    const Frame frame(std::vector<Site>{{0, 0, 1}, {4, 0, 1}}, 900);
    const auto edges = cell_edges(
        voronoi(triangulate(std::vector<Site>{{0, 0, 1}, {4, 0, 1}}, Supremum{})), frame);
    ASSERT_EQ(edges.size(), 1U);  // the picture is too low for the bends
    EXPECT_EQ(edges[0].from.x, frame.width() / 2);
    EXPECT_EQ(edges[0].to.x, frame.width() / 2);
    const Frame high(std::vector<Site>{{0, 0, 1}, {4, 0, 1}, {0, 9, 0}}, 900);
    const auto bent =
        cell_edges(voronoi(triangulate(std::vector<Site>{{0, 0, 1}, {4, 0, 1}}, Supremum{})), high);
    ASSERT_EQ(bent.size(), 2U);
    const Point middle = high.at({2, 2});
    EXPECT_NEAR(bent[0].to.x, middle.x, 1e-9);
    EXPECT_NEAR(bent[0].to.y, middle.y, 1e-9);
    EXPECT_GT(bent[1].to.x, middle.x);
}

TEST(Svg, AdditiveMetricsAtTheExtremesOfADouble) {
    constexpr double most = 1.7976931348623157e308;
    const std::vector<std::vector<Site>> sets = {
        {{-most, 0, most}, {most, most, 0}, {0, -most, most}},
        {{-most, -most, -most}, {most, most, -most}, {0, 1, -most}},
        {{0, 0, 0}, {1, 5e-324, 0}, {1e-200, 0, 0}},
        {{1e300, 0, 1}, {1e300, 1, 1e-300}, {0, 0, 2}},
        {{0, 0, 5e-324}, {5e-324, 5e-324, 0}, {0, 1e-323, 0}},
        few_sites(1e300),
        few_sites(1e-300),
        few_sites(0x1p-1074)};
    for (const auto& sites : sets) {
        expect_drawable(drawn(triangulate(sites, Supremum{})));
        expect_drawable(drawn(triangulate(sites, Manhattan{})));
        expect_drawable(drawn(euclidean({sites[0], sites[1]})));
        expect_drawable(drawn(euclidean({sites[0], sites[1], sites[2]},
                                        {{-1, 0, 2}, {-1, 1, 0}, {-1, 2, 1}, {0, 1, 2}},
                                        {{3, 2, 1}, {3, 0, 2}, {3, 1, 0}, {2, 0, 1}})));
        expect_drawable(drawn(euclidean({sites[0], sites[2], sites[1]},
                                        {{-1, 0, 2}, {-1, 1, 0}, {-1, 2, 1}, {0, 1, 2}},
                                        {{3, 2, 1}, {3, 0, 2}, {3, 1, 0}, {2, 0, 1}})));
    }
}

TEST(Svg, ScaleDoesNotMatterInTheAdditiveMetrics) {
    for (const double scale : {0x1p990, 0x1p-990, 0x1p-1060})
        for (const Metric metric : all_metrics)
            EXPECT_EQ(picture(drawn(triangulate(few_sites(scale), metric))),
                      picture(drawn(triangulate(few_sites(1), metric))))
                << scale << name_of(metric);
}

TEST(Svg, ALineOfArcsIsSmooth) {
    // A hyperbola that turns sharply around the smaller disc's side.
    const Tessellation t = euclidean({{0, 0, 9.9}, {10, 0, 0}});
    const Frame frame(t.sites(), 900);
    const auto arcs = cell_edges(voronoi(t), frame);
    ASSERT_EQ(arcs.size(), 2U);
    auto drawn = parabolas(arcs[0], 0.05);
    for (const Conic& part : parabolas(arcs[1], 0.05)) drawn.push_back(part);
    ASSERT_GE(drawn.size(), 4U);
    EXPECT_LT(drawn.size(), 100U);
    for (std::size_t i = 1; i < drawn.size(); ++i) EXPECT_EQ(drawn[i].from, drawn[i - 1].to);
    // Down first: the larger disc, on the left, stays on the left of the way up.
    EXPECT_GT(arcs.front().from.y, arcs.back().to.y);
}

TEST(SmallestDrawn, KeepsTheLimitAndTreatsEqualSizesAlike) {
    const std::vector<double> sizes = {5, 1, 3, 3, 2};
    EXPECT_EQ(smallest_drawn(sizes, 5, 1), 0);
    EXPECT_EQ(smallest_drawn(sizes, 4, 1), 2);
    EXPECT_EQ(smallest_drawn(sizes, 2, 1), 4);
    EXPECT_EQ(smallest_drawn(sizes, 0, 1), 6);
}

/// The definition: along an edge between two cells two sites are equally near and none is nearer.
TEST(PowerCells, LieBetweenTheTwoNearestSites) {
    for (const double radius : {0.0, 3.0, 25.0}) {
        const auto sites = random_sites(80, 100, radius);
        const auto tessellation = triangulate(sites, Power{});
        const Frame frame(sites, 900);
        const auto edges = cell_edges(voronoi(tessellation), frame);
        EXPECT_GT(edges.size(), 60U);
        for (const auto& [from, control, to, weight] : edges) {
            const Point middle = {(from.x + to.x) / 2, (from.y + to.y) / 2};
            std::vector<double> distances;
            for (const Site& site : sites) {
                const Point at = frame.at({site.x, site.y});
                const double dx = at.x - middle.x;
                const double dy = at.y - middle.y;
                const double r = frame.length(site.r);
                distances.push_back(dx * dx + dy * dy - r * r);
            }
            std::ranges::sort(distances);
            EXPECT_NEAR(distances[0], distances[1], 1e-5);
            for (const Point end : {from, to}) {
                EXPECT_TRUE(-1e-6 <= end.x && end.x <= frame.width() + 1e-6);
                EXPECT_TRUE(-1e-6 <= end.y && end.y <= frame.height() + 1e-6);
            }
        }
    }
}

std::string drawn(const std::vector<Site3>& sites, WeightIs weight_is = WeightIs::radius,
                  const SpaceSvgOptions& options = {}) {
    std::ostringstream out;
    write_svg(out, triangulate(sites), sites, weight_is, options);
    return out.str();
}

TEST(SpaceSvg, DrawsEverySiteOnceAndEveryEdge) {
    const std::vector<Site3> sites = {{0, 0, 0, 1}, {9, 0, 0, 2},     {0, 9, 0, 0},
                                      {0, 0, 9, 1}, {2, 2, 2, 0.125}, {2, 2, 2, 0.25}};
    const std::string svg = drawn(sites);
    expect_drawable(svg);
    EXPECT_EQ(svg, drawn(sites));
    EXPECT_EQ(numbered(svg, "site"), 4U);
    EXPECT_EQ(numbered(svg, "dot"), 1U);
    EXPECT_EQ(numbered(svg, "hidden") + numbered(svg, "hidden-dot"), 1U);
    EXPECT_NE(svg.find("<title>4, hidden by 5</title>"), svg.npos);
    EXPECT_EQ(lines(svg, "edge"), 10U);
    EXPECT_EQ(count(svg, "class=\"number\"") + count(svg, "class=\"hidden-number\""), 6U);
    EXPECT_NE(legend(svg).find("visible sites: 5 hidden sites: 1 tessellation"), svg.npos)
        << legend(svg);
    EXPECT_EQ(legend(svg).find("nearest"), svg.npos);
}

TEST(SpaceSvg, ShowsInTheLegendWhatIsDrawn) {
    const auto samples = [](const std::string& svg) {
        const auto start = svg.find("<g class=\"legend\"");
        return svg.substr(start, svg.find("visible sites", start) - start);
    };
    const std::string points = drawn(
        std::vector<Site3>{{0, 0, 0, 0}, {9, 0, 0, 0}, {0, 9, 0, 0}, {0, 0, 9, 0}, {0, 0, 9, 0}});
    EXPECT_EQ(count(samples(points), "class=\"site\""), 0U);
    EXPECT_EQ(count(samples(points), "class=\"dot\""), 1U);
    EXPECT_EQ(points.find("class=\"hidden\""), points.npos);
    const std::string balls = drawn(std::vector<Site3>{{0, 0, 0, 0}, {9, 0, 0, 1}});
    EXPECT_EQ(count(samples(balls), "class=\"site\""), 1U);
}

/// What is far is drawn first, and paler.
TEST(SpaceSvg, DrawsWhatIsNearOverWhatIsFar) {
    const std::string svg =
        drawn(std::vector<Site3>{{0, 0, 9, 3}, {0, 0, -9, 3}, {9, 0, 0, 3}, {0, 9, 0, 3}});
    EXPECT_LT(svg.find("<title>1<"), svg.find("<title>3<"));
    EXPECT_LT(svg.find("<title>3<"), svg.find("<title>0<"));
    ASSERT_NE(svg.find("<g opacity=\"1\">"), svg.npos);
    EXPECT_LT(svg.find("<g opacity=\"0.35\">"), svg.find("<g opacity=\"1\">"));
}

TEST(SpaceSvg, AnyInputIsDrawable) {
    for (const double scale : {1.0, 1e308, 1e-300, 5e-324}) {
        const std::vector<Site3> cube = {{0, 0, 0, 0},         {scale, 0, 0, 0},
                                         {0, scale, 0, scale}, {-scale, -scale, -scale, 0},
                                         {0, 0, scale, 0},     {scale, scale, scale, scale}};
        for (std::size_t size = 1; size <= cube.size(); ++size) {
            const std::vector<Site3> sites(cube.begin(),
                                           cube.begin() + static_cast<std::ptrdiff_t>(size));
            expect_drawable(drawn(sites));
        }
    }
    expect_drawable(drawn({{1, 2, 3, 0}, {1, 2, 3, 0}, {1e15, 1e-15, 0, 1e300}}));
    expect_drawable(drawn({{1e15, 0, 0, 0}, {1e15 + 1, 0, 0, 0}, {1e15, 1, 0, 0}}));
    expect_drawable(drawn({{0, 0, 0, -4}, {1, 0, 0, 4}}, WeightIs::weight));
}

TEST(SpaceSvg, ThinsOutAndSaysSo) {
    const std::vector<Site3> sites = generate(SpaceDistribution::sphere, {.count = 300});
    const std::string svg = drawn(sites, WeightIs::radius, {.site_limit = 100, .line_limit = 200});
    expect_drawable(svg);
    EXPECT_EQ(numbered(svg, "dot"), 100U);
    EXPECT_EQ(lines(svg, "edge"), 200U);
    const std::string words = legend(svg);
    EXPECT_NE(words.find("sites: the 100 nearest of 300 drawn"), svg.npos) << words;
    EXPECT_NE(words.find("edges of the hull"), svg.npos) << words;
    EXPECT_NE(words.find("edges inside are not drawn: there are "), svg.npos) << words;
    // A sphere's hull is a triangulation of all its sites.
    EXPECT_NE(words.find("edges: the 200 nearest of 894 drawn"), svg.npos) << words;
    EXPECT_LT(drawn(generate(SpaceDistribution::random, {.count = 20'000})).size(), 2'000'000U);
}

TEST(Frame, ShowsABox) {
    const Box box = {-1, 2, 7, 5};
    const Frame frame(box, 900);
    EXPECT_EQ(frame.width(), 900);
    EXPECT_EQ(frame.height(), 337.5);
    EXPECT_EQ(frame.at({-1, 5}), (Point{0, 0}));
    EXPECT_EQ(frame.at({7, 2}), (Point{900, 337.5}));
    EXPECT_EQ(frame.box(0), box);
    EXPECT_EQ(frame.at({7.0 / 8, 2.0 / 8}, 3), (Point{900, 337.5}));
    // A tall one is no picture without end.
    EXPECT_EQ(Frame(Box{0, 0, 1, 1000}, 900).height(), 1800);
}

}  // namespace
