#include "write_sites.hpp"

#include <array>

#include "text_writer.hpp"

namespace signum {
namespace {

std::array<double, 3> numbers_of(const Site& site) noexcept {
    return {site.x, site.y, site.r};
}
std::array<double, 4> numbers_of(const Site3& site) noexcept {
    return {site.x, site.y, site.z, site.r};
}

template <class S>
void write(std::ostream& out, std::span<const S> sites, SitesFormat format,
           std::string_view header) {
    TextWriter text(out);
    const auto put = [&](std::string_view before, const S& site, std::string_view between,
                         std::string_view after) {
        text.put(FMT_COMPILE("{}{}{}"), before, fmt::join(numbers_of(site), between), after);
    };
    switch (format) {
        case SitesFormat::text:
            for (const S& site : sites) put("", site, " ", "\n");
            break;
        case SitesFormat::csv:
            text.put(header);
            for (const S& site : sites) put("", site, ",", "\n");
            break;
        case SitesFormat::json: {
            std::string_view before = "[[";
            for (const S& site : sites) {
                put(before, site, ", ", "]");
                before = ",\n[";
            }
            text.put("]\n");
            break;
        }
    }
    text.flush();
}

}  // namespace

void write_sites(std::ostream& out, std::span<const Site> sites, SitesFormat format) {
    write(out, sites, format, "x,y,r\n");
}

void write_sites(std::ostream& out, std::span<const Site3> sites, SitesFormat format) {
    write(out, sites, format, "x,y,z,r\n");
}

}  // namespace signum
