#include "text_slice.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "input_file.hpp"
#include "plain_lines.hpp"

namespace signum {
namespace {

/// Lines that begin in a stretch of the file's bytes.
class Lines {
 public:
    Lines(const std::string& name, std::uint64_t number, std::uint64_t of)
        : name_(name), line_(InputFile::longest_line + 2, '\0') {
        // Says what is wrong with the name, and refuses UTF-16.
        const InputFile file(name, "a file of sites");
        const auto size = file.size();
        if (!size) throw InputError(name, "this is no regular file; several ranks read one");
        input_.open(name, std::ios::binary);
        begin_ = *size * number / of;
        end_ = *size * (number + 1) / of;
        if (begin_ > 0) {
            // A line belongs to the slice in which it begins.
            input_.seekg(static_cast<std::streamoff>(--begin_));
            next_line();
        } else {
            has_start_ = end_ > 0;
            if (file.first_bytes().starts_with("\xEF\xBB\xBF")) begin_ = 3;
            input_.seekg(static_cast<std::streamoff>(begin_));
        }
    }
    /// Whether the file's first line is in it.
    [[nodiscard]] bool has_start() const noexcept { return has_start_; }

    /// Calls take(line) for each line.
    template <class Take>
    void each_line(const Take& take) {
        while (begin_ < end_) take(next_line());
    }

 private:
    std::string_view next_line() {
        input_.getline(line_.data(), static_cast<std::streamsize>(line_.size()));
        const auto count = static_cast<std::size_t>(input_.gcount());
        if (input_.bad() || (count == 0 && !input_.eof()))
            throw MachineError("cannot read " + name_);
        if (input_.fail() && !input_.eof())
            throw InputError(name_,
                             fmt::format("a line of more than {} bytes, at byte {}; a site a "
                                         "line is expected",
                                         InputFile::longest_line, begin_));
        begin_ = input_.eof() ? std::max(end_, begin_ + count) : begin_ + count;
        std::string_view line(line_.data(), input_.eof() ? count : count - 1);
        if (line.ends_with('\r')) line.remove_suffix(1);
        return line;
    }

    std::string name_;
    std::string line_;
    std::ifstream input_;
    std::uint64_t begin_ = 0;
    std::uint64_t end_ = 0;
    bool has_start_ = false;
};

/// A header that says no more than what would be taken anyhow.
bool is_header(std::string_view line, int dimension) {
    // Names, parted by commas whatever parts them.
    std::string names;
    bool is_parted = false;
    // Since the last name: between two, before the first and behind the last a column would be
    // empty.
    int marks = 0;
    for (const char c : line) {
        if (c == '"') continue;
        if (c == ' ' || c == '\t' || c == ',' || c == ';') {
            is_parted = true;
            marks += c == ',' || c == ';' ? 1 : 0;
            continue;
        }
        if (marks > (names.empty() ? 0 : 1)) return false;
        if (is_parted && !names.empty()) names += ',';
        is_parted = false;
        marks = 0;
        names += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    if (marks > 0) return false;
    const std::string_view axes = dimension == 3 ? "x,y,z" : "x,y";
    if (!names.starts_with(axes)) return false;
    names.erase(0, axes.size());
    return names.empty() || names == ",r" || names == ",radius";
}

}  // namespace

TextSlice read_text_slice(const std::string& name, int dimension, std::uint64_t number,
                          std::uint64_t of) {
    const bool is_space = dimension == 3;
    const auto coordinates = static_cast<std::size_t>(dimension);
    const PlainLayout layout = {
        .places = {0, 1, 2, is_space ? 3 : std::numeric_limits<std::size_t>::max()},
        .coordinates = coordinates,
        .least = coordinates,
        .most = coordinates + 1,
        .separator = '\0',
        .has_radius = false,
        .may_be_negative = true,
        .may_be_beyond_single = true};
    TextSlice slice;
    std::string text;
    const auto read = [&] {
        const PlainLines plain = read_plain_lines(text, layout);
        for (const auto& [x, y, third, fourth] : plain.sites)
            slice.sites.push_back(is_space ? Site3{x, y, third, fourth} : Site3{x, y, 0.0, third});
        slice.has_radii = slice.has_radii || plain.has_radii;
        if (plain.bytes < text.size() && !slice.wrong) slice.wrong = slice.lines + plain.lines;
        slice.lines += std::ranges::count(text, '\n');
        text.clear();
    };
    Lines lines(name, number, of);
    bool is_first = lines.has_start();
    lines.each_line([&](std::string_view line) {
        const bool says_nothing =
            line.find_first_not_of(" \t") == std::string_view::npos || line.starts_with('#');
        const bool is_title = !says_nothing && is_first && is_header(line, dimension);
        is_first = is_first && says_nothing;
        if (says_nothing || is_title) {
            read();
            ++slice.lines;
            return;
        }
        text += line;
        text += '\n';
        if (text.size() > std::size_t{1} << 20) read();
    });
    read();
    return slice;
}

InputError wrong_line(const std::string& name, int dimension, std::int64_t lines_before,
                      const TextSlice& slice) {
    const Position position = {lines_before + slice.wrong.value_or(0) + 1, 1};
    if (dimension == 3)
        return {name, position,
                "in slices, lines of three or four numbers are read, x, y, z and perhaps r, under "
                "a header of these names or none"};
    return {name, position,
            "in slices, lines of two or three numbers are read, x y and perhaps r, under a header "
            "of these names or none"};
}

}  // namespace signum
