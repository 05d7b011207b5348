#include "nearest_word.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

namespace signum {
namespace {

/// How many slips lead from one word to the other: the distance of optimal string alignment.
std::size_t slips(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t other = a[i - 1] == b[j - 1] ? 0 : 1;
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + other});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        std::swap(before, last);
        std::swap(last, row);
    }
    return last[b.size()];
}

}  // namespace

std::string in_small_letters(std::string_view text) {
    std::string result(text);
    for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

std::optional<std::string> nearest_word(std::string_view word, std::span<const std::string> words) {
    constexpr std::size_t longest = 64;
    if (word.size() > longest) return std::nullopt;
    std::optional<std::string> nearest;
    std::size_t fewest = (word.size() + 1) / 3 + 1;
    std::size_t most_alike = 0;
    const std::string typed = in_small_letters(word);
    for (const std::string& each : words) {
        if (each.size() > longest) continue;
        const std::string known = in_small_letters(each);
        const std::size_t needed = slips(typed, known);
        const auto alike =
            static_cast<std::size_t>(std::ranges::mismatch(typed, known).in1 - typed.begin());
        if (needed > fewest || (needed == fewest && (!nearest || alike <= most_alike))) continue;
        fewest = needed;
        most_alike = alike;
        nearest = each;
    }
    return nearest;
}

}  // namespace signum
