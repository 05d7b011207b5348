#pragma once
/// Formatted text to a stream in large pieces. Doubles come out in the fewest digits that read back
/// as the same double, in any locale.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/compile.h>
#include <fmt/format.h>

#include "../../core/index.hpp"
#include "../../core/parallel.hpp"
#include "threads.hpp"

namespace signum {

/// A finite number in JSON, which comes back as it was: "-0" would be an integer to a reader, and
/// lose its sign.
struct JsonNumber {
    double value;
};

}  // namespace signum

template <>
struct fmt::formatter<signum::JsonNumber> : fmt::formatter<double> {
    template <class Context>
    auto format(const signum::JsonNumber& number, Context& context) const {
        if (number.value == 0.0 && std::signbit(number.value))
            return fmt::format_to(context.out(), "-0.0");
        return fmt::formatter<double>::format(number.value, context);
    }
};

namespace signum {

/// A number in JSON; null for what is none there.
[[nodiscard]] inline std::string number_or_null(double value) {
    return std::isfinite(value) ? fmt::format(FMT_COMPILE("{}"), JsonNumber{value}) : "null";
}

/// A number in a table; nothing for what is none there.
[[nodiscard]] inline std::string number_or_blank(double value) {
    return std::isfinite(value) ? fmt::format(FMT_COMPILE("{}"), value) : "";
}

class TextWriter {
 public:
    explicit TextWriter(std::ostream& out) : out_(&out) {}

    /// As fmt::format_to; `format` is a literal under FMT_COMPILE.
    template <typename Format, typename First, typename... Rest>
    void put(const Format& format, const First& first, const Rest&... rest) {
        fmt::format_to(std::back_inserter(text_), format, first, rest...);
        if (out_ != nullptr && text_.size() > piece) flush();
    }
    void put(std::string_view text) { put(FMT_COMPILE("{}"), text); }
    /// In JSON, [i, j, ...].
    void put_whole_numbers(std::span<const Index> numbers) {
        char before = '[';
        for (const Index number : numbers) {
            text_.push_back(before);
            if (before == ',') text_.push_back(' ');
            const fmt::format_int digits(number);
            text_.append(digits.data(), digits.data() + digits.size());
            before = ',';
        }
        put("]");
    }
    /// In JSON, [x, y, ...]: null for what is no number there.
    template <typename... Numbers>
    void put_numbers(Numbers... numbers) {
        put(FMT_COMPILE("[{}]"), fmt::join(std::array{number_or_null(numbers)...}, ", "));
    }

    /// In JSON, a further member of an object: "name": [entry, entry, ...], an entry a line.
    template <typename Entries, typename PutEntry>
    void put_array(std::string_view name, const Entries& entries, const PutEntry& put_entry) {
        put(FMT_COMPILE(",\n\"{}\": ["), name);
        bool first = true;
        for (const auto& entry : entries) {
            put(first ? "\n" : ",\n");
            put_entry(entry);
            first = false;
        }
        put("]");
    }

    /// The same by all threads; put_entry(TextWriter, number) writes that of a number from 0 on.
    template <typename PutEntry>
    void put_long_array(std::string_view name, std::size_t size, const PutEntry& put_entry) {
        put(FMT_COMPILE(",\n\"{}\": ["), name);
        put_entries(size, [&](TextWriter& text, std::size_t number) {
            text.put(number == 0 ? "\n" : ",\n");
            put_entry(text, number);
        });
        put("]");
    }
    /// What put_entry(TextWriter, number) writes for numbers from 0 on, by all threads.
    template <typename PutEntry>
    void put_entries(std::size_t size, const PutEntry& put_entry) {
        constexpr std::size_t entries = 4096;  // in the text of one task
        const Workers workers(threads_of_files, size);
        std::vector<TextWriter> texts;
        for (int i = 0; i < 4 * workers.count(); ++i) texts.push_back(TextWriter());
        for (std::size_t first = 0; first < size; first += texts.size() * entries) {
            workers.each(texts.size(), [&](std::size_t i) {
                const std::size_t end = std::min(size, first + (i + 1) * entries);
                for (std::size_t number = first + i * entries; number < end; ++number)
                    put_entry(texts[i], number);
            });
            for (TextWriter& text : texts) {
                text_.append(text.text_);
                text.text_.clear();
                if (out_ != nullptr && text_.size() > piece) flush();
            }
        }
    }

    /// To be called at the end: nothing is written by the destructor.
    void flush() {
        out_->write(text_.data(), static_cast<std::streamsize>(text_.size()));
        text_.clear();
    }

 private:
    TextWriter() = default;

    static constexpr std::size_t piece = std::size_t{1} << 16;
    std::ostream* out_ = nullptr;  ///< none: all stays here
    fmt::memory_buffer text_;
};

}  // namespace signum
