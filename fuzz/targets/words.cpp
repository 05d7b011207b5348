#include <cstdlib>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "../../tool/io/nearest_word.hpp"
#include "../../tool/io/number.hpp"
#include "../../tool/scenes/units.hpp"

#include "parsers.hpp"

namespace signum::fuzz {
namespace {

/// As the C library reads it, in the locale of programs that have not asked for another.
void judge_number(const std::string& word) {
    const Number number = parse_number(word);
    if (number.fault != NumberFault::none) {
        must(!explain(number.fault, word).empty(), "a fault without a sentence");
        return;
    }
    must(number.value - number.value == 0.0, "a number that is not finite");
    char* end = nullptr;
    const double other = std::strtod(word.c_str(), &end);
    must(end == word.c_str() + word.size() && other == number.value,
         "a number that the C library reads otherwise");
}

void judge_unit(std::string_view word) {
    must(begin_of_unit(word) <= word.size(), "a unit beyond its text");
    const auto unit = parse_unit(word);
    if (const auto* const wrong = std::get_if<std::string>(&unit)) {
        must(!wrong->empty(), "a wrong unit without a sentence");
        return;
    }
    const Unit& found = std::get<Unit>(unit);
    must(found.numerator > 0.0 && found.denominator > 0.0, "a unit that is not positive");
    static_cast<void>(Units().plain(1.5, found));
    static_cast<void>(in_words(found.dimension));
    static_cast<void>(Units().name_of(found.dimension));
}

}  // namespace

/// Words are what stands on a line each.
void read_words_target(Bytes bytes) {
    static const std::vector<std::string> known = {"triangulate", "radius",
                                                   "tangential_restitution"};
    std::string_view rest(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    while (!rest.empty()) {
        const std::string word(rest.substr(0, rest.find('\n')));
        rest.remove_prefix(std::min(rest.size(), word.size() + 1));
        judge_number(word);
        judge_unit(word);
        static_cast<void>(parse_whole_number(word));
        static_cast<void>(nearest_word(word, known));
    }
}

}  // namespace signum::fuzz
