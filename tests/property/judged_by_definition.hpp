#pragma once
/// validate() of the power metric beside the oracle, which judges by the definition.

#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../../triangulation/arrays.hpp"
#include "../../triangulation/validate.hpp"
#include "../oracle/valid_power.hpp"

namespace signum {

/// Empty where the arrays are a power tessellation of the sites, however ties are decided.
template <class S>
std::string wrong_by_definition(const TessellationArrays& arrays, const std::vector<S>& sites) {
    if (arrays.sites != static_cast<std::int64_t>(sites.size())) return "so many sites";
    oracle::Tessellation tessellation;
    tessellation.faces = arrays.faces;
    for (const auto& [site, by] : arrays.hidden) tessellation.hidden.push_back({site, by});
    return oracle::what_is_wrong(tessellation, arrays.neighbours, std::span<const S>(sites));
}

/// How often what was judged was what.
struct Verdicts {
    int canonical = 0;
    int valid_alone = 0;
    int wrong = 0;
};

/// `home`: what triangulate() makes of the sites.
template <class S>
void expect_judged_by_definition(const TessellationArrays& arrays, const std::vector<S>& sites,
                                 const TessellationArrays& home, Verdicts& verdicts) {
    const Validation result = validate(arrays, sites);
    const std::string wrong = wrong_by_definition(arrays, sites);
    ASSERT_EQ(result.valid, wrong.empty()) << result.message << "; by definition: " << wrong;
    ASSERT_EQ(result.canonical, arrays == home) << result.message;
    ASSERT_EQ(result.canonical, result.message.empty());
    ++(result.canonical ? verdicts.canonical
       : result.valid   ? verdicts.valid_alone
                        : verdicts.wrong);
}

}  // namespace signum
