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

}  // namespace signum
