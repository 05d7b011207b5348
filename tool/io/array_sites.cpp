/// Sites from arrays of numbers: NumPy's .npy, of versions 1 to 3, and the same without a head.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "../../core/index.hpp"
#include "number.hpp"
#include "sites_readers.hpp"

namespace signum {
namespace {

using namespace std::string_view_literals;

/// A type of numbers, as NumPy names it without the order of bytes.
struct NumberType {
    std::string_view name;
    std::size_t bytes;
    double (*read)(const char*);  ///< of the machine's own order of bytes
};

template <class Number>
double number_at(const char* bytes) {
    Number number;
    std::memcpy(&number, bytes, sizeof number);
    return static_cast<double>(number);
}
template <class Number>
constexpr NumberType type_named(std::string_view name) {
    return {name, sizeof(Number), number_at<Number>};
}
constexpr std::array types = {
    type_named<double>("f8"),        type_named<float>("f4"),
    type_named<std::int8_t>("i1"),   type_named<std::int16_t>("i2"),
    type_named<std::int32_t>("i4"),  type_named<std::int64_t>("i8"),
    type_named<std::uint8_t>("u1"),  type_named<std::uint16_t>("u2"),
    type_named<std::uint32_t>("u4"), type_named<std::uint64_t>("u8"),
};

/// The bytes of a file one after the other.
class Bytes {
 public:
    explicit Bytes(InputFile& file) : file_(file) {}

    /// How many of them there were: fewer than wanted at the end of the file.
    std::size_t read(char* to, std::size_t wanted) {
        std::size_t count = 0;
        while (count < wanted) {
            if (block_.empty() && (block_ = file_.next_block()).empty()) break;
            const std::size_t step = std::min(wanted - count, block_.size());
            std::memcpy(to + count, block_.data(), step);
            block_.remove_prefix(step);
            count += step;
        }
        return count;
    }
    /// Passes over so many.
    void skip(std::uint64_t bytes) {
        const auto ahead = std::min<std::uint64_t>(bytes, block_.size());
        block_.remove_prefix(ahead);
        file_.skip(bytes - ahead);
    }

 private:
    InputFile& file_;
    std::string_view block_;
};

/// What the head of an array says.
struct Head {
    std::string type;         ///< as in '<f8'
    bool has_fields = false;  ///< then nothing else is told
    bool is_by_columns = false;
    std::vector<std::uint64_t> shape;
};

/// Reads the dictionary of a head: {'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }.
class Dictionary {
 public:
    explicit Dictionary(std::string_view text) : rest_(text) {}

    /// Nothing where it is another text.
    std::optional<Head> read() {
        Head head;
        int seen = 0;
        if (!take("{")) return std::nullopt;
        while (!take("}")) {
            const auto key = word();
            if (!key || !take(":")) return std::nullopt;
            if (*key == "descr") {
                head.has_fields = take("[");
                if (head.has_fields) return head;
                const auto type = word();
                if (!type) return std::nullopt;
                head.type = *type;
            } else if (*key == "fortran_order") {
                head.is_by_columns = take("True");
                if (!head.is_by_columns && !take("False")) return std::nullopt;
            } else if (*key != "shape" || !read_shape(head.shape)) {
                return std::nullopt;
            }
            ++seen;
            take(",");
        }
        skip_blanks();
        if (seen != 3 || head.type.empty() || !rest_.empty()) return std::nullopt;
        return head;
    }

 private:
    void skip_blanks() {
        rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size()));
    }
    bool take(std::string_view word) {
        skip_blanks();
        if (!rest_.starts_with(word)) return false;
        rest_.remove_prefix(word.size());
        return true;
    }
    std::optional<std::string> word() {
        skip_blanks();
        if (rest_.empty() || (rest_[0] != '\'' && rest_[0] != '"')) return std::nullopt;
        const std::size_t end = rest_.find(rest_[0], 1);
        if (end == std::string_view::npos) return std::nullopt;
        std::string result(rest_.substr(1, end - 1));
        rest_.remove_prefix(end + 1);
        return result;
    }
    bool read_shape(std::vector<std::uint64_t>& shape) {
        if (!take("(")) return false;
        while (!take(")")) {
            skip_blanks();
            const std::size_t digits =
                std::min(rest_.find_first_not_of("0123456789"), rest_.size());
            const auto number = parse_whole_number(rest_.substr(0, digits));
            if (!number) return false;
            shape.push_back(*number);
            rest_.remove_prefix(digits);
            take(",");
        }
        return true;
    }

    std::string_view rest_;
};

class ArraySites {
 public:
    ArraySites(InputFile& file, const ReadOptions& options)
        : file_(file), bytes_(file), options_(options) {}

    SitesFile read_npy() {
        const Head head = read_head();
        if (head.has_fields)
            fail(
                "an array of fields with names; sites are rows of numbers, an array of two axes: "
                "save numpy.stack([a['x'], a['y']], axis=1)");
        choose_type(head.type);
        if (head.shape.size() != 2)
            fail(
                fmt::format("an array of shape ({}); sites are rows of numbers, an array of two "
                            "axes",
                            fmt::join(head.shape, ", ")));
        choose_columns(head.shape[1]);
        constexpr auto too_many = static_cast<std::uint64_t>(max_sites) + 1;  // the caller says so
        rows_ = std::min(head.shape[0], too_many);
        if (rows_ == 0) fail("no site in this file");
        const bool is_share = options_.share.of > 1;
        if (is_share) {
            if (head.is_by_columns)
                fail(
                    "an array by columns; shares of one by rows are read: save "
                    "numpy.ascontiguousarray(array)");
            take_share(head.shape[0]);
        }
        if (head.is_by_columns)
            read_columns();
        else
            read_rows();
        char more = 0;
        if (!is_share && rows_ < too_many && bytes_.read(&more, 1) > 0)
            fail(fmt::format("bytes beyond the array of shape ({}, {})", rows_, columns_));
        return finished();
    }

    SitesFile read_without_head() {
        type_ = &types[0];
        choose_columns(options_.dimension == 3 ? 4 : 3);
        rows_ =
            static_cast<std::uint64_t>(max_sites) + 1;  // the caller says that these are too many
        is_open_ = options_.share.of == 1;
        if (!is_open_) {
            const std::uint64_t row = columns_ * type_->bytes;
            const std::uint64_t bytes = file_.size().value_or(0);
            if (bytes % row != 0) {
                is_open_ = true;
                fail_within(bytes / row);
            }
            take_share(bytes / row);
        }
        read_rows();
        if (size() == 0 && is_open_) fail("no site in this file");
        return finished();
    }

 private:
    [[noreturn]] void fail(std::string_view message) const {
        throw InputError(file_.path(), message);
    }

    Head read_head() {
        constexpr std::string_view magic = "\x93NUMPY";
        std::array<char, 12> start{};
        // Of version 1 the length takes two bytes, of later ones four.
        const auto read = [&](std::size_t from, std::size_t count) {
            return bytes_.read(start.data() + from, count) == count;
        };
        if (!read(0, 8) || !std::string_view(start.data(), start.size()).starts_with(magic))
            fail(
                "this is no array of NumPy's, which begins with a byte 93 and NUMPY; if it is "
                "text, add --read-as text");
        const int version = start[6];
        if (version < 1 || version > 3)
            fail(fmt::format("version {} of the format .npy; 1 to 3 are read", version));
        const std::size_t digits = version == 1 ? 2 : 4;
        bool is_whole = read(8, digits);
        std::size_t length = 0;
        for (std::size_t i = digits; i-- > 0;)
            length = length << 8 | static_cast<unsigned char>(start[8 + i]);
        constexpr std::size_t longest = 65'536;
        if (length > longest)
            fail(fmt::format("a head of {} bytes; the longest that is read has {}", length,
                             longest));
        std::string text(length, '\0');
        is_whole = is_whole && bytes_.read(text.data(), length) == length;
        if (!is_whole) fail("the file ends within its head");
        const auto head = Dictionary(text).read();
        if (!head) fail(fmt::format("its head is none that NumPy writes: {}", in_quotes(text)));
        return *head;
    }

    void choose_type(std::string_view type) {
        const char order = type.empty() ? ' ' : type.front();
        const auto* const found = std::ranges::find(
            types, type.substr(std::min<std::size_t>(1, type.size())), &NumberType::name);
        if (found == types.end() || "<>|="sv.find(order) == std::string_view::npos)
            fail(
                fmt::format("an array of type {}; floats of 32 and 64 bits and integers are read: "
                            "save array.astype(float)",
                            in_quotes(type)));
        type_ = found;
        constexpr bool is_little = std::endian::native == std::endian::little;
        is_swapped_ = order == (is_little ? '>' : '<');
    }

    /// Which of the columns are x, y, in space z, and r.
    void choose_columns(std::uint64_t columns) {
        constexpr std::uint64_t most = 10'000;
        if (columns > most) fail(fmt::format("{} columns; {} are the most", columns, most));
        columns_ = static_cast<std::size_t>(columns);
        const Columns& chosen = options_.columns;
        const std::size_t width = chosen.empty() ? columns_ : chosen.size();
        const int dimension = options_.dimension.value_or(width == 4 ? 3 : 2);
        const auto least = static_cast<std::size_t>(dimension);
        if (chosen.empty() && (width < least || width > least + 1))
            fail(
                fmt::format("rows of {} numbers; sites {} have {} or {}; choose columns by "
                            "--columns, as in --columns {}",
                            width, dimension == 3 ? "in space" : "of the plane", least, least + 1,
                            dimension == 3 ? "1,2,3,4" : "1,2,3"));
        result_.dimension = dimension;
        fields_.assign(columns_, no_word);
        for (std::size_t which = 0; which < width; ++which) {
            std::optional<std::uint64_t> number = which + 1;
            if (!chosen.empty()) number = parse_whole_number(chosen[which]);
            if (!number || *number < 1 || *number > columns_)
                fail(
                    fmt::format("column {} is chosen; the columns of this array have no names, and "
                                "numbers from 1 to {}",
                                in_quotes(chosen[which]), columns_));
            std::size_t& field = fields_[*number - 1];
            if (field != no_word) fail(fmt::format("column {} is chosen twice", *number));
            field = which;
            column_of_[which] = *number - 1;
        }
        result_.third_may_be_z =
            width == 3 && dimension == 2 && chosen.empty() && !options_.dimension;
    }

    [[nodiscard]] std::size_t size() const {
        return result_.sites.size() + result_.in_space.size();
    }
    [[nodiscard]] double& number(std::size_t row, std::size_t which) {
        if (result_.dimension == 3) {
            Site3& site = result_.in_space[row];
            return *std::array{&site.x, &site.y, &site.z, &site.r}[which];
        }
        Site& site = result_.sites[row];
        return *std::array{&site.x, &site.y, &site.r}[which];
    }
    void put(std::size_t row, std::size_t column, char* bytes) {
        if (is_swapped_) std::reverse(bytes, bytes + type_->bytes);
        const double value = type_->read(bytes);
        if (!std::isfinite(value))
            file_.fail(place(row, column),
                       fmt::format("{} where a finite number should be", value));
        number(row, fields_[column]) = value;
    }
    /// Rows for lines.
    [[nodiscard]] Position place(std::size_t row, std::size_t column) const {
        return {static_cast<std::int64_t>(result_.first_row + row) + 1,
                static_cast<std::int64_t>(column) + 1};
    }
    void add_row() {
        if (result_.dimension == 3)
            result_.in_space.emplace_back();
        else
            result_.sites.emplace_back();
    }

    /// Goes to the rows of the share.
    void take_share(std::uint64_t rows) {
        const std::uint64_t number = options_.share.number;
        const auto row_of = [rows, of = options_.share.of](std::uint64_t k) {
            return static_cast<std::uint64_t>(static_cast<unsigned __int128>(rows) * k / of);
        };
        result_.first_row = row_of(number);
        rows_ = row_of(number + 1) - result_.first_row;
        bytes_.skip(result_.first_row * columns_ * type_->bytes);
    }

    void read_rows() {
        std::vector<char> bytes(columns_ * type_->bytes);
        for (std::size_t row = 0; row < rows_; ++row) {
            const std::size_t count = bytes_.read(bytes.data(), bytes.size());
            if (count == 0 && is_open_) return;
            if (count < bytes.size()) fail_within(row);
            add_row();
            for (std::size_t column = 0; column < columns_; ++column)
                if (fields_[column] != no_word) put(row, column, &bytes[column * type_->bytes]);
        }
    }
    void read_columns() {
        std::array<char, 8> bytes{};
        for (std::size_t column = 0; column < columns_; ++column)
            for (std::size_t row = 0; row < rows_; ++row) {
                if (bytes_.read(bytes.data(), type_->bytes) < type_->bytes)
                    fail(fmt::format("the file ends in row {} of {} of column {}", row + 1, rows_,
                                     column + 1));
                if (row == size()) add_row();
                if (fields_[column] != no_word) put(row, column, bytes.data());
            }
    }
    [[noreturn]] void fail_within(std::size_t row) const {
        if (is_open_)
            fail(fmt::format(
                "the file ends within site {}, which has {} bytes: {} doubles; if it is "
                "text, add --read-as text",
                row, columns_ * type_->bytes, columns_));
        fail(fmt::format("the file ends in row {} of {}", result_.first_row + row + 1,
                         result_.first_row + rows_));
    }
    SitesFile finished() {
        std::array<double, 4> numbers{};
        const std::size_t width = result_.dimension == 3 ? 4 : 3;
        for (std::size_t row = 0; row < size(); ++row) {
            for (std::size_t which = 0; which < width; ++which) numbers[which] = number(row, which);
            result_.note_of(numbers,
                            [&](std::size_t which) { return place(row, column_of_[which]); });
        }
        return std::move(result_);
    }

    InputFile& file_;
    Bytes bytes_;
    const ReadOptions& options_;
    const NumberType* type_ = nullptr;
    bool is_swapped_ = false;
    std::uint64_t rows_ = 0;
    bool is_open_ = false;  ///< rows come until the file ends
    std::size_t columns_ = 0;
    std::vector<std::size_t> fields_;         ///< by column x, y, in space z, or r; no_word
    std::array<std::size_t, 4> column_of_{};  ///< the other way round
    SitesFile result_;
};

}  // namespace

SitesFile read_npy_sites(InputFile& file, const ReadOptions& options) {
    return ArraySites(file, options).read_npy();
}
SitesFile read_f64_sites(InputFile& file, const ReadOptions& options) {
    return ArraySites(file, options).read_without_head();
}

}  // namespace signum
