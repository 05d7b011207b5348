#pragma once
/// A file of this folder: a few sites, why they are hard, and what is true of them. The library and
/// the oracles answer the same questions, and what they say is compared as text.
///
///     # Why it is hard, and where it comes from.
///     plane                what it is about
///     ask 0 1 2 3          of which sites the predicates are asked; may be repeated
///     move 3 y 52          a family: y of site 3 moved by 0, 1, 2, 4, …, 2^52 ulps to both sides
///     sites
///     0x1p0 2.5 3          x y r, a site a line
///     expected             from here on written by make_hard_cases, from the oracles
///     power in_circle 0 1 2 3: -*53 0 +*53
///
/// Other families: `shift x 0 60` adds 2^0, 2^1, …, 2^60 to x of all sites (rounded, as whoever
/// moves an origin does), `scale -1000 1000 50` multiplies all numbers by 2^-1000, 2^-950, ….
/// Answers stand in the order of the steps, -*53 for 53 of one kind: + 0 - for signs, a dot where
/// the question is not to be asked, a question mark where the oracle does not say.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace signum::hard {

using Row = std::vector<double>;
using Rows = std::vector<Row>;
using Lines = std::vector<std::string>;

/// The double that lies so many doubles above x, or below where steps is negative.
inline double moved_by_ulps(double x, std::int64_t steps) {
    const auto place = [](std::int64_t bits) { return bits < 0 ? INT64_MIN - bits : bits; };
    const double result =
        std::bit_cast<double>(place(place(std::bit_cast<std::int64_t>(x)) + steps));
    if (!std::isfinite(result)) throw std::out_of_range("a step leaves the doubles");
    return result;
}

/// What changes from step to step of a family.
struct Family {
    enum class Kind { none, move, shift, scale } kind = Kind::none;
    std::size_t site = 0;    // move
    std::size_t column = 0;  // move, shift
    int first = 0;
    int last = 0;
    int by = 1;

    [[nodiscard]] std::size_t steps() const {
        if (kind == Kind::none) return 1;
        if (kind == Kind::move) return 2 * static_cast<std::size_t>(last) + 3;
        return static_cast<std::size_t>((last - first) / by) + 1;
    }

    [[nodiscard]] Rows applied(Rows rows, std::size_t step) const {
        const int exponent = first + by * static_cast<int>(step);
        if (kind == Kind::move) {
            // -2^last, …, -1, 0, 1, …, 2^last
            const int from_middle = static_cast<int>(step) - (last + 1);
            const std::int64_t ulps =
                from_middle == 0 ? 0 : std::int64_t{1} << (std::abs(from_middle) - 1);
            double& number = rows.at(site).at(column);
            number = moved_by_ulps(number, from_middle < 0 ? -ulps : ulps);
        }
        for (Row& row : rows) {
            if (kind == Kind::shift) row.at(column) += std::ldexp(1.0, exponent);
            if (kind == Kind::scale)
                for (double& number : row) number = std::ldexp(number, exponent);
        }
        return rows;
    }
};

struct Case {
    std::string name;
    std::string given;  ///< the text before what is expected
    std::string kind;
    std::vector<std::vector<std::size_t>> asked;
    Family family;
    Rows rows;
    Lines expected;
};

inline double number_of(const std::string& word) {
    char* end = nullptr;
    const double number = std::strtod(word.c_str(), &end);
    if (word.empty() || *end != '\0' || !std::isfinite(number))
        throw std::invalid_argument("no number: " + word);
    return number;
}

inline Family read_family(const std::string& key, std::istringstream& words) {
    Family family;
    const auto read_column = [&] {
        const std::string columns = "xyzr";
        char name = 0;
        words >> name;
        family.column = columns.find(name);
    };
    if (key == "move") {
        family.kind = Family::Kind::move;
        words >> family.site;
        read_column();
        words >> family.last;
    } else if (key == "shift") {
        family.kind = Family::Kind::shift;
        read_column();
        words >> family.first >> family.last;
    } else {
        family.kind = Family::Kind::scale;
        words >> family.first >> family.last >> family.by;
    }
    if (!words || family.by < 1 || family.last < family.first || family.column == std::string::npos)
        throw std::invalid_argument("no family: " + key);
    return family;
}

/// Throws std::invalid_argument for a file that cannot be read.
inline Case read_case(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw std::invalid_argument(path + ": cannot be read");
    Case result;
    result.name = path.substr(path.rfind('/') + 1);
    std::string line;
    bool in_sites = false;
    bool in_expected = false;
    while (std::getline(file, line)) {
        if (in_expected) {
            result.expected.push_back(line);
            continue;
        }
        result.given += line + "\n";
        std::istringstream words(line.substr(0, line.find('#')));
        std::string key;
        if (!(words >> key)) continue;
        if (key == "expected") {
            in_expected = true;
        } else if (in_sites) {
            Row row;
            do {
                row.push_back(number_of(key));
            } while (words >> key);
            result.rows.push_back(row);
        } else if (key == "sites") {
            in_sites = true;
        } else if (key == "ask") {
            std::vector<std::size_t> sites;
            for (std::size_t site = 0; words >> site;) sites.push_back(site);
            result.asked.push_back(sites);
        } else if (key == "plane") {
            result.kind = key;
        } else if (key == "move" || key == "shift" || key == "scale") {
            result.family = read_family(key, words);
        } else {
            throw std::invalid_argument(path + ": what is " + key + "?");
        }
    }
    if (!in_expected || result.kind.empty())
        throw std::invalid_argument(path + ": no kind, or nothing is expected");
    const std::size_t columns = 3;
    for (Row& row : result.rows) {
        if (row.size() != columns) throw std::invalid_argument(path + ": a site lacks a number");
    }
    // The third number of a site of the plane is r.
    if (result.family.column == 3) result.family.column = columns - 1;
    for (const auto& sites : result.asked)
        for (const std::size_t site : sites)
            if (site >= result.rows.size())
                throw std::invalid_argument(path + ": asks for a site that is not there");
    return result;
}

/// A sign as it is written; none where the question is not to be asked.
inline char letter(std::optional<int> sign) {
    if (!sign) return '.';
    return *sign > 0 ? '+' : *sign < 0 ? '-' : '0';
}

/// What the oracle does not say.
inline constexpr char open = '?';

/// "-----0" as "-*5 0".
inline std::string shortened(const std::string& answers) {
    std::string text;
    for (std::size_t from = 0, to = 0; from < answers.size(); from = to) {
        to = std::min(answers.find_first_not_of(answers[from], from), answers.size());
        text += (from == 0 ? "" : " ") + std::string(1, answers[from]);
        if (to - from > 1) text += "*" + std::to_string(to - from);
    }
    return text;
}

/// The opposite, for the answers of a whole line; what is no line of answers stays as it is.
inline std::string lengthened(const std::string& line) {
    const std::size_t colon = line.rfind(": ");
    if (line.starts_with(' ') || colon == std::string::npos) return line;
    std::istringstream words(line.substr(colon + 2));
    std::string text = line.substr(0, colon + 2);
    for (std::string word; words >> word;)
        text.append(word.size() > 2 ? std::stoul(word.substr(2)) : 1, word[0]);
    return text;
}

/// Answers to one question after another, at one step after another: each question on a line of its
/// own. Answers that are long, tessellations, get letters: a, b, c, ….
class AnswerLines {
 public:
    /// Questions come in the same order at every step.
    void begin_step() { next_ = 0; }
    void add(const std::string& question, char answer) { line(question).answers += answer; }
    void add_long(const std::string& question, const std::string& answer) {
        Line& found = line(question);
        std::size_t number = 0;
        while (number < found.different.size() && found.different[number] != answer) ++number;
        if (number == found.different.size()) found.different.push_back(answer);
        found.answers += static_cast<char>(number < 26 ? 'a' + number : 'A' + (number - 26));
        if (number >= 52) throw std::out_of_range("too many different answers: " + question);
    }
    [[nodiscard]] Lines text() const {
        Lines result;
        for (const Line& line : lines_) {
            result.push_back(line.question + ": " + shortened(line.answers));
            for (std::size_t i = 0; i < line.different.size(); ++i)
                result.push_back(
                    "  " + std::string(1, static_cast<char>(i < 26 ? 'a' + i : 'A' + i - 26)) +
                    " " + line.different[i]);
        }
        return result;
    }

 private:
    struct Line {
        std::string question;
        std::string answers;
        Lines different;
    };
    Line& line(const std::string& question) {
        if (next_ == lines_.size()) lines_.push_back({question, {}, {}});
        if (lines_[next_].question != question) throw std::logic_error("questions changed");
        return lines_[next_++];
    }
    std::vector<Line> lines_;
    std::size_t next_ = 0;
};

/// Whether what was answered is what is expected: the same, but where the oracle does not say.
inline bool agrees(std::string answered, std::string expected) {
    answered = lengthened(answered);
    expected = lengthened(expected);
    if (answered.size() != expected.size()) return false;
    for (std::size_t i = 0; i < expected.size(); ++i)
        if (answered[i] != expected[i] && expected[i] != open) return false;
    return true;
}

}  // namespace signum::hard
