#include "plain_lines.hpp"

#include <algorithm>

#include "../../core/parallel.hpp"
#include "number.hpp"
#include "threads.hpp"

namespace signum {
namespace {

constexpr auto separators = [] {
    std::array<bool, 256> table{};
    for (const char c : {' ', '\t', ',', ';'}) table[static_cast<unsigned char>(c)] = true;
    return table;
}();
bool is_separator(char c) noexcept {
    return separators[static_cast<unsigned char>(c)];
}

/// Reads lines one after the other.
class PlainReader {
 public:
    PlainReader(std::string_view text, const PlainLayout& layout) : text_(text), layout_(layout) {
        read_.sites.reserve(text.size() / 32);
    }

    /// As far as they are plain; whether all are.
    bool read() {
        while (read_.bytes < text_.size()) {
            const std::size_t end = text_.find('\n', read_.bytes);
            if (end == std::string_view::npos) break;
            std::string_view line = text_.substr(read_.bytes, end - read_.bytes);
            if (line.ends_with('\r')) line.remove_suffix(1);
            if (!read_line(line)) return false;
            read_.bytes = end + 1;
            ++read_.lines;
        }
        return true;
    }
    [[nodiscard]] PlainLines& result() noexcept { return read_; }

 private:
    bool read_line(std::string_view line) {
        constexpr std::size_t longest = 1000;
        if (line.size() > longest) return false;
        std::array<double, 4> numbers = {};
        std::size_t columns = 0;
        char separator = layout_.separator;
        for (std::size_t begin = line.find_first_not_of(' ');;) {
            if (begin == std::string_view::npos) return false;
            std::size_t end = begin;
            while (end < line.size() && !is_separator(line[end])) ++end;
            if (columns == layout_.most || !take(line.substr(begin, end - begin), columns, numbers))
                return false;
            ++columns;
            if (end == line.size()) break;
            if (separator == '\0') separator = line[end];
            if (line[end] != separator) return false;
            // Blanks may follow a separator. Where they are it, they may end the line; elsewhere a
            // column would be empty.
            begin = line.find_first_not_of(' ', end + 1);
            if (begin == std::string_view::npos && separator == ' ') break;
        }
        if (columns < layout_.least) return false;
        for (std::size_t which = 0; which < layout_.coordinates; ++which)
            if (layout_.places[which] >= columns) return false;
        if (layout_.places[layout_.coordinates] < columns)
            read_.has_radii = true;
        else if (layout_.has_radius)
            return false;
        read_.sites.push_back(numbers);
        return true;
    }
    /// A column that is a number; false where it is none, or asks for a word about it.
    bool take(std::string_view digits, std::size_t column, std::array<double, 4>& numbers) const {
        const Number number = parse_number(digits);
        if (number.fault != NumberFault::none) return false;
        for (std::size_t which = 0; which <= layout_.coordinates; ++which) {
            if (layout_.places[which] != column) continue;
            if (is_beyond_single(number.value) && !layout_.may_be_beyond_single) return false;
            if (which == layout_.coordinates && number.value < 0.0 && !layout_.may_be_negative)
                return false;
            numbers[which] = number.value;
        }
        return true;
    }

    std::string_view text_;
    const PlainLayout& layout_;
    PlainLines read_;
};

}  // namespace

PlainLines read_plain_lines(std::string_view text, const PlainLayout& layout) {
    constexpr std::size_t piece = std::size_t{1} << 17;
    const std::size_t pieces = text.size() / piece + 1;
    std::vector<std::size_t> begins = {0};
    for (std::size_t k = 1; k < pieces; ++k) {
        const std::size_t end = text.find('\n', text.size() * k / pieces);
        begins.push_back(end == std::string_view::npos ? text.size() : end + 1);
    }
    begins.push_back(text.size());

    std::vector<PlainReader> readers;
    for (std::size_t k = 0; k < pieces; ++k)
        readers.emplace_back(text.substr(begins[k], std::max(begins[k], begins[k + 1]) - begins[k]),
                             layout);
    std::vector<char> is_plain(pieces);
    const Workers workers(threads_of_files, text.size() / 16);
    workers.each(pieces, [&](std::size_t k) { is_plain[k] = readers[k].read() ? 1 : 0; });

    PlainLines all;
    for (std::size_t k = 0; k < pieces; ++k) {
        const PlainLines& read = readers[k].result();
        all.sites.insert(all.sites.end(), read.sites.begin(), read.sites.end());
        all.bytes += read.bytes;
        all.lines += read.lines;
        all.has_radii = all.has_radii || read.has_radii;
        if (is_plain[k] == 0) break;
    }
    return all;
}

}  // namespace signum
