#include <array>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "json_events.hpp"
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
    faces,
    neighbours,
    hidden,
    other
};

constexpr std::array<std::string_view, 8> key_names = {
    "format", "version", "metric", "weight_is", "sites", "faces", "neighbours", "hidden"};

Key key_of(std::string_view name) noexcept {
    for (std::size_t i = 0; i < key_names.size(); ++i) {
        if (key_names[i] == name) return static_cast<Key>(i);
    }
    return Key::other;
}

std::string_view name_of(Key key) noexcept {
    return key_names[static_cast<std::size_t>(key)];
}

class TessellationReader final : public JsonEvents {
 public:
    explicit TessellationReader(InputFile& file)
        : JsonEvents(file, "a tessellation is what signum triangulate writes as JSON") {}

    TessellationArrays read() {
        parse();
        for (const Key key : {Key::format, Key::version, Key::metric, Key::sites, Key::faces}) {
            if (!seen_.contains(key)) {
                fail(cursor().structure(), fmt::format("\"{}\" is missing", name_of(key)));
            }
        }
        return std::move(result_);
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
        if (text == "cells")
            fail_at_value("\"cells\" are those of a tessellation in space, which is not read yet");
        key_ = key_of(text);
        if (key_ != Key::other && !seen_.insert(key_).second) {
            fail_at_value(fmt::format("a second \"{}\"", text));
        }
        return true;
    }
    bool start_array(std::size_t /*size*/) override {
        if (depth_ == 0) fail_at_structure("an array cannot stand here");
        if (key_ != Key::other) {
            if (width() == 0 || depth_ > 2) expect_other("an array", cursor().structure());
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
            result_.sites = value;
        } else if (width() > 0 && depth_ == 3) {
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
            result_.metric = find(text, all_metrics);
        } else if (depth_ == 1 && key_ == Key::weight_is) {
            result_.weight_is = find(text, std::array{WeightIs::radius, WeightIs::weight});
        } else {
            expect_other(in_quotes(text), cursor().value());
        }
        return true;
    }

 private:
    /// The numbers in a row of the key's table; 0 when it has none.
    [[nodiscard]] std::size_t width() const noexcept {
        switch (key_) {
            case Key::faces:
            case Key::neighbours:
                return 3;
            case Key::hidden:
                return 2;
            default:
                return 0;
        }
    }

    /// Anything goes under a key that means nothing; elsewhere `what` is an error.
    bool expect_other(std::string_view what, Position position) const {
        if (depth_ == 0) fail(position, fmt::format("{} cannot stand here", what));
        if (key_ == Key::other) return true;
        const std::string_view wanted = key_ == Key::version  ? "1"
                                        : key_ == Key::sites  ? "the number of sites"
                                        : key_ == Key::hidden ? "[[site, by], ...]"
                                        : width() == 3        ? "[[i, j, k], ...]"
                                                              : "a string";
        cursor().file().fail(position, fmt::format("\"{}\" cannot hold {}; it holds {}",
                                                   name_of(key_), what, wanted));
    }

    void add_index(std::int64_t value, std::string_view text) {
        if (!std::in_range<Index>(value)) {
            fail_at_value(fmt::format("{} does not fit into 32 bits", text));
        }
        if (size_ == width()) {
            fail(start_, fmt::format("more than {} numbers in one entry of \"{}\"", width(),
                                     name_of(key_)));
        }
        numbers_[size_++] = static_cast<Index>(value);
    }

    void finish_tuple() {
        if (size_ != width()) {
            fail(start_, fmt::format("{} numbers in an entry of \"{}\", not {}", size_,
                                     name_of(key_), width()));
        }
        if (key_ == Key::faces) result_.faces.push_back(numbers_);
        if (key_ == Key::neighbours) result_.neighbours.push_back(numbers_);
        if (key_ == Key::hidden) result_.hidden.push_back({numbers_[0], numbers_[1]});
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

    TessellationArrays result_;
    std::set<Key> seen_;
    Key key_ = Key::other;
    int depth_ = 0;
    Position start_;  ///< of the entry that is being read
    Face numbers_ = {};
    std::size_t size_ = 0;
};

}  // namespace

TessellationArrays read_tessellation(const std::string& path) {
    InputFile file(path, "a tessellation in JSON");
    return TessellationReader(file).read();
}

}  // namespace signum
