#pragma once
/// What is asked of balls in flight: when two of them meet, which of two meetings comes first, and
/// who strikes whom until a time. All have the mass 1 and nothing is lost.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "hard_case.hpp"

namespace signum::hard {

/// The numbers of a ball.
template <std::size_t D>
struct Flight {
    std::array<double, D> x{};
    double radius = 0;
    std::array<double, D> v{};
};

struct StrikeOfTwo {
    double time = 0;
    std::int32_t a = 0;
    std::int32_t b = 0;
};

/// More strikes than these are not asked for.
inline constexpr std::size_t most_strikes = 200;

/// A time, so that the double can be read again.
inline std::string time_text(double time) {
    if (std::isinf(time)) return "never";
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%a", time);
    return text.data();
}

/// What is said of the case. make(flights) is an object with meeting_time(a, b), infinity for
/// never, and strikes(until), a vector of StrikeOfTwo.
template <std::size_t D, class Make>
Lines motion_answers(const Case& given, const Make& make) {
    AnswerLines lines;
    for (std::size_t step = 0; step < given.family.steps(); ++step) {
        lines.begin_step();
        std::vector<Flight<D>> flights;
        for (const Row& row : given.family.applied(given.rows, step)) {
            Flight<D> flight;
            for (std::size_t k = 0; k < D; ++k) {
                flight.x[k] = row[k];
                flight.v[k] = row[D + 1 + k];
            }
            flight.radius = row[D];
            flights.push_back(flight);
        }
        const auto answers = make(flights);
        for (const auto& asked : given.asked) {
            const double time = answers.meeting_time(asked.at(0), asked.at(1));
            if (asked.size() == 2) {
                lines.add("meeting " + joined(asked), time_text(time));
                continue;
            }
            const double other = answers.meeting_time(asked.at(2), asked.at(3));
            lines.add("order " + joined(asked), letter(time > other ? 1 : time < other ? -1 : 0));
        }
        if (!given.until) continue;
        std::string who;
        std::string when;
        for (const StrikeOfTwo& strike : answers.strikes(*given.until)) {
            who += (who.empty() ? "" : ", ") + joined(std::array{strike.a, strike.b});
            when += (when.empty() ? "" : " ") + time_text(strike.time);
        }
        lines.add_long("strikes", who.empty() ? "none" : who);
        if (given.family.kind == Family::Kind::none && !when.empty()) lines.add_long("times", when);
    }
    return lines.text();
}

}  // namespace signum::hard
