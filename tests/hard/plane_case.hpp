#pragma once
/// What is asked of sites in the plane.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "../../core/site.hpp"
#include "hard_case.hpp"

namespace signum::hard {

/// In `weights` the third number of a site is the weight of a power site, not its radius.
inline constexpr std::array plane_metrics = {"power", "weights", "euclidean", "manhattan",
                                             "supremum"};

/// Who answers, for one set of sites in one metric. Sites are named by their numbers, circles touch
/// them counterclockwise.
class PlaneAnswers {
 public:
    using Number = std::size_t;
    PlaneAnswers() = default;
    PlaneAnswers(const PlaneAnswers&) = delete;
    PlaneAnswers& operator=(const PlaneAnswers&) = delete;
    virtual ~PlaneAnswers() = default;

    [[nodiscard]] virtual bool hides(Number i, Number q) const = 0;
    /// Under the tie rule. None of the three hides another.
    [[nodiscard]] virtual bool exists(Number i, Number j, Number k) const = 0;
    /// The letter, or open: without the tie rule. The circle exists, and none of its three hides
    /// q.
    [[nodiscard]] virtual std::string in_circle(Number i, Number j, Number k, Number q) const = 0;
    /// Under the tie rule. The circle exists.
    [[nodiscard]] virtual bool conflicts(Number i, Number j, Number k, Number q) const = 0;
    /// Under the tie rule, at the hull edge from a to b. Neither hides the other.
    [[nodiscard]] virtual bool conflicts_at_infinity(Number a, Number b, Number q) const = 0;
    [[nodiscard]] virtual std::vector<std::array<std::int32_t, 3>> faces() const = 0;
    /// {site, by}
    [[nodiscard]] virtual std::vector<std::array<std::int32_t, 2>> hidden() const = 0;
};

/// "0 1 2, 0 2 3; 4 by 1"
inline std::string text_of(const std::vector<std::array<std::int32_t, 3>>& faces,
                           const std::vector<std::array<std::int32_t, 2>>& hidden) {
    std::string text;
    for (const auto& face : faces) text += (text.empty() ? "" : ", ") + joined(face);
    for (std::size_t i = 0; i < hidden.size(); ++i)
        text += (i == 0 ? "; " : ", ") + std::to_string(hidden[i][0]) + " by " +
                std::to_string(hidden[i][1]);
    return text;
}

/// Asks the predicates about i, j, k, q.
inline void ask_predicates(const std::string& metric, const PlaneAnswers& answers,
                           const std::vector<std::size_t>& sites, AnswerLines& lines) {
    const auto [i, j, k, q] = std::array{sites.at(0), sites.at(1), sites.at(2), sites.at(3)};
    const auto apart = [&](std::size_t a, std::size_t b) {
        return !answers.hides(a, b) && !answers.hides(b, a);
    };
    const std::string triple = joined(std::array{i, j, k});
    const std::string all = joined(sites);

    lines.add(metric + " hidden " + std::to_string(q) + " by " + std::to_string(i),
              letter(answers.hides(i, q)));
    const bool separate = apart(i, j) && apart(j, k) && apart(i, k);
    const bool exists = separate && answers.exists(i, j, k);
    lines.add(metric + " exists " + triple, separate ? letter(exists) : unasked);
    const bool covered = answers.hides(i, q) || answers.hides(j, q) || answers.hides(k, q);
    lines.add(metric + " in_circle " + all,
              exists && !covered ? answers.in_circle(i, j, k, q) : unasked);
    lines.add(metric + " in_circle_perturbed " + all,
              exists ? letter(answers.conflicts(i, j, k, q)) : unasked);
    lines.add(metric + " in_circle_infinite_perturbed " + joined(std::array{i, j, q}),
              apart(i, j) ? letter(answers.conflicts_at_infinity(i, j, q)) : unasked);
}

/// What is said of the case. make(metric, sites) is a pointer to PlaneAnswers; turn(a, b, c) is the
/// sign of ccw.
template <class Make, class Turn>
Lines plane_answers(const Case& given, const Make& make, const Turn& turn) {
    AnswerLines lines;
    for (std::size_t step = 0; step < given.family.steps(); ++step) {
        lines.begin_step();
        std::vector<Site> sites;
        for (const Row& row : given.family.applied(given.rows, step))
            sites.push_back({row[0], row[1], row[2]});
        for (const auto& asked : given.asked)
            lines.add("ccw " + joined(std::array{asked.at(0), asked.at(1), asked.at(2)}),
                      letter(turn(sites[asked[0]], sites[asked[1]], sites[asked[2]])));
        for (const char* metric : plane_metrics) {
            const auto answers = make(metric, sites);
            for (const auto& asked : given.asked) ask_predicates(metric, *answers, asked, lines);
            lines.add_long(std::string(metric) + " faces",
                           text_of(answers->faces(), answers->hidden()));
        }
    }
    return lines.text();
}

}  // namespace signum::hard
