#pragma once
/// What is asked of sites in space.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "../../core/site.hpp"
#include "hard_case.hpp"

namespace signum::hard {

/// Simplices of a power tessellation, each with its numbers rising; flat sites have fewer.
struct SpaceCells {
    int dimension = -1;
    std::vector<std::vector<std::int32_t>> cells;
    std::vector<std::vector<std::int32_t>> hull;
    std::vector<std::array<std::int32_t, 2>> hidden;  ///< {site, by}
};

/// A vertex of the diagram of balls: those that touch its sphere, and how the points of contact
/// turn.
using BallsOfVertex = std::pair<std::vector<std::int32_t>, int>;

/// Who answers, for one set of sites. Nothing is perturbed but the tessellation.
class SpaceAnswers {
 public:
    using Number = std::size_t;
    using Four = std::array<Number, 4>;
    SpaceAnswers() = default;
    SpaceAnswers(const SpaceAnswers&) = delete;
    SpaceAnswers& operator=(const SpaceAnswers&) = delete;
    virtual ~SpaceAnswers() = default;

    [[nodiscard]] virtual int turn(const Four& four) const = 0;
    /// The four turn positively. The fourth number of a site is its radius, or its weight.
    [[nodiscard]] virtual int in_power_sphere(const Four& four, Number q, bool is_weight) const = 0;
    /// Whether a sphere touches the balls, its points of contact positively oriented.
    [[nodiscard]] virtual bool exists(const Four& four) const = 0;
    /// That sphere.
    [[nodiscard]] virtual int in_sphere(const Four& four, Number q) const = 0;
    /// What in_sphere says of all cubes (octahedra) that touch the four; whether there are
    /// infinitely many.
    [[nodiscard]] virtual std::pair<std::vector<int>, bool> in_spheres(
        const Four& four, Number q, bool is_octahedron) const = 0;
    /// In the metrics euclidean, manhattan and supremum.
    [[nodiscard]] virtual bool hides(const std::string& metric, Number i, Number q) const = 0;
    /// The fourth number is the weight.
    [[nodiscard]] virtual SpaceCells cells() const = 0;
    [[nodiscard]] virtual std::vector<BallsOfVertex> vertices() const = 0;
};

inline std::string text_of(const SpaceCells& cells) {
    const auto lists = [](const auto& all, const std::string& between) {
        std::string text;
        for (const auto& one : all) {
            std::string numbers;
            for (const std::int32_t number : one)
                numbers += (numbers.empty() ? "" : between) + std::to_string(number);
            text += (text.empty() ? "" : ", ") + numbers;
        }
        return text;
    };
    std::string text = std::to_string(cells.dimension) + " dimensions; " + lists(cells.cells, " ") +
                       "; hull " + lists(cells.hull, " ");
    if (!cells.hidden.empty()) text += "; " + lists(cells.hidden, " by ");
    return text;
}

inline std::string text_of(std::vector<BallsOfVertex> vertices) {
    std::ranges::sort(vertices);
    std::string text;
    for (const auto& [balls, turn] : vertices)
        text += (text.empty() ? "" : ", ") + joined(balls) + " " + letter(turn);
    return text.empty() ? "none" : text;
}

inline void ask_predicates(const SpaceAnswers& answers, const std::vector<std::size_t>& sites,
                           AnswerLines& lines) {
    const SpaceAnswers::Four four = {sites.at(0), sites.at(1), sites.at(2), sites.at(3)};
    const std::size_t q = sites.at(4);
    const std::string all = joined(sites);
    const int turn = answers.turn(four);
    lines.add("ccw " + joined(four), letter(turn));
    for (const bool is_weight : {false, true})
        lines.add((is_weight ? "weights in_sphere " : "power in_sphere ") + all,
                  turn > 0 ? letter(answers.in_power_sphere(four, q, is_weight)) : unasked);
    const bool exists = answers.exists(four);
    lines.add("euclidean exists " + joined(four), letter(exists));
    lines.add("euclidean in_sphere " + all, exists ? letter(answers.in_sphere(four, q)) : unasked);
    for (const bool is_octahedron : {true, false}) {
        // Their order is the library's own.
        auto [signs, infinitely_many] = answers.in_spheres(four, q, is_octahedron);
        std::ranges::sort(signs);
        std::string text = infinitely_many ? "infinitely_many" : signs.empty() ? "none" : "";
        for (const int sign : signs) text += letter(sign);
        lines.add((is_octahedron ? "manhattan in_spheres " : "supremum in_spheres ") + all, text);
    }
    for (const char* metric : {"euclidean", "manhattan", "supremum"})
        lines.add(
            std::string(metric) + " hidden " + std::to_string(q) + " by " + std::to_string(four[0]),
            letter(answers.hides(metric, four[0], q)));
}

/// What is said of the case. make(sites) is a pointer to SpaceAnswers.
template <class Make>
Lines space_answers(const Case& given, const Make& make) {
    AnswerLines lines;
    for (std::size_t step = 0; step < given.family.steps(); ++step) {
        lines.begin_step();
        std::vector<Site3> sites;
        for (const Row& row : given.family.applied(given.rows, step))
            sites.push_back({row[0], row[1], row[2], row[3]});
        const auto answers = make(sites);
        for (const auto& asked : given.asked) ask_predicates(*answers, asked, lines);
        lines.add_long("weights cells", text_of(answers->cells()));
        lines.add_long("euclidean vertices", text_of(answers->vertices()));
    }
    return lines.text();
}

}  // namespace signum::hard
