#include <algorithm>
#include <cctype>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "../io/errors.hpp"
#include "../io/nearest_word.hpp"
#include "../io/number.hpp"

#include "commands.hpp"

namespace signum::cli {
namespace {

/// The name that pages and messages use: -o, not --output.
std::string short_name(const CLI::Option& option) {
    if (!option.get_snames().empty()) return "-" + option.get_snames().front();
    return option.get_name();
}

bool is_flag(const CLI::Option& option) {
    return option.get_items_expected_max() == 0;
}

/// Words after it are no options.
constexpr std::string_view end_mark = "--";

/// Whether a word stands where an option would, and is none of the numbers below 0.
bool looks_like_option(std::string_view word) {
    return word.size() > 1 && word[0] == '-' && word[1] != '.' &&
           std::isdigit(static_cast<unsigned char>(word[1])) == 0;
}

/// "triangulate FILE", "generate DISTRIBUTION -n N": what a call cannot do without.
std::string least_call(const CLI::App& command) {
    std::string call = command.get_name();
    for (const CLI::Option* option : command.get_options()) {
        if (!option->get_required()) continue;
        call += " " + short_name(*option);
        if (!option->get_positional()) call += " " + option->get_type_name();
    }
    return call;
}

/// An option that the command does not have.
std::string explain_unknown_option(const CLI::App& tool, const CLI::App& command,
                                   const std::string& word) {
    const std::string name = word.substr(0, word.find('='));
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& each : option->get_lnames()) names.push_back("--" + each);
        for (const std::string& each : option->get_snames()) names.push_back("-" + each);
    }
    const std::string what =
        fmt::format("{} has no option {}", command.get_name(), in_quotes(name));
    if (const auto meant = nearest_word(name, names))
        return fmt::format("{}; did you mean {}?", what, *meant);
    std::vector<std::string> owners;
    for (const CLI::App* other : tool.get_subcommands([](const CLI::App*) { return true; }))
        if (other->get_option_no_throw(name) != nullptr) owners.push_back(other->get_name());
    if (owners.empty()) return what;
    const std::string last = owners.back();
    owners.pop_back();
    if (owners.empty()) return fmt::format("{}; {} has it", what, last);
    return fmt::format("{}; {} and {} have it", what, fmt::join(owners, ", "), last);
}

/// A value too few or too many for an option, which the message names.
std::string explain_mismatch(const CLI::App& command, const std::string& message) {
    const std::string named = message.substr(0, message.find_first_of(": "));
    const CLI::Option* option = command.get_option_no_throw(named);
    // The parser names a flag that is given a value without its dashes.
    if (option == nullptr) option = command.get_option_no_throw("--" + named);
    if (option == nullptr) return message;
    const std::string name = short_name(*option);
    if (is_flag(*option)) return fmt::format("{} takes no value", name);
    const int least = option->get_items_expected_min();
    const int most = option->get_items_expected_max();
    const auto given = static_cast<int>(option->count());
    if (most > 1 && given > 0) {
        // What is for the plane and for space takes either number and none between.
        return fmt::format(
            "{} takes {} words after it, {}{}; {} given", name,
            least == most ? fmt::format("{}", most) : fmt::format("{} or {}", least, most),
            option->get_type_name(), most == 4 && given == 6 ? ", a box of the plane" : "",
            given == 1 ? "one is" : fmt::format("{} are", given));
    }
    if (given > most) return fmt::format("{} is given {} times; give it once", name, given);
    return fmt::format("{} needs a word after it: {} {}", name, name, option->get_type_name());
}

std::string explain_missing(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options()) {
        if (!option->get_required() || option->count() > 0) continue;
        return fmt::format("{} is missing; the least is signum {}", short_name(*option),
                           least_call(command));
    }
    return "something is missing";
}

std::string explain_surplus(const CLI::App& command, const std::string& word) {
    const bool is_study = command.get_name() == "study";
    return fmt::format("{} is a word too many{}; {}", in_quotes(word),
                       looks_like_option(word) ? ", no option after --" : "",
                       is_study ? "a study makes its own sites, signum compare FILE judges yours"
                                : "the least is signum " + least_call(command));
}

/// An error of a call whose subcommand is known. What stands where it cannot stand comes first: it
/// often is why something else is missing.
std::string explain_in(const CLI::App& tool, const CLI::App& command,
                       const CLI::ParseError& error) {
    std::vector<std::string> left_over = command.remaining();
    const auto end_of_options = std::ranges::find(left_over, end_mark);
    for (auto word = left_over.begin(); word != end_of_options; ++word)
        if (looks_like_option(*word)) {
            const NumberFault fault = parse_number(*word).fault;  // -inf is no option
            return fault == NumberFault::not_finite ? explain(fault, *word)
                                                    : explain_unknown_option(tool, command, *word);
        }
    if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) return explain_missing(command);
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr)
        return explain_mismatch(command, error.what());
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
        // Behind the mark, the parser hands to the tool what the command has no place for.
        for (const std::string& word : tool.remaining()) left_over.push_back(word);
        std::erase(left_over, end_mark);
        if (!left_over.empty()) return explain_surplus(command, left_over.front());
    }
    return error.what();
}

std::string explain_no_subcommand(const CLI::App& tool, const std::string& first_word) {
    if (looks_like_option(first_word)) {
        return fmt::format(
            "{} stands before the subcommand; write signum SUBCOMMAND first, then "
            "its options",
            in_quotes(first_word));
    }
    std::vector<std::string> names;
    for (const CLI::App* each : tool.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(each->get_name());
    const auto meant = nearest_word(first_word, names);
    return fmt::format("{} is no subcommand{}", in_quotes(first_word),
                       meant ? fmt::format("; did you mean {}?", *meant) : "");
}

}  // namespace

std::string explain_parse_error(const CLI::App& tool, const CLI::ParseError& error,
                                const std::string& first_word) {
    const auto chosen = tool.get_subcommands();
    const bool is_known = !chosen.empty() && !looks_like_option(first_word);
    std::string message = is_known ? explain_in(tool, *chosen.front(), error)
                                   : explain_no_subcommand(tool, first_word);
    for (char& c : message) {
        if (c == '\n') c = ' ';
    }
    const std::string_view join = message.ends_with('?') ? " See" : "; see";
    const std::string command = is_known ? " " + chosen.front()->get_name() : "";
    const bool is_sign = is_known && chosen.front()->get_name() == "sign";
    return fmt::format("{}{} signum{} --help{}", message, join, command,
                       is_sign ? " (numbers stand after --)" : "");
}

}  // namespace signum::cli
