#include "write_sites.hpp"

#include <array>

#include "array_writer.hpp"
#include "text_writer.hpp"

namespace signum {
namespace {

/// As double, or as JsonNumber.
template <class Number>
std::array<Number, 3> numbers_of(const Site& site) noexcept {
    return {Number{site.x}, Number{site.y}, Number{site.r}};
}
template <class Number>
std::array<Number, 4> numbers_of(const Site3& site) noexcept {
    return {Number{site.x}, Number{site.y}, Number{site.z}, Number{site.r}};
}

template <class S>
void write(std::ostream& out, std::span<const S> sites, SitesFormat format, int first,
           std::string_view header) {
    constexpr std::size_t width = sizeof(S) / sizeof(double);
    if (format == SitesFormat::npy) put_npy_head(out, "f8", sites.size(), width);
    if (format == SitesFormat::npy || format == SitesFormat::f64) return put_bytes(out, sites);
    TextWriter text(out);
    const auto put = [&](const S& site, std::string_view between) {
        text.put(FMT_COMPILE("{}\n"), fmt::join(numbers_of<double>(site), between));
    };
    switch (format) {
        case SitesFormat::text:
            for (const S& site : sites) put(site, " ");
            break;
        case SitesFormat::csv:
            text.put(header);
            for (const S& site : sites) put(site, ",");
            break;
        case SitesFormat::json: {
            std::string_view before = "[[";
            for (const S& site : sites) {
                text.put(FMT_COMPILE("{}{}]"), before,
                         fmt::join(numbers_of<JsonNumber>(site), ", "));
                before = ",\n[";
            }
            text.put("]\n");
            break;
        }
        case SitesFormat::npy:
        case SitesFormat::f64:
            break;
        case SitesFormat::node:
            text.put(FMT_COMPILE("{} {} 1 0\n"), sites.size(), width - 1);
            for (std::size_t i = 0; i < sites.size(); ++i) {
                text.put(FMT_COMPILE("{}"), i + static_cast<std::size_t>(first));
                for (const double number : numbers_of<double>(sites[i]))
                    text.put(FMT_COMPILE(" {}"), number);
                text.put("\n");
            }
            break;
    }
    text.flush();
}

}  // namespace

void write_sites(std::ostream& out, std::span<const Site> sites, SitesFormat format, int first) {
    write(out, sites, format, first, "x,y,r\n");
}

void write_sites(std::ostream& out, std::span<const Site3> sites, SitesFormat format, int first) {
    write(out, sites, format, first, "x,y,z,r\n");
}

}  // namespace signum
