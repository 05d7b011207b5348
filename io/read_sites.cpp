#include <fmt/format.h>

#include "../core/index.hpp"
#include "input_file.hpp"
#include "json_sites.hpp"
#include "read_sites.hpp"
#include "text_sites.hpp"

namespace signum {

SitesFile read_sites(const std::string& path, const Columns& columns) {
    InputFile file(path, "a file of sites");
    const char first = file.first_character();
    SitesFile result = first == '[' || first == '{' ? read_json_sites(file, columns)
                                                    : read_text_sites(file, columns);
    if (static_cast<std::int64_t>(result.sites.size()) > max_sites) {
        file.fail({}, fmt::format("{} sites; {} is the most that 32-bit indices allow",
                                  result.sites.size(), max_sites));
    }
    return result;
}

StridedSites strided_view(std::span<const Site> sites, WeightIs third) noexcept {
    if (sites.empty()) return {};
    const Site& first = sites.front();
    return {sites.size(), sizeof(Site), &first.x, &first.y, &first.r, third == WeightIs::weight};
}

}  // namespace signum
