/// In an environment other than the default one, where a bound may not hold, no filter tells
/// anything of its own; and what it tells in the default one is told by the first stage behind it.

#include <array>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../../filters/interval.hpp"
#include "../../predicates/additive.hpp"
#include "../../predicates/ccw.hpp"
#include "../../predicates/euclidean/filter.hpp"
#include "../../predicates/power.hpp"
#include "../../predicates/rectangular/squares.hpp"
#include "../../predicates/space.hpp"
#include "../../predicates/space/ball_filter.hpp"
#include "../../roots/filter.hpp"
#include "../../triangulation/moving/bounded_forms.hpp"
#include "../property/environments.hpp"

namespace signum {
namespace {

struct Question {
    std::string of;
    std::function<bool()> is_certain;  ///< far away from a tie
};

const Site i{0, 0, 0.5};
const Site j{4, 0, 0.25};
const Site k{0, 4, 0.125};
const Site q{1, 1, 0.25};
const Site3 a{0, 0, 0, 0.5};
const Site3 b{4, 0, 0, 0.25};
const Site3 c{0, 4, 0, 0.125};
const Site3 d{0, 0, 4, 0.25};
const Site3 e{1, 1, 1, 0.25};

template <class Directions>
bool forms_are_certain() {
    using Asked = rectangular::Perturbed<Directions>;
    return Asked::exists(i, j, k, {0, 1, 2}).stage == Stage::filter;
}

const std::vector<Question>& questions() {
    namespace plane = euclidean::filter;
    namespace balls = euclidean::balls::filter;
    using rectangular::Manhattan;
    using rectangular::Supremum;
    static const std::vector<Question> all = {
        {"ccw", [] { return predicates::ccw_filter(i, j, k).is_certain(); }},
        {"in_circle", [] { return power::in_circle_filter(i, j, k, q).is_certain(); }},
        {"ccw of space", [] { return predicates::ccw_filter(a, b, c, d).is_certain(); }},
        {"in_sphere", [] { return power::in_sphere_filter(a, b, c, d, e).is_certain(); }},
        {"nearer of space",
         [] {
             return power::nearer_filter(Point3{1, 0, 0}, a, b).is_certain();
         }},
        {"euclidean hides", [] { return plane::hides(i, q).is_certain(); }},
        {"euclidean exists", [] { return plane::exists(i, j, k).is_certain(); }},
        {"euclidean exists_twice", [] { return plane::exists_twice(i, j, k).is_certain(); }},
        {"euclidean in_circle", [] { return plane::in_circle(i, j, k, q).is_certain(); }},
        {"euclidean in_circle_of_visible",
         [] { return plane::in_circle_of_visible(i, j, k, q).is_certain(); }},
        {"euclidean in_circle_infinite",
         [] { return plane::in_circle_infinite(i, j, q).is_certain(); }},
        {"balls hides", [] { return balls::hides<3>(a, e).is_certain(); }},
        {"balls exists", [] { return balls::exists<3>(a, b, c, d).is_certain(); }},
        {"balls in_sphere", [] { return balls::in_sphere<3>(e, a, b, c, d).is_certain(); }},
        {"supremum", forms_are_certain<Supremum>},
        {"manhattan", forms_are_certain<Manhattan>},
        {"nearer of distances",
         [] {
             return additive::nearer({1, 1, 0.25}, {4, 4, 0.5}).is_certain();
         }},
        {"intervals", [] { return filters::exceeds(filters::Interval(4.0), 1.0); }},
        {"sign of an approximation",
         [] { return roots::filter::sign(roots::Approximation(2.0, 0.5)).is_certain(); }},
        {"turn of moving sites",
         [] {
             const auto at = [](const Site& s) { return MovingSite{s.x, s.y, 0, 0, s.r, 0}; };
             return kinetic::bounded_turn(at(i), at(j), at(k), {}, 0.0).is_certain();
         }},
    };
    return all;
}

TEST(Environments, FiltersTellInTheDefaultOneAlone) {
    for (const Question& question : questions()) {
        EXPECT_TRUE(question.is_certain()) << question.of;
        for (int environment = 1; environment < environments; ++environment)
            EXPECT_FALSE(within(environment, question.is_certain))
                << question.of << ", " << name_of_environment(environment);
    }
}

/// Where the filter declined for the environment's sake alone nothing dear is needed.
TEST(Environments, AFilterThatDeclinedIsAskedInTheDefaultOne) {
    const std::vector<std::pair<std::string, std::function<Decision()>>> decisions = {
        {"ccw", [] { return ccw_decision(i, j, k); }},
        {"in_circle", [] { return power::in_circle_decision(i, j, k, q); }},
        {"ccw of space", [] { return ccw_decision(a, b, c, d); }},
        {"in_sphere", [] { return power::in_sphere_decision(a, b, c, d, e); }},
        {"nearer of space",
         [] {
             return power::nearer_decision(Point3{1, 0, 0}, a, b);
         }},
        {"balls exists", [] { return euclidean::exists_decision(a, b, c, d); }},
        {"balls in_sphere", [] { return euclidean::in_sphere_decision(a, b, c, d, e); }},
    };
    for (const auto& [of, decision] : decisions) {
        const Sign sign = decision().sign;
        for (int environment = 0; environment < environments; ++environment) {
            const Decision told = within(environment, decision);
            EXPECT_EQ(told.sign, sign) << of;
            EXPECT_EQ(told.stage, Stage::filter) << of << ", " << name_of_environment(environment);
        }
    }
}

}  // namespace
}  // namespace signum
