#include "write_sites.hpp"
#include "text_writer.hpp"

namespace signum {

void write_sites(std::ostream& out, std::span<const Site> sites, SitesFormat format) {
    TextWriter text(out);
    switch (format) {
        case SitesFormat::text:
            for (const auto& [x, y, r] : sites) text.put(FMT_COMPILE("{} {} {}\n"), x, y, r);
            break;
        case SitesFormat::csv:
            text.put("x,y,r\n");
            for (const auto& [x, y, r] : sites) text.put(FMT_COMPILE("{},{},{}\n"), x, y, r);
            break;
        case SitesFormat::json: {
            std::string_view separator = "[";
            for (const auto& [x, y, r] : sites) {
                text.put(FMT_COMPILE("{}[{}, {}, {}]"), separator, x, y, r);
                separator = ",\n";
            }
            text.put("]\n");
            break;
        }
    }
    text.flush();
}

}  // namespace signum
