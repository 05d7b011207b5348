#pragma once
/// The words that the pages of both studies explain, of the plane and of space.

#include <string>
#include <string_view>

namespace signum::study {

/// In HTML: `own_words` of the page, entries of a list of definitions, then those of both.
/// `example_of_tie`: sites that make a sign exactly zero.
[[nodiscard]] std::string glossary(std::string_view own_words, std::string_view example_of_tie);

}  // namespace signum::study
