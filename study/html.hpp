#pragma once
/// Text for HTML and SVG.

#include <string>
#include <string_view>

namespace signum::study {

/// The text with what has a meaning of its own there, in attributes too, written so that it has
/// none.
[[nodiscard]] inline std::string html_text(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '"')
            result += "&quot;";
        else
            result += c;
    }
    return result;
}

}  // namespace signum::study
