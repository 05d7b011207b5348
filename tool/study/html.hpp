#pragma once
/// Text for HTML and SVG, and how our pages look.

#include <string>
#include <string_view>

namespace signum::study {

/// The text with what has a meaning of its own there, in attributes too, written so that it has
/// none.
[[nodiscard]] std::string html_text(std::string_view text);

/// A page up to what its body begins with. The title is HTML.
[[nodiscard]] std::string html_head(std::string_view title);

}  // namespace signum::study
