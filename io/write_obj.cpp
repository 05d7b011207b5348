#include "write_obj.hpp"
#include "text_writer.hpp"

namespace signum {

void write_obj(std::ostream& out, const Tessellation& tessellation) {
    TextWriter text(out);
    text.put(FMT_COMPILE("# signum: {} tessellation, a vertex a site\n"),
             name_of(tessellation.metric()));
    if (!traits_of(tessellation.metric()).edges_are_straight) {
        text.put("# edges are curved in this metric; drawn straight, faces may overlap or turn\n");
    }
    for (const Site& site : tessellation.sites()) {
        text.put(FMT_COMPILE("v {} {} 0\n"), site.x, site.y);
    }
    for (const auto [a, b, c] : tessellation.faces()) {
        if (a == infinite) continue;
        text.put(FMT_COMPILE("f {} {} {}\n"), a + std::int64_t{1}, b + std::int64_t{1},
                 c + std::int64_t{1});
    }
    text.flush();
}

}  // namespace signum
