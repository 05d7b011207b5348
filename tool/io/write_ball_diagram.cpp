#include "write_ball_diagram.hpp"

#include <array>
#include <cstddef>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "text_writer.hpp"

namespace signum {
namespace {

std::vector<std::size_t> numbers_below(std::size_t count) {
    std::vector<std::size_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    return numbers;
}

}  // namespace

void write_json(std::ostream& out, const BallDiagram& diagram) {
    TextWriter text(out);
    text.put(FMT_COMPILE(R"({{"format": "signum.voronoi", "version": 1, "dimension": 3, )"
                         R"("metric": "euclidean", "weight_is": "radius", "sites": {}, )"
                         R"("clip": null)"),
             diagram.balls);
    text.put_array("vertices", diagram.spheres, [&](const Site3& sphere) {
        text.put(FMT_COMPILE("[{}, {}, {}, {}]"), number_or_null(sphere.x),
                 number_or_null(sphere.y), number_or_null(sphere.z), number_or_null(sphere.r));
    });
    text.put_array("touching", numbers_below(diagram.vertices.size()), [&](std::size_t v) {
        text.put(FMT_COMPILE("[{}]"), fmt::join(diagram.vertices[v], ", "));
    });
    text.put_array("turns", diagram.turns, [&](Sign turn) { text.put(FMT_COMPILE("{}"), turn); });
    text.put_array("edges", numbers_below(diagram.edges.size()), [&](std::size_t e) {
        const std::array<Index, 2>& ends = diagram.ends[e];
        const std::size_t count = ends[0] == no_end ? 0 : ends.size();
        text.put(FMT_COMPILE(R"({{"sites": [{}], "vertices": [{}]}})"),
                 fmt::join(diagram.edges[e], ", "), fmt::join(std::span(ends).first(count), ", "));
    });
    text.put_array("hidden", diagram.hidden, [&](const Hidden& hidden) {
        text.put(FMT_COMPILE("[{}, {}]"), hidden.site, hidden.by);
    });
    text.put("}\n");
    text.flush();
}

void write_csv(std::ostream& out, const BallDiagram& diagram) {
    TextWriter text(out);
    text.put("a,b,c,d,x,y,z,r,turn,others\n");
    for (std::size_t v = 0; v < diagram.vertices.size(); ++v) {
        const std::span<const Index> balls = diagram.vertices[v];
        const Site3& sphere = diagram.spheres[v];
        text.put(FMT_COMPILE("{},{},{},{},{},{},{}\n"), fmt::join(balls.first(4), ","),
                 number_or_blank(sphere.x), number_or_blank(sphere.y), number_or_blank(sphere.z),
                 number_or_blank(sphere.r), diagram.turns[v], fmt::join(balls.subspan(4), " "));
    }
    text.flush();
}

}  // namespace signum
