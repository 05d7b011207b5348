#include "write_csv.hpp"
#include "text_writer.hpp"

namespace signum {

void write_csv(std::ostream& out, const Tessellation& tessellation) {
    TextWriter text(out);
    text.put("a,b,c\n");
    for (const auto [a, b, c] : tessellation.faces()) {
        text.put(FMT_COMPILE("{},{},{}\n"), a, b, c);
    }
    text.flush();
}

void write_csv(std::ostream& out, const SpaceTessellation& tessellation) {
    constexpr std::string_view header = "a,b,c,d";
    TextWriter text(out);
    const std::ptrdiff_t vertices = tessellation.dimension + 1;
    text.put(FMT_COMPILE("{}\n"), header.substr(0, static_cast<std::size_t>(2 * vertices - 1)));
    for (const SpaceCell& cell : tessellation.cells)
        text.put(FMT_COMPILE("{}\n"), fmt::join(cell.begin(), cell.begin() + vertices, ","));
    text.flush();
}

}  // namespace signum
