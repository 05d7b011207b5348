/// The columns of a line are read as a ball. Their number tells the plane from space, or a header
/// names them; columns that it names otherwise may hold any text, and so one separator alone
/// separates then: that of the first line.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "../../core/error_free.hpp"
#include "read_balls.hpp"
#include "read_xyz.hpp"
#include "text_columns.hpp"

namespace signum {
namespace {

constexpr std::string_view advice_on_balls =
    "write one ball a line: x y r vx vy [mass], in space x y z r vx vy vz [mass]";

/// The double nearest to m³, for m in [1/2, 1) or 0. All terms are multiples of 2^-159.
double cube_to_nearest(double m) {
    const TwoTerms square = two_product(m, m);
    const TwoTerms upper = two_product(square.high, m);
    const TwoTerms lower = two_product(square.low, m);
    // m³ - upper.high, at most 2^-53. Of the two terms that are added without care, the first is at
    // most 2^-107, the second at most 2^-108: the sum has no more than 53 bits.
    const TwoTerms middle = two_sum(upper.low, lower.high);
    const TwoTerms rest = two_sum(middle.high, middle.low + lower.low);
    // The rest is rounded to odd, so that the sum is rounded as if once (Boldo and Melquiond 2008):
    // an odd last bit keeps it off the middles between doubles, which are multiples of 2^-56.
    double odd = rest.high;
    if (rest.low != 0.0 && std::bit_cast<std::uint64_t>(odd) % 2 == 0)
        odd = std::nextafter(odd, std::copysign(1.0, rest.low));
    return upper.high + odd;
}

/// The words with commas and an "and" between them, the first dozen of them.
std::string enumerated(const std::vector<std::string>& words) {
    constexpr std::size_t most_shown = 12;
    const std::size_t shown = std::min(words.size(), most_shown);
    std::string result;
    for (std::size_t i = 0; i < shown; ++i) {
        const bool last = i + 1 == words.size();
        result += (i == 0 ? "" : last ? " and " : ", ") + words[i];
    }
    if (shown < words.size()) result += fmt::format(" and {} more", words.size() - shown);
    return result;
}

class TextBalls {
 public:
    explicit TextBalls(InputFile& file) : columns_(file, std::string(advice_on_balls)) {}

    BallsFile read() {
        if (!columns_.next_line()) columns_.fail_at_end_of_file("no ball in this file");
        if (columns_.is_header()) {
            read_header();
        } else {
            columns_.split_again();
            count_columns();
            read_ball();
        }
        while (columns_.next_line()) read_ball();
        if (result_.balls.empty()) columns_.fail_at_end_of_file("a header and no ball");
        return std::move(result_);
    }

 private:
    /// What a column holds, in the order of a line in space.
    enum : std::size_t { x, y, z, radius, vx, vy, vz, mass, count };
    static constexpr std::array<Quantity, count> quantities = {
        {{{"x"}},
         {{"y"}},
         {{"z"}},
         {{"r", "radius"}, "a second column of radii; name one column r or radius"},
         {{"vx"}},
         {{"vy"}},
         {{"vz"}},
         {{"m", "mass"}, "a second column of masses; name one column m or mass"}}};

    static constexpr std::string_view all_but_mass =
        "x, y, r (or radius), vx and vy, in space also z and vz";

    /// Tells from the first line, which is no header, where the balls lie. Where it has no number
    /// of columns that any ball has, read_ball() says so.
    void count_columns() {
        if (columns_.size() <= 6) return;
        result_.dimension = 3;
        places_ = {0, 1, 2, 3, 4, 5, 6, 7};
        least_ = 7;
        most_ = 8;
    }

    void read_header() {
        const auto [places, others] = named_columns(columns_, quantities);
        std::ranges::copy(places, places_.begin());
        if (places_[z] != no_column || places_[vz] != no_column) result_.dimension = 3;
        refuse_missing();
        named_ = true;
        least_ = most_ = columns_.size();
        if (others.empty()) return;
        columns_.keep_separator();
        result_.note = fmt::format("{}: {} {} left out: a ball has {}, and m (or mass)",
                                   columns_.place_of_line(), enumerated(others),
                                   others.size() == 1 ? "is" : "are", all_but_mass);
    }

    /// A header must name all but the mass, which the radius can tell.
    void refuse_missing() const {
        std::vector<std::string> missing;
        for (const std::size_t which : {x, y, z, radius, vx, vy, vz}) {
            const bool wanted = result_.dimension == 3 || (which != z && which != vz);
            if (wanted && places_[which] == no_column)
                missing.emplace_back(quantities[which].names[0]);
        }
        if (missing.empty()) return;
        columns_.fail_at(0, fmt::format("the header does not name {}; name the columns {}",
                                        enumerated(missing), all_but_mass));
    }

    void read_ball() {
        if (columns_.size() < least_ || columns_.size() > most_) fail_at_size();
        std::array<double, count> numbers = {};
        for (std::size_t which = 0; which < count; ++which)
            if (has(which)) numbers[which] = columns_.number(places_[which]);
        if (numbers[radius] < 0.0) {
            columns_.fail_at(places_[radius],
                             fmt::format("{} is a negative radius; write 0 or more",
                                         in_quotes(columns_.text(places_[radius]))));
        }
        if (!has(mass)) {
            numbers[mass] = missing_mass(numbers[radius]);
        } else if (numbers[mass] <= 0.0) {
            columns_.fail_at(places_[mass],
                             fmt::format("{} is a mass that is not positive; write one above 0",
                                         in_quotes(columns_.text(places_[mass]))));
        }
        BallLine ball;
        ball.x = {numbers[x], numbers[y], numbers[z]};
        ball.v = {numbers[vx], numbers[vy], numbers[vz]};
        ball.radius = numbers[radius];
        ball.mass = numbers[mass];
        ball.position.line = columns_.position_of(columns_[0].data()).line;
        result_.balls.push_back(ball);
    }

    /// Whether this line has the quantity.
    [[nodiscard]] bool has(std::size_t which) const { return places_[which] < columns_.size(); }

    [[nodiscard]] double missing_mass(double radius_of_ball) const {
        const double power = mass_of_radius(radius_of_ball, result_.dimension);
        if (power > std::numeric_limits<double>::min() &&
            power <= std::numeric_limits<double>::max())
            return power;
        const std::string why =
            radius_of_ball == 0.0
                ? "a ball of radius 0 needs a mass"
                : fmt::format(
                      "a ball of radius {} needs a mass, since r^{} is beyond the range of "
                      "a double",
                      in_quotes(columns_.text(places_[radius])), result_.dimension);
        columns_.fail_at(places_[radius],
                         fmt::format("{}; write it {}", why,
                                     named_ ? "in a column that the header calls m or mass"
                                            : "in one more column, the last"));
    }

    [[noreturn]] void fail_at_size() const {
        const std::size_t size = columns_.size();
        if (size > most_ && columns_[most_].empty()) columns_.fail_at_empty(most_);
        std::string message = size == 1 ? "one column" : fmt::format("{} columns", size);
        if (named_) {
            message += fmt::format(", but the header names {}; write as many", most_);
        } else if (result_.balls.empty()) {
            message += fmt::format(
                "; a ball is x y r vx vy [mass] in the plane and x y z r vx vy vz [mass] in "
                "space{}, or name the columns in a first line",
                size > most_ && columns_.has_comma() ? ", a fraction has a point" : "");
        } else {
            message += fmt::format(", but the first ball lies in {} in every line",
                                   result_.dimension == 2 ? "the plane; write x y r vx vy [mass]"
                                                          : "space; write x y z r vx vy vz [mass]");
        }
        if (size < least_) columns_.fail_at_end_of_line(message);
        columns_.fail_at(most_, message);
    }

    TextColumns columns_;
    BallsFile result_;
    /// The columns of the quantities, in the plane and without a header; no_column where there is
    /// none.
    std::array<std::size_t, count> places_ = {0, 1, no_column, 2, 3, 4, no_column, 5};
    std::size_t least_ = 5;  ///< columns in a line
    std::size_t most_ = 6;
    bool named_ = false;  ///< the columns, by a header
};

/// Whether the first line that says something is one of TOML: [table] or key = value.
bool looks_like_scene(std::string_view text) {
    constexpr std::string_view blanks = " \t\r";
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    while (!text.empty()) {
        std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(text.size(), line.size() + 1));
        line.remove_prefix(std::min(line.size(), line.find_first_not_of(blanks)));
        if (line.empty() || line.front() == '#') continue;
        const bool is_table = line.front() == '[';
        while (line.starts_with('[')) line.remove_prefix(1);
        if (line.empty() || !is_letter(line.front())) return false;
        if (is_table) return true;
        const std::size_t end = line.find_first_of(" \t=");
        const std::size_t sign = line.find_first_not_of(blanks, end);
        return sign != std::string_view::npos && line[sign] == '=';
    }
    return false;
}

}  // namespace

// Below the smallest normal double a cube would be rounded twice.
double mass_of_radius(double radius, int dimension) {
    if (dimension == 2) return radius * radius;
    int exponent = 0;
    const double m = std::frexp(radius, &exponent);
    return std::ldexp(cube_to_nearest(m), 3 * exponent);
}

BallsFile read_balls(const std::string& path) {
    InputFile file(path, "a file of balls");
    if (looks_like_scene(file.first_bytes())) {
        file.fail({}, path == "-" ? "this looks like a scene, which is read from a file alone; "
                                    "give one whose name ends in .toml"
                                  : "this looks like a scene; its name must end in .toml");
    }
    if (looks_like_frames(file.first_bytes())) {
        file.fail(
            {},
            "these look like frames in XYZ, which a scene reads; give a scene of which [balls] "
            "has file, this one");
    }
    const char first = file.first_character();
    if (first == '[' || first == '{') {
        file.fail({},
                  fmt::format("this looks like JSON, and balls are read from text alone, states "
                              "by --resume; {}",
                              advice_on_balls));
    }
    return TextBalls(file).read();
}

}  // namespace signum
