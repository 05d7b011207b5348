#pragma once
/// A file of this folder: a few sites, why they are hard, and what is true of them. The library and
/// the oracles answer the same questions, and what they say is compared as text.
///
///     # Why it is hard, and where it comes from.
///     plane                what it is about: plane, space, motion, motion_in_space
///     ask 0 1 2 3          of which sites the predicates are asked; may be repeated
///     move 3 y 52          a family: y of site 3 moved by 0, 1, 2, 4, …, 2^52 ulps to both sides;
///                          move 3 y 52 4: by 0, 1, 2^4, 2^8, …
///     sites
///     0x1p0 2.5 3          x y r, a site a line
///     expected             from here on written by make_hard_cases, from the oracles
///     power in_circle 0 1 2 3: -*53 0 +*53
///
/// Sites of space have the numbers x y z r. Things that move have velocities behind them, u v or
/// u v w; they are asked in pairs, and `until 4` asks for all strikes up to a time.
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
        if (kind == Kind::move) return 2 * static_cast<std::size_t>(last / by) + 3;
        return static_cast<std::size_t>((last - first) / by) + 1;
    }

    [[nodiscard]] Rows applied(Rows rows, std::size_t step) const {
        const int exponent = first + by * static_cast<int>(step);
        if (kind == Kind::move) {
            // …, -2^by, -1, 0, 1, 2^by, …
            const int from_middle = static_cast<int>(step) - (last / by + 1);
            const std::int64_t ulps =
                from_middle == 0 ? 0 : std::int64_t{1} << (by * (std::abs(from_middle) - 1));
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
    std::optional<double> until;
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

/// The numbers of a site, by their names; none of what is no kind.
inline std::string columns_of(const std::string& kind) {
    if (kind == "plane") return "xyr";
    if (kind == "space") return "xyzr";
    if (kind == "motion") return "xyruv";
    if (kind == "motion_in_space") return "xyzruvw";
    return {};
}

inline Family read_family(const std::string& key, const std::string& columns,
                          std::istringstream& words) {
    Family family;
    const auto read_column = [&] {
        char name = 0;
        words >> name;
        family.column = columns.find(name);
    };
    if (key == "move") {
        family.kind = Family::Kind::move;
        words >> family.site;
        read_column();
        words >> family.last;
        if (int by = 0; words >> by)
            family.by = by;
        else if (words.eof())
            words.clear();
    } else if (key == "shift") {
        family.kind = Family::Kind::shift;
        read_column();
        words >> family.first >> family.last;
    } else {
        family.kind = Family::Kind::scale;
        words >> family.first >> family.last >> family.by;
    }
    if (words.fail() || family.by < 1 || family.last < family.first ||
        family.column == std::string::npos)
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
        } else if (!columns_of(key).empty()) {
            result.kind = key;
        } else if (key == "until" && words >> key) {
            result.until = number_of(key);
        } else if (key == "move" || key == "shift" || key == "scale") {
            result.family = read_family(key, columns_of(result.kind), words);
        } else {
            throw std::invalid_argument(path + ": what is " + key + "?");
        }
    }
    if (!in_expected || result.kind.empty())
        throw std::invalid_argument(path + ": no kind, or nothing is expected");
    for (const Row& row : result.rows)
        if (row.size() != columns_of(result.kind).size())
            throw std::invalid_argument(path + ": a site lacks a number");
    for (const auto& sites : result.asked)
        for (const std::size_t site : sites)
            if (site >= result.rows.size())
                throw std::invalid_argument(path + ": asks for a site that is not there");
    return result;
}

/// A sign, or yes or no, as they are written.
inline std::string letter(int sign) {
    return sign > 0 ? "+" : sign < 0 ? "-" : "0";
}
inline std::string letter(bool is) {
    return is ? "+" : "-";
}

/// What is not to be asked, and what the oracle does not say.
inline const std::string unasked = ".";
inline const std::string open = "?";

/// "0 1 2"
template <class Numbers>
std::string joined(const Numbers& numbers) {
    std::string text;
    for (const auto& number : numbers) text += (text.empty() ? "" : " ") + std::to_string(number);
    return text;
}

/// - - - - - 0 as "-*5 0".
inline std::string shortened(const std::vector<std::string>& answers) {
    std::string text;
    for (std::size_t from = 0, to = 0; from < answers.size(); from = to) {
        while (to < answers.size() && answers[to] == answers[from]) ++to;
        text += (from == 0 ? "" : " ") + answers[from];
        if (to - from > 1) text += "*" + std::to_string(to - from);
    }
    return text;
}

/// The opposite.
inline std::vector<std::string> lengthened(const std::string& text) {
    std::istringstream words(text);
    std::vector<std::string> answers;
    for (std::string word; words >> word;) {
        const std::size_t star = word.find('*');
        answers.insert(answers.end(),
                       star == std::string::npos ? 1 : std::stoul(word.substr(star + 1)),
                       word.substr(0, star));
    }
    return answers;
}

/// Answers to one question after another, at one step after another: each question on a line of its
/// own. Answers that are long, tessellations, get letters: a, b, c, ….
class AnswerLines {
 public:
    /// Questions come in the same order at every step.
    void begin_step() { next_ = 0; }
    /// The answer is one word.
    void add(const std::string& question, const std::string& answer) {
        line(question).answers.push_back(answer);
    }
    void add_long(const std::string& question, const std::string& answer) {
        Line& found = line(question);
        const auto place = std::ranges::find(found.different, answer);
        found.answers.push_back(name_of(static_cast<int>(place - found.different.begin())));
        if (place == found.different.end()) found.different.push_back(answer);
    }
    [[nodiscard]] Lines text() const {
        Lines result;
        for (const Line& line : lines_) {
            result.push_back(line.question + ": " + shortened(line.answers));
            for (std::size_t i = 0; i < line.different.size(); ++i)
                result.push_back("  " + name_of(static_cast<int>(i)) + " " + line.different[i]);
        }
        return result;
    }

 private:
    struct Line {
        std::string question;
        std::vector<std::string> answers;
        Lines different;
    };
    static std::string name_of(int number) {
        std::string name(1, static_cast<char>('a' + number % 26));
        return number < 26 ? name : name + std::to_string(number / 26);
    }
    Line& line(const std::string& question) {
        if (next_ == lines_.size()) lines_.push_back({question, {}, {}});
        if (lines_[next_].question != question) throw std::logic_error("questions changed");
        return lines_[next_++];
    }
    std::vector<Line> lines_;
    std::size_t next_ = 0;
};

/// Whether what was answered is what is expected: the same, but where the oracle does not say.
inline bool agrees(const std::string& answered, const std::string& expected) {
    const std::size_t colon = expected.rfind(": ");
    if (expected.starts_with(' ') || colon == std::string::npos ||
        answered.substr(0, colon + 2) != expected.substr(0, colon + 2))
        return answered == expected;
    const auto said = lengthened(answered.substr(colon + 2));
    const auto wanted = lengthened(expected.substr(colon + 2));
    return std::ranges::equal(said, wanted, [](const std::string& a, const std::string& b) {
        return a == b || b == open;
    });
}

}  // namespace signum::hard
