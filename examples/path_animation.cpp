// Writes docs/pictures/path.svg to standard output: the way from the power tessellation of eight
// sites to their Manhattan tessellation, one swapped edge after the other, as an animation (SMIL).
//
// On the way edges have no geometry, and two vertices may share several: what is drawn is W. T.
// Tutte's embedding (How to draw a graph, 1963). Infinity becomes a circle; on it stand, in order,
// the middles of the edges to infinity and the faces between them. Every other vertex, middle of an
// edge and face settles at a weighted mean of what it touches, and so nothing crosses. Weights are
// lengths, which keeps small parts from shrinking, and less towards the circle.

#include <cmath>
#include <complex>
#include <cstddef>
#include <iostream>
#include <map>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <signum/tool/draw/svg_text.hpp>
#include <signum/tool/generate/generate.hpp>
#include <signum/triangulation/flip_graph.hpp>
#include <signum/triangulation/triangulate.hpp>

namespace {

using namespace signum;
using Complex = std::complex<double>;

constexpr double size = 460;    // of the picture, in pixels
constexpr double radius = 200;  // of infinity
constexpr double seconds_a_swap = 1.4;

std::size_t at(Index i) {
    return static_cast<std::size_t>(i);
}

/// Where sites, middles of edges and faces are drawn, in this order.
using Layout = std::vector<Complex>;

class Embedding {
 public:
    Embedding(const ExtendedTessellation& t, std::size_t sites)
        : t_(t), sites_(sites), place_(sites + at(t.edges() + t.faces())), touches_(place_.size()) {
        for (Index e = 0; e < t.edges(); ++e)
            for (const Index v : t.ends(e)) join(middle(e), v);
        for (Index f = 0; f < t.faces(); ++f) {
            for (const Index v : t.corners_of(f)) join(face(f), v);
            for (const Index e : t.edges_of(f)) join(face(f), static_cast<Index>(middle(e)));
        }
        put_infinity();
        settle();
    }

    /// Turned so that the sites lie as near as they can to where they were.
    [[nodiscard]] Layout turned_to(const Layout& before) const {
        Complex turn = 0;
        for (std::size_t i = 0; i < sites_; ++i) turn += before[i] * std::conj(place_[i]);
        Layout result = place_;
        for (Complex& p : result) p *= turn / std::abs(turn);
        return result;
    }

 private:
    [[nodiscard]] std::size_t middle(Index e) const { return sites_ + at(e); }
    [[nodiscard]] std::size_t face(Index f) const { return sites_ + at(t_.edges() + f); }

    void join(std::size_t a, Index b) {
        if (b == infinite) return;
        touches_[a].push_back(at(b));
        touches_[at(b)].push_back(a);
    }

    /// Around infinity, from edge to face to edge: clockwise in the plane.
    void put_infinity() {
        std::map<Index, std::pair<Index, Index>> after;  // the next face, and the edge behind it
        for (Index f = 0; f < t_.faces(); ++f)
            for (std::size_t k = 0; k < 3; ++k)
                if (t_.corners_of(f)[k] == infinite)
                    after[t_.edges_of(f)[(k + 2) % 3]] = {f, t_.edges_of(f)[(k + 1) % 3]};
        Index e = after.begin()->first;
        double angle = 0;
        for (std::size_t i = 0; i < after.size(); ++i) {
            const auto [f, next] = after[e];
            for (const std::size_t node : {middle(e), face(f)}) {
                place_[node] = std::polar(radius, angle);
                touches_[node].clear();  // it stays
                angle -= std::numbers::pi / static_cast<double>(after.size());
            }
            e = next;
        }
    }

    void settle() {
        for (int round = 0; round < 3000; ++round)
            for (std::size_t i = 0; i < place_.size(); ++i) {
                if (touches_[i].empty()) continue;
                Complex sum = 0;
                double weights = 0;
                for (const std::size_t other : touches_[i]) {
                    const double length = 1 + std::abs(place_[other] - place_[i]);
                    const double weight = touches_[other].empty() ? length / 3 : length;
                    sum += weight * place_[other];
                    weights += weight;
                }
                place_[i] += (sum / weights - place_[i]) / 2.0;
            }
    }

    const ExtendedTessellation& t_;
    std::size_t sites_;
    Layout place_;
    std::vector<std::vector<std::size_t>> touches_;
};

/// A tessellation on the way, and the edge that is swapped next, -1 in the end.
struct Frame {
    Layout layout;
    std::vector<Edge> ends;
    Index swapped;
    double share;  ///< of the way behind it
};

std::vector<Frame> frames(const Tessellation& from, const Tessellation& to) {
    std::vector<Index> swaps = path(from.arrays(), to.arrays());
    swaps.push_back(-1);
    ExtendedTessellation t(from.arrays());
    Frame now;
    for (const Site& s : from.sites()) now.layout.emplace_back(s.x - 350, s.y - 350);
    for (Index e = 0; e < t.edges(); ++e) now.ends.push_back(t.ends(e));
    std::vector<Frame> result;
    for (const Index swapped : swaps) {
        now.layout = Embedding(t, from.sites().size()).turned_to(now.layout);
        now.swapped = swapped;
        now.share = static_cast<double>(result.size()) / static_cast<double>(swaps.size() - 1);
        result.push_back(now);
        if (swapped < 0) continue;
        t.swap(swapped);
        now.ends[at(swapped)] = t.ends(swapped);  // the others' must not trade places
    }
    return result;
}

/// In pixels, tenths of them.
std::string text(Complex p) {
    const auto tenths = [](double value) { return Px{std::round(10 * value) / 10}; };
    return fmt::format("{} {}", tenths(size / 2 + p.real()), tenths(size / 2 - p.imag()));
}

/// From end to end through the middle; an end at infinity is the middle itself.
std::string curve(const Frame& frame, Index e, std::size_t sites) {
    const Complex middle = frame.layout[sites + at(e)];
    const auto end = [&](Index v) { return v == infinite ? middle : frame.layout[at(v)]; };
    const Complex a = end(frame.ends[at(e)][0]);
    const Complex b = end(frame.ends[at(e)][1]);
    const Complex control =
        middle == a || middle == b ? (a + b) / 2.0 : 2.0 * middle - (a + b) / 2.0;
    return fmt::format("M{}Q{} {}", text(a), text(control), text(b));
}

/// One value a frame: from one to the next with a rest at each, or by jumps.
template <class Value>
void animate(SvgText& svg, std::string_view what, const std::vector<Frame>& frames,
             const Value& value, bool jumps = false) {
    std::string values = value(frames.front());
    std::string rests = ".8 0 .2 1";
    for (std::size_t i = 1; i + (jumps ? 1 : 0) < frames.size(); ++i)
        values += ";" + value(frames[i]);
    for (std::size_t i = 2; i < frames.size(); ++i) rests += ";.8 0 .2 1";
    const std::string mode = jumps ? "discrete" : "spline\" keySplines=\"" + rests;
    svg.add(R"(<animate{} values="{}" calcMode="{}" dur="{}s" repeatCount="indefinite"/>)", what,
            values, mode, seconds_a_swap * static_cast<double>(frames.size() - 1));
}

}  // namespace

int main() {
    GenerateOptions options;
    options.count = 8;
    options.radius_from = 10;
    options.radius_to = 80;
    options.seed = 1576;  // of a short way, to a tessellation with a double edge
    const std::vector<Site> sites = generate(Distribution::random, options);
    std::vector<Frame> all = frames(triangulate(sites, Power{}), triangulate(sites, Manhattan{}));
    // Both ends stay for a while.
    Frame first = all.front();
    first.swapped = -1;
    all.insert(all.begin(), first);
    all.insert(all.end(), 2, Frame(all.back()));

    SvgText svg;
    svg.add(
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1}" width="{0}" height="{1}" )"
        R"(font-family="system-ui, sans-serif" font-size="13" text-anchor="middle">
<title>From the power tessellation of eight sites to their Manhattan tessellation</title>
<rect width="{0}" height="{1}" fill="#fff"/>
<circle cx="{2}" cy="{2}" r="{3}" fill="none" stroke="#0072b2" stroke-width="2"/>
<text x="{2}" y="20" fill="#0072b2" font-size="18">∞</text>
<g fill="none" stroke="#000" stroke-width="1.5" stroke-linecap="round">
)",
        size, size + 40, size / 2, radius);
    for (Index e = 0; at(e) < all.front().ends.size(); ++e) {
        svg.add(R"(<path d="{}">)", curve(all.front(), e, sites.size()));
        animate(svg, R"( attributeName="d")", all,
                [&](const Frame& frame) { return curve(frame, e, sites.size()); });
        const auto mark = [&](std::string_view what, std::string swapped, std::string otherwise) {
            const auto value = [&](const Frame& f) { return f.swapped == e ? swapped : otherwise; };
            animate(svg, what, all, value, true);
        };
        mark(R"( attributeName="stroke")", "#d55e00", "#000");
        mark(R"( attributeName="stroke-width")", "4", "1.5");
        svg.add("</path>\n");
    }
    svg.add("</g>\n");
    for (std::size_t i = 0; i < sites.size(); ++i) {
        svg.add(
            R"svg(<g transform="translate({})"><circle r="10" fill="#cbe6f7" stroke="#0072b2"/>)svg"
            R"(<text y="4.5">{}</text>)",
            text(all.front().layout[i]), i);
        animate(svg, R"(Transform attributeName="transform" type="translate")", all,
                [&](const Frame& frame) { return text(frame.layout[i]); });
        svg.add("</g>\n");
    }
    const double bar = size - 240;
    svg.add(
        R"(<text x="60" y="{0}">power</text><text x="{1}" y="{0}">Manhattan</text>)"
        R"(<path d="M120 {2}h{3}" stroke="#999"/><circle cx="120" cy="{2}" r="4" fill="#d55e00">)",
        size + 20, size - 60, size + 15.5, bar);
    animate(svg, R"( attributeName="cx")", all,
            [&](const Frame& frame) { return fmt::format("{}", Px{120 + bar * frame.share}); });
    svg.add("</circle>\n</svg>\n");
    std::cout << svg.view();
}
