#include "read_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "errors.hpp"
#include "input_file.hpp"
#include "number.hpp"
#include "read_sites.hpp"

namespace signum {
namespace faces {
namespace {

constexpr std::string_view kind = "a file of faces";

/// Takes rows as they come: all of three numbers, or all of four.
class Rows {
 public:
    explicit Rows(const InputFile& file) : file_(file) {}

    void add(const std::vector<std::int64_t>& row, Position position) {
        if (row.size() != 3 && row.size() != 4)
            file_.fail(position,
                       fmt::format("a face has three points and a cell four, not {}", row.size()));
        if (result_.size() > 0 && (row.size() == 3) != result_.cells.empty())
            file_.fail(position,
                       fmt::format("{} points, where the rows before have {}: faces and cells do "
                                   "not come together",
                                   row.size(), result_.cells.empty() ? 3 : 4));
        for (const std::int64_t number : row)
            if (number < std::numeric_limits<Index>::min() ||
                number > std::numeric_limits<Index>::max())
                file_.fail(position, fmt::format("{} is no number of a point", number));
        const auto put = [&](auto& rows) {
            auto& to = rows.emplace_back();
            for (std::size_t k = 0; k < to.size(); ++k)
                to[k] = static_cast<Index>(row[k] - (result_.are_from_one ? 1 : 0));
        };
        if (row.size() == 3)
            put(result_.faces);
        else
            put(result_.cells);
    }
    void begin_from_one() { result_.are_from_one = true; }
    [[nodiscard]] FacesFile finished() { return std::move(result_); }

 private:
    const InputFile& file_;
    FacesFile result_;
};

/// A line as words between blanks, commas and semicolons, each with its column.
struct Word {
    std::string_view text;
    std::int64_t column;
};
class Lines {
 public:
    explicit Lines(InputFile& file) : file_(file) {}
    /// The next line that has a word before `comment`; false at the end.
    bool next(char comment = '#') {
        std::string_view line;
        while (file_.next_line(line, "one face a line, three or four numbers")) {
            ++number_;
            words_.clear();
            const std::string_view separators = " \t,;";
            for (std::size_t at = 0; at < line.size();) {
                at = line.find_first_not_of(separators, at);
                if (at == std::string_view::npos || line[at] == comment) break;
                const std::size_t end = std::min(line.find_first_of(separators, at), line.size());
                words_.push_back({line.substr(at, end - at), static_cast<std::int64_t>(at) + 1});
                at = end;
            }
            if (!words_.empty()) return true;
        }
        return false;
    }
    [[nodiscard]] const std::vector<Word>& words() const { return words_; }
    [[nodiscard]] Position position(std::size_t word = 0) const {
        return {number_, word < words_.size() ? words_[word].column : 1};
    }
    [[nodiscard]] std::optional<std::int64_t> if_number(std::size_t word) const {
        const std::string_view text = words_[word].text;
        const bool is_negative = text.starts_with('-');
        const auto number = parse_whole_number(text.substr(is_negative ? 1 : 0));
        if (!number || *number > std::uint64_t{1} << 62) return std::nullopt;
        const auto value = static_cast<std::int64_t>(*number);
        return is_negative ? -value : value;
    }
    [[nodiscard]] std::int64_t number(std::size_t word) const {
        if (word >= words_.size()) file_.fail(position(), "the line is too short");
        const auto value = if_number(word);
        if (!value)
            file_.fail(position(word), fmt::format("{} is no whole number, the number of a point",
                                                   in_quotes(words_[word].text)));
        return *value;
    }
    /// So many numbers from a word on.
    [[nodiscard]] std::vector<std::int64_t> numbers(std::size_t from, std::size_t count) const {
        std::vector<std::int64_t> row;
        for (std::size_t k = 0; k < count; ++k) row.push_back(number(from + k));
        return row;
    }

 private:
    InputFile& file_;
    std::vector<Word> words_;
    std::int64_t number_ = 0;
};

/// Three or four numbers a line; a first line without any is a head.
FacesFile read_rows(InputFile& file) {
    Rows rows(file);
    Lines lines(file);
    for (bool is_first = true; lines.next(); is_first = false) {
        if (is_first && !lines.if_number(0)) continue;
        rows.add(lines.numbers(0, lines.words().size()), lines.position());
    }
    return rows.finished();
}

/// How many, of how many points each, with how many attributes; then a number, points, attributes.
FacesFile read_ele(InputFile& file) {
    Rows rows(file);
    Lines lines(file);
    if (!lines.next()) return rows.finished();
    const std::int64_t count = lines.number(0);
    const std::int64_t corners = lines.words().size() > 1 ? lines.number(1) : 3;
    if (corners != 3 && corners != 4 && corners != 6 && corners != 10)
        file.fail(
            lines.position(1),
            fmt::format("{} points of each; triangles have 3 or 6, tetrahedra 4 or 10", corners));
    // Of six (ten) the first three (four) are corners, the others on edges.
    const std::size_t size = corners == 4 || corners == 10 ? 4 : 3;
    for (std::int64_t k = 0; k < count; ++k) {
        if (!lines.next())
            file.fail(lines.position(), fmt::format("{} of {} elements are here", k, count));
        if (k == 0 && lines.number(0) == 1) rows.begin_from_one();
        rows.add(lines.numbers(1, size), lines.position());
    }
    return rows.finished();
}

/// f a b c, or a/t/n; negative ones count back from the last point before.
FacesFile read_obj(InputFile& file) {
    Rows rows(file);
    Lines lines(file);
    rows.begin_from_one();
    std::int64_t points = 0;
    while (lines.next()) {
        const std::string_view what = lines.words()[0].text;
        points += what == "v" ? 1 : 0;
        if (what != "f") continue;
        std::vector<std::int64_t> row;
        for (std::size_t word = 1; word < lines.words().size(); ++word) {
            const std::string_view text = lines.words()[word].text;
            const std::string_view first = text.substr(0, text.find('/'));
            const bool is_back = first.starts_with('-');
            const auto number = parse_whole_number(first.substr(is_back ? 1 : 0));
            if (!number || *number > std::uint64_t{1} << 32)
                file.fail(lines.position(word),
                          fmt::format("{} is no number of a point", in_quotes(text)));
            row.push_back(is_back ? points + 1 - static_cast<std::int64_t>(*number)
                                  : static_cast<std::int64_t>(*number));
        }
        if (row.size() != 3)
            file.fail(lines.position(),
                      fmt::format("a face of {} points; triangles are judged", row.size()));
        rows.add(row, lines.position());
    }
    return rows.finished();
}

FacesFile read_ply(InputFile& file) {
    Rows rows(file);
    Lines lines(file);
    std::int64_t before = 0;
    std::int64_t faces = -1;
    while (lines.next('\0') && lines.words()[0].text != "end_header") {
        const auto& words = lines.words();
        if (words[0].text == "format" && words.size() > 1 && words[1].text != "ascii")
            file.fail(lines.position(1),
                      fmt::format("PLY {}; that of text is read, ascii", in_quotes(words[1].text)));
        if (words[0].text != "element" || words.size() < 3) continue;
        if (words[1].text == "face")
            faces = lines.number(2);
        else if (faces < 0)
            before += lines.number(2);
    }
    if (faces < 0) file.fail(lines.position(), "no element face in its head");
    for (std::int64_t k = 0; k < before && lines.next('\0'); ++k) {
    }
    for (std::int64_t k = 0; k < faces; ++k) {
        if (!lines.next('\0'))
            file.fail(lines.position(), fmt::format("{} of {} faces are here", k, faces));
        const std::int64_t size = lines.number(0);
        if (size != 3)
            file.fail(lines.position(),
                      fmt::format("a face of {} points; triangles are judged", size));
        rows.add(lines.numbers(1, 3), lines.position());
    }
    return rows.finished();
}

/// POLYGONS or CELLS of a legacy file of text: the size of each, and its points.
FacesFile read_vtk(InputFile& file) {
    Rows rows(file);
    Lines lines(file);
    while (lines.next()) {
        const std::string what(lines.words()[0].text);
        if (what == "BINARY")
            file.fail(lines.position(), "legacy VTK of bytes; that of text is read");
        if (what != "POLYGONS" && what != "CELLS") continue;
        const std::int64_t count = lines.number(1);
        for (std::int64_t k = 0; k < count; ++k) {
            if (!lines.next())
                file.fail(lines.position(), fmt::format("{} of {} cells are here", k, count));
            if (!lines.if_number(0))
                file.fail(lines.position(),
                          "cells by OFFSETS and CONNECTIVITY (VTK 5); write the version 4 of the "
                          "format, or .npy");
            const std::int64_t size = lines.number(0);
            if (size != 3 && (size != 4 || what == "POLYGONS"))
                file.fail(lines.position(),
                          fmt::format("a {} of {} points; triangles and tetrahedra are judged",
                                      what == "POLYGONS" ? "polygon" : "cell", size));
            rows.add(lines.numbers(1, static_cast<std::size_t>(size)), lines.position());
        }
        // A cell of four points may be a quadrangle. CELL_TYPES says what each cell is.
        while (lines.next() && lines.words()[0].text == "CELL_TYPES")
            while (lines.next() && lines.if_number(0))
                for (std::size_t word = 0; word < lines.words().size(); ++word)
                    if (const std::int64_t type = lines.number(word); type != 5 && type != 10)
                        file.fail(
                            lines.position(word),
                            fmt::format("a cell of type {}; triangles (5) and tetrahedra (10) "
                                        "are judged",
                                        type));
        return rows.finished();
    }
    file.fail(lines.position(), "neither POLYGONS nor CELLS in it");
}

FacesFile read_json(InputFile& file) {
    std::string text;
    for (std::string_view block; !(block = file.next_block()).empty();) text += block;
    nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
    if (json.is_discarded()) throw InputError(file.path(), "this is no JSON");
    bool is_ours = false;
    if (json.is_object()) {
        is_ours = json.value("format", "").starts_with("signum.");
        const char* found = nullptr;
        for (const char* const name : {"simplices", "cells", "faces", "triangles"})
            if (found == nullptr && json.contains(name)) found = name;
        if (found == nullptr)
            throw InputError(file.path(),
                             "an object without \"simplices\", \"faces\", \"cells\" or "
                             "\"triangles\"");
        json = nlohmann::json(json[found]);
    }
    Rows rows(file);
    if (!json.is_array()) throw InputError(file.path(), "faces are rows: [[0, 1, 2], ...]");
    for (std::size_t k = 0; k < json.size(); ++k) {
        std::vector<std::int64_t> row;
        bool is_row = json[k].is_array();
        for (const auto& each : json[k]) {
            is_row &= each.is_number_integer();
            if (is_row) row.push_back(each.get<std::int64_t>());
        }
        if (!is_row)
            throw InputError(file.path(), fmt::format("row {} is no row of whole numbers", k));
        // What triangulate writes has faces at infinity, too.
        if (is_ours && std::ranges::find(row, -1) != row.end()) continue;
        rows.add(row, {1, 1});
    }
    return rows.finished();
}

/// As an array of sites, whose numbers it has.
FacesFile read_array(const std::string& path) {
    const InputFile file(path, kind, Contents::bytes);
    Rows rows(file);
    const SitesFile read = [&] {
        try {
            return read_sites(path, {.input = input_by_ending("npy")});
        } catch (const InputError&) {
            throw InputError(path,
                             "no array of rows of three or four whole numbers, which are the "
                             "numbers of points");
        }
    }();
    const auto add = [&](std::initializer_list<double> numbers, std::size_t k) {
        std::vector<std::int64_t> row;
        for (const double number : numbers) {
            if (number != std::floor(number) || std::fabs(number) > 0x1p53)
                throw InputError(file.path(),
                                 fmt::format("row {}: {} is no whole number", k, number));
            row.push_back(static_cast<std::int64_t>(number));
        }
        rows.add(row, {static_cast<std::int64_t>(k) + 1, 1});
    };
    for (std::size_t k = 0; k < read.sites.size(); ++k)
        add({read.sites[k].x, read.sites[k].y, read.sites[k].r}, k);
    for (std::size_t k = 0; k < read.in_space.size(); ++k) {
        const Site3& s = read.in_space[k];
        add({s.x, s.y, s.z, s.r}, k);
    }
    return rows.finished();
}

}  // namespace
}  // namespace faces

bool is_ending_of_faces(std::string_view ending) noexcept {
    constexpr std::array<std::string_view, 5> endings = {"npy", "ele", "obj", "ply", "vtk"};
    return std::ranges::find(endings, ending) != endings.end();
}

FacesFile read_faces(const std::string& path) {
    using namespace faces;
    const std::string ending = ending_of_input(path);
    if (ending == "npy") return read_array(path);
    InputFile file(path, kind);
    if (ending == "json") return read_json(file);
    if (ending == "ele") return read_ele(file);
    if (ending == "obj") return read_obj(file);
    if (ending == "ply") return read_ply(file);
    if (ending == "vtk") return read_vtk(file);
    return read_rows(file);
}

}  // namespace signum
