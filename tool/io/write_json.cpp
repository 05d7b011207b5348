#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "../../triangulation/vertices.hpp"
#include "text_writer.hpp"
#include "write_json.hpp"

namespace signum {
namespace {

void put_vertices(TextWriter& text, const Tessellation& tessellation) {
    const std::vector<DiagramVertex> all = vertices(tessellation);
    std::size_t next = 0;
    text.put_array("vertices", tessellation.faces(), [&](const Face& face) {
        const DiagramVertex& vertex = all[next++];
        if (face[0] == infinite) {
            text.put("null");
        } else {
            text.put(FMT_COMPILE("[{}, {}, {}]"), number_or_null(vertex.x),
                     number_or_null(vertex.y), number_or_null(vertex.rho));
        }
    });
}

void put_vertices(TextWriter& text, const SpaceTessellation& tessellation,
                  std::span<const SpaceVertex> vertices) {
    std::size_t next = 0;
    text.put_array("vertices", tessellation.cells, [&](const SpaceCell& cell) {
        const SpaceVertex& vertex = vertices[next++];
        if (cell[0] == infinite || tessellation.dimension < 3) {
            text.put("null");
        } else {
            text.put(FMT_COMPILE("[{}, {}, {}, {}]"), number_or_null(vertex.x),
                     number_or_null(vertex.y), number_or_null(vertex.z),
                     number_or_null(vertex.rho));
        }
    });
}

void put_statistics(TextWriter& text, const Statistics& statistics) {
    text.put(",\n\"statistics\": {");
    for (const Counter& counter : counters)
        if (statistics.counted) {
            text.put(FMT_COMPILE("\"{}\": {}, "), counter.name, statistics.*counter.count);
        } else {
            text.put(FMT_COMPILE("\"{}\": null, "), counter.name);
        }
    text.put(FMT_COMPILE("\"seconds\": {}}}"), number_or_null(statistics.seconds));
}

}  // namespace

void write_json(std::ostream& out, const Tessellation& tessellation, const JsonOptions& options) {
    TextWriter text(out);
    text.put(FMT_COMPILE("{{\"format\": \"signum.tessellation\", \"version\": 1, \"metric\": "
                         "\"{}\", \"weight_is\": \"{}\", \"sites\": {}"),
             name_of(tessellation.metric()), name_of(tessellation.weight_is()),
             tessellation.arrays().sites);
    const auto put_triple = [&](const Face& triple) {
        text.put(FMT_COMPILE("[{}, {}, {}]"), triple[0], triple[1], triple[2]);
    };
    text.put_array("faces", tessellation.faces(), put_triple);
    text.put_array("neighbours", tessellation.arrays().neighbours, put_triple);
    text.put_array("hidden", tessellation.hidden(), [&](const Hidden& hidden) {
        text.put(FMT_COMPILE("[{}, {}]"), hidden.site, hidden.by);
    });
    if (options.vertices) put_vertices(text, tessellation);
    if (options.statistics) put_statistics(text, tessellation.statistics());
    text.put("}\n");
    text.flush();
}

void write_json(std::ostream& out, const SpaceTessellation& tessellation, Metric metric,
                WeightIs weight_is, const std::optional<Statistics>& statistics,
                std::span<const SpaceVertex> vertices) {
    TextWriter text(out);
    text.put(
        FMT_COMPILE("{{\"format\": \"signum.tessellation\", \"version\": 1, \"dimension\": {}, "
                    "\"metric\": \"{}\", \"weight_is\": \"{}\", \"sites\": {}"),
        tessellation.dimension, name_of(metric), name_of(weight_is), tessellation.sites);
    const std::ptrdiff_t size = tessellation.dimension + 1;
    const auto put_cell = [&](const SpaceCell& cell) {
        text.put(FMT_COMPILE("[{}]"), fmt::join(cell.begin(), cell.begin() + size, ", "));
    };
    text.put_array("cells", tessellation.cells, put_cell);
    text.put_array("neighbours", tessellation.neighbours, put_cell);
    text.put_array("hidden", tessellation.hidden, [&](const Hidden& hidden) {
        text.put(FMT_COMPILE("[{}, {}]"), hidden.site, hidden.by);
    });
    if (!vertices.empty()) put_vertices(text, tessellation, vertices);
    if (statistics) put_statistics(text, *statistics);
    text.put("}\n");
    text.flush();
}

}  // namespace signum
