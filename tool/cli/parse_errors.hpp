#pragma once
/// What is wrong with a call that could not be parsed, in words of our own.

#include <string>

#include <CLI/CLI.hpp>

namespace signum::cli {

/// One sentence: what is wrong with the call, what would be right, and where help is. `first_word`
/// is the word after the tool's name.
std::string explain_parse_error(const CLI::App& tool, const CLI::ParseError& error,
                                const std::string& first_word);

}  // namespace signum::cli
