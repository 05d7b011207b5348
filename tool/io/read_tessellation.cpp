#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "json_events.hpp"
#include "nearest_word.hpp"
#include "read_tessellation.hpp"

namespace signum {
namespace {

/// The keys that mean something.
enum class Key : std::uint8_t {
    format,
    version,
    metric,
    weight_is,
    sites,
    dimension,
    faces,
    cells,
    neighbours,
    hidden,
    other
};

constexpr std::array<std::string_view, 10> key_names = {
    "format",    "version", "metric", "weight_is",  "sites",
    "dimension", "faces",   "cells",  "neighbours", "hidden"};

/// What may be missing, and what is written for others to read.
const std::array<std::string, 4> optional_keys = {"weight_is", "dimension", "neighbours", "hidden"};
constexpr std::array<std::string_view, 2> keys_of_others = {"vertices", "statistics"};

Key key_of(std::string_view name) noexcept {
    for (std::size_t i = 0; i < key_names.size(); ++i) {
        if (key_names[i] == name) return static_cast<Key>(i);
    }
    return Key::other;
}

std::string_view name_of(Key key) noexcept {
    return key_names[static_cast<std::size_t>(key)];
}

/// Rows of one table of a tessellation in space, and how long they are.
struct Rows {
    std::vector<SpaceCell> rows;
    Position start;         ///< of the first one
    std::size_t width = 0;  ///< 0 before the first one
};

class TessellationReader final : public JsonEvents {
 public:
    explicit TessellationReader(InputFile& file)
        : JsonEvents(file, "a tessellation is what signum triangulate writes as JSON") {}

    ReadTessellation read() {
        parse();
        const bool in_space = seen_.contains(Key::cells);
        for (const Key key : {Key::format, Key::version, Key::metric, Key::sites,
                              in_space ? Key::dimension : Key::faces}) {
            if (!seen_.contains(key)) {
                fail(cursor().structure(), fmt::format("\"{}\" is missing", name_of(key)));
            }
        }
        for (const auto& [meant, typed] : misspelt_) {
            if (seen_.contains(key_of(meant))) continue;
            cursor().file().fail(typed.place,
                                 fmt::format("{} is no key of a tessellation; did you mean \"{}\"?",
                                             in_quotes(typed.name), meant));
        }
        if (in_space) {
            SpaceTessellation found = finished_in_space();
            return {std::move(arrays_), std::move(found), note()};
        }
        if (seen_.contains(Key::dimension) && dimension_ != 2) {
            fail(cursor().structure(),
                 fmt::format("\"dimension\" is {}, and \"faces\" are of the plane; leave one of "
                             "them out, or give \"cells\"",
                             dimension_));
        }
        // Neighbours that came before the faces.
        if (neighbours_.width > 0) {
            require_width(Key::neighbours, neighbours_, 3);
            for (const auto& [a, b, c, none] : neighbours_.rows)
                arrays_.neighbours.push_back({a, b, c});
        }
        return {std::move(arrays_), std::nullopt, note()};
    }

    bool start_object(std::size_t /*size*/) override {
        if (depth_ > 0) expect_other("an object", cursor().structure());
        ++depth_;
        return true;
    }
    bool end_object() override {
        --depth_;
        return true;
    }
    bool key(std::string& text) override {
        if (depth_ > 1) return true;
        key_ = key_of(text);
        if ((key_ == Key::cells && seen_.contains(Key::faces)) ||
            (key_ == Key::faces && seen_.contains(Key::cells)))
            fail_at_value(
                "\"faces\" are of the plane and \"cells\" of space; there is one of them");
        if (key_ != Key::other && !seen_.insert(key_).second) {
            fail_at_value(fmt::format("a second \"{}\"", text));
        }
        if (key_ == Key::other && std::ranges::find(keys_of_others, text) == keys_of_others.end())
            note_unknown(text);
        return true;
    }
    bool start_array(std::size_t /*size*/) override {
        if (depth_ == 0) fail_at_structure("an array cannot stand here");
        if (key_ != Key::other) {
            if (longest() == 0 || depth_ > 2) expect_other("an array", cursor().structure());
            start_ = cursor().structure();
            size_ = 0;
        }
        ++depth_;
        return true;
    }
    bool end_array() override {
        if (key_ != Key::other && depth_ == 3) finish_tuple();
        --depth_;
        return true;
    }
    bool null() override { return expect_other("null", cursor().value()); }
    bool boolean(bool /*value*/) override { return expect_other("a boolean", cursor().value()); }
    bool number_float(double /*value*/, const std::string& text) override {
        return expect_other(text, cursor().value());
    }
    bool number_unsigned(std::uint64_t value) override {
        if (value > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) {
            return expect_other(fmt::to_string(value), cursor().value());
        }
        return number_integer(static_cast<std::int64_t>(value));
    }
    bool number_integer(std::int64_t value) override {
        const std::string text = fmt::to_string(value);
        if (key_ == Key::version && depth_ == 1) {
            if (value != 1) fail_at_value("version " + text + " is unknown, version 1 is read");
        } else if (key_ == Key::sites && depth_ == 1) {
            if (value < 0) expect_other(text, cursor().value());
            arrays_.sites = value;
        } else if (key_ == Key::dimension && depth_ == 1) {
            if (value < -1 || value > 3) expect_other(text, cursor().value());
            dimension_ = static_cast<int>(value);
        } else if (longest() > 0 && depth_ == 3) {
            add_index(value, text);
        } else {
            expect_other(text, cursor().value());
        }
        return true;
    }
    bool string(std::string& text) override {
        if (depth_ == 1 && key_ == Key::format) {
            if (text != "signum.tessellation") {
                fail_at_value("the format is " + in_quotes(text) + ", not 'signum.tessellation'");
            }
        } else if (depth_ == 1 && key_ == Key::metric) {
            arrays_.metric = find(text, all_metrics);
        } else if (depth_ == 1 && key_ == Key::weight_is) {
            arrays_.weight_is = find(text, std::array{WeightIs::radius, WeightIs::weight});
        } else {
            expect_other(in_quotes(text), cursor().value());
        }
        return true;
    }

 private:
    /// The most numbers in a row of the key's table; 0 when it has none.
    [[nodiscard]] std::size_t longest() const noexcept {
        switch (key_) {
            case Key::faces:
                return 3;
            case Key::cells:
                return numbers_.size();
            case Key::neighbours:
                return seen_.contains(Key::faces) ? 3 : numbers_.size();
            case Key::hidden:
                return 2;
            default:
                return 0;
        }
    }
    /// The numbers in a row that has ended after `size_`: of space those of the row before it.
    [[nodiscard]] std::size_t width() const noexcept {
        if (const Rows* const rows = rows_in_space())
            return std::max(rows->width > 0 ? rows->width : size_, std::size_t{1});
        return longest();
    }
    /// Where the key's rows go, unless they are known to be of the plane.
    [[nodiscard]] const Rows* rows_in_space() const noexcept {
        if (key_ == Key::cells) return &cells_;
        return key_ == Key::neighbours && longest() > 3 ? &neighbours_ : nullptr;
    }

    /// A key that is not the format's.
    void note_unknown(const std::string& name) {
        if (const auto meant = nearest_word(name, optional_keys))
            misspelt_.try_emplace(*meant, Unknown{name, cursor().value()});
        if (!unknown_) unknown_ = {name, cursor().value()};
    }
    [[nodiscard]] std::string note() const {
        if (!unknown_) return {};
        return InputError(cursor().file().path(), unknown_->place,
                          fmt::format("{} is no key of a tessellation, and is ignored",
                                      in_quotes(unknown_->name)))
            .what();
    }

    void require_width(Key key, const Rows& rows, std::size_t width) const {
        if (rows.width == 0 || rows.width == width) return;
        fail(rows.start, fmt::format("{} numbers in an entry of \"{}\", not {}", rows.width,
                                     name_of(key), width));
    }
    SpaceTessellation finished_in_space() {
        const auto width = static_cast<std::size_t>(dimension_ + 1);
        require_width(Key::cells, cells_, width);
        require_width(Key::neighbours, neighbours_, width);
        SpaceTessellation result;
        result.dimension = dimension_;
        result.sites = arrays_.sites;
        result.cells = std::move(cells_.rows);
        result.neighbours = std::move(neighbours_.rows);
        result.hidden = std::exchange(arrays_.hidden, {});
        return result;
    }

    /// Anything goes under a key that means nothing; elsewhere `what` is an error.
    bool expect_other(std::string_view what, Position position) const {
        if (depth_ == 0) fail(position, fmt::format("{} cannot stand here", what));
        if (key_ == Key::other) return true;
        const bool in_cells =
            key_ == Key::cells || (key_ == Key::neighbours && seen_.contains(Key::cells));
        const std::string_view wanted = key_ == Key::version     ? "1"
                                        : key_ == Key::sites     ? "the number of sites"
                                        : key_ == Key::dimension ? "a number from -1 to 3"
                                        : key_ == Key::hidden    ? "[[site, by], ...]"
                                        : in_cells               ? "[[i, j, k, l], ...]"
                                        : longest() >= 3         ? "[[i, j, k], ...]"
                                                                 : "a string";
        cursor().file().fail(position, fmt::format("\"{}\" cannot hold {}; it holds {}",
                                                   name_of(key_), what, wanted));
    }

    void add_index(std::int64_t value, std::string_view text) {
        if (!std::in_range<Index>(value)) {
            fail_at_value(fmt::format("{} does not fit into 32 bits", text));
        }
        if (size_ == longest()) {
            fail(start_, fmt::format("more than {} numbers in one entry of \"{}\"", longest(),
                                     name_of(key_)));
        }
        numbers_[size_++] = static_cast<Index>(value);
    }

    void finish_tuple() {
        if (size_ != width()) {
            fail(start_, fmt::format("{} numbers in an entry of \"{}\", not {}", size_,
                                     name_of(key_), width()));
        }
        const auto& [a, b, c, d] = numbers_;
        if (key_ == Key::hidden) {
            arrays_.hidden.push_back({a, b});
        } else if (key_ == Key::faces) {
            arrays_.faces.push_back({a, b, c});
        } else if (rows_in_space() == nullptr) {
            arrays_.neighbours.push_back({a, b, c});
        } else {
            Rows& rows = key_ == Key::cells ? cells_ : neighbours_;
            if (rows.width == 0) rows.start = start_;
            rows.width = size_;
            std::fill(numbers_.begin() + static_cast<std::ptrdiff_t>(size_), numbers_.end(),
                      no_vertex);
            rows.rows.push_back(numbers_);
        }
    }

    /// The value that has this name.
    template <typename Value, std::size_t count>
    Value find(std::string_view name, const std::array<Value, count>& values) const {
        std::string names;
        for (const Value value : values) {
            if (signum::name_of(value) == name) return value;
            names += (names.empty() ? "" : ", ") + std::string(signum::name_of(value));
        }
        cursor().file().fail(cursor().value(), fmt::format("\"{}\" cannot be {}; it is one of {}",
                                                           name_of(key_), in_quotes(name), names));
    }

    TessellationArrays arrays_;
    Rows cells_;
    Rows neighbours_;  ///< those that came before any faces
    int dimension_ = -1;
    std::set<Key> seen_;
    /// By what they were meant to be, the first that reads so.
    struct Unknown {
        std::string name;
        Position place;
    };
    std::map<std::string, Unknown> misspelt_;
    std::optional<Unknown> unknown_;  ///< the first
    Key key_ = Key::other;
    int depth_ = 0;
    Position start_;  ///< of the entry that is being read
    SpaceCell numbers_ = {};
    std::size_t size_ = 0;
};

}  // namespace

ReadTessellation read_tessellation(const std::string& path) {
    InputFile file(path, "a tessellation in JSON");
    return TessellationReader(file).read();
}

}  // namespace signum
