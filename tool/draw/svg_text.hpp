#pragma once
/// Text of an SVG file: formatted pieces in a buffer, pixels with two decimals at most.

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

namespace signum {

/// A length in pixels, to be written. Precondition: |value| < 1e9.
struct Px {
    double value;
};

class SvgText {
 public:
    template <typename... Values>
    void add(fmt::format_string<Values...> format, Values&&... values) {
        fmt::format_to(std::back_inserter(buffer_), format, std::forward<Values>(values)...);
    }
    [[nodiscard]] std::string_view view() const noexcept {
        return {buffer_.data(), buffer_.size()};
    }

 private:
    fmt::memory_buffer buffer_;
};

}  // namespace signum

/// As few digits as say it: 12, 12.5, -0.25.
template <>
struct fmt::formatter<signum::Px> {
    static constexpr auto parse(format_parse_context& context) { return context.begin(); }
    template <typename Context>
    auto format(signum::Px px, Context& context) const {
        const long hundredths = std::lround(px.value * 100);
        const long magnitude = hundredths < 0 ? -hundredths : hundredths;
        const char* sign = hundredths < 0 ? "-" : "";
        if (magnitude % 100 == 0) return format_to(context.out(), "{}{}", sign, magnitude / 100);
        if (magnitude % 10 == 0)
            return format_to(context.out(), "{}{}.{}", sign, magnitude / 100, magnitude / 10 % 10);
        return format_to(context.out(), "{}{}.{:02}", sign, magnitude / 100, magnitude % 100);
    }
};
