#include "coordinate_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <vector>

namespace signum {
namespace {

struct Word {
    std::string_view word;
    CoordinateName is;
};
constexpr auto words = std::to_array<Word>({
    {"x", {NameFamily::letters, 0}},
    {"y", {NameFamily::letters, 1}},
    {"z", {NameFamily::letters, 2}},
    {"easting", {NameFamily::projected, 0}},
    {"eastings", {NameFamily::projected, 0}},
    {"east", {NameFamily::projected, 0}},
    {"rechtswert", {NameFamily::projected, 0}},
    {"e", {NameFamily::initials, 0}},
    {"n", {NameFamily::initials, 1}},
    {"northing", {NameFamily::projected, 1}},
    {"northings", {NameFamily::projected, 1}},
    {"north", {NameFamily::projected, 1}},
    {"hochwert", {NameFamily::projected, 1}},
    {"lon", {NameFamily::geographic, 0}},
    {"lng", {NameFamily::geographic, 0}},
    {"long", {NameFamily::geographic, 0}},
    {"longitude", {NameFamily::geographic, 0}},
    {"longitud", {NameFamily::geographic, 0}},
    {"lat", {NameFamily::geographic, 1}},
    {"latitude", {NameFamily::geographic, 1}},
    {"latitud", {NameFamily::geographic, 1}},
});

/// What stands beside such a word without changing its meaning, and units.
constexpr auto companions = std::to_array<std::string_view>(
    {"coord",  "coords",  "coordinate", "coordinates", "coor",    "pos",      "position", "point",
     "pt",     "loc",     "location",   "center",      "centre",  "centroid", "cen",      "geo",
     "gps",    "map",     "proj",       "projected",   "utm",     "wgs",      "wgs84",    "epsg",
     "4326",   "3857",    "lambert",    "l93",         "osgb",    "bng",      "mga",      "gda94",
     "etrs89", "decimal", "dec",        "dd",          "deg",     "degree",   "degrees",  "stop",
     "site",   "station", "place",      "venue",       "m",       "meter",    "meters",   "metre",
     "metres", "km",      "cm",         "mm",          "um",      "nm",       "ft",       "feet",
     "px",     "pixel",   "pixels",     "micron",      "microns", "angstrom", "a",        "in"});

bool is_companion(std::string_view word) {
    return std::ranges::count(companions, word) > 0;
}
const Word* word_of(std::string_view word) {
    const auto found = std::ranges::find(words, word, &Word::word);
    return found == words.end() ? nullptr : &*found;
}

/// Words of letters and digits, in small letters; a capital behind a small letter begins one, as in
/// decimalLatitude.
std::vector<std::string> words_in(std::string_view name) {
    std::vector<std::string> result;
    bool is_inside = false;
    char before = '\0';
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        const bool is_part = std::isalnum(byte) != 0;
        const bool is_hump =
            std::isupper(byte) != 0 && std::islower(static_cast<unsigned char>(before)) != 0;
        if (is_part && (!is_inside || is_hump)) result.emplace_back();
        if (is_part) result.back() += static_cast<char>(std::tolower(byte));
        is_inside = is_part;
        before = c;
    }
    return result;
}

/// xcoord, coordx: a word with a companion grown to it.
const Word* word_grown_together(std::string_view word) {
    for (const std::string_view companion : companions) {
        if (companion.size() < 3 || word.size() <= companion.size()) continue;
        if (word.starts_with(companion))
            if (const Word* found = word_of(word.substr(companion.size()))) return found;
        if (word.ends_with(companion))
            if (const Word* found = word_of(word.substr(0, word.size() - companion.size())))
                return found;
    }
    return nullptr;
}

}  // namespace

std::optional<CoordinateName> coordinate_named(std::string_view name) {
    std::optional<CoordinateName> result;
    for (const std::string& word : words_in(name)) {
        const Word* found = word_of(word);
        if (found == nullptr && is_companion(word)) continue;
        if (found == nullptr) found = word_grown_together(word);
        if (found == nullptr || result) return std::nullopt;
        result = found->is;
    }
    return result;
}

bool is_name_of_identifier(std::string_view name) {
    constexpr auto identifiers = std::to_array<std::string_view>(
        {"",       "#",     "id",       "ids",    "fid",    "oid", "gid",
         "uid",    "pid",   "objectid", "object", "index",  "idx", "row",
         "rownum", "nr",    "no",       "num",    "number", "key", "code",
         "rank",   "count", "unnamed",  "0",      "ogc",    "sn",  "serial"});
    const std::vector<std::string> parts = words_in(name);
    std::string letters;
    for (const std::string& part : parts) letters += part;
    if (std::ranges::count(identifiers, letters) > 0) return true;
    return std::ranges::any_of(parts, [](const std::string& part) {
        return part == "id" || part == "fid" || part == "index" || part == "unnamed";
    });
}

}  // namespace signum
