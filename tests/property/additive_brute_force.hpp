#pragma once
/// The tessellation that the perturbed predicates of an additive metric choose: every question is
/// asked, no algorithm decides which.

#include "../../core/index.hpp"
#include "../../core/site.hpp"
#include "../../predicates/additive.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "../oracle/oracle.hpp"

namespace signum::brute_force {

using Sites = std::vector<Site>;

inline std::size_t at(Index i) {
    return static_cast<std::size_t>(i);
}

/// The place of every site in the order of the tie rule.
inline std::vector<Index> ranks_of(const Sites& sites) {
    std::vector<Index> order(sites.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
        return additive::precedes(sites[at(a)], a, sites[at(b)], b);
    });
    std::vector<Index> ranks(sites.size());
    for (std::size_t i = 0; i < order.size(); ++i) ranks[at(order[i])] = static_cast<Index>(i);
    return ranks;
}
inline std::array<Index, 4> ranks_of(const Site (&s)[4]) {
    const std::vector<Index> ranks = ranks_of(Sites{s, s + 4});
    return {ranks[0], ranks[1], ranks[2], ranks[3]};
}

/// Every triple of visible sites that has a vertex with which no other site conflicts.
template <class Predicates>
oracle::Tessellation tessellation(const Sites& sites) {
    const std::vector<Index> rank = ranks_of(sites);
    const auto n = static_cast<Index>(sites.size());
    std::vector<Index> visible;
    oracle::Tessellation result;
    for (Index q = 0; q < n; ++q) {
        bool hidden = false;
        for (Index i = 0; i < n; ++i)
            hidden |=
                i != q &&
                Predicates::hides(sites[at(i)], sites[at(q)], {rank[at(i)], rank[at(q)]}).sign > 0;
        if (hidden) {
            result.hidden.push_back({q, -1});
        } else {
            visible.push_back(q);
        }
    }
    const auto none = [&](auto conflicts, std::initializer_list<Index> but) {
        return std::none_of(visible.begin(), visible.end(), [&](Index q) {
            return std::find(but.begin(), but.end(), q) == but.end() && conflicts(q).sign > 0;
        });
    };
    for (const Index i : visible)
        for (const Index j : visible) {
            if (i == j) continue;
            const Site& a = sites[at(i)];
            const Site& b = sites[at(j)];
            if (none(
                    [&](Index q) {
                        return Predicates::in_circle_infinite(
                            a, b, sites[at(q)], {rank[at(i)], rank[at(j)], rank[at(q)]});
                    },
                    {i, j}))
                result.faces.push_back({-1, j, i});
            for (const Index k : visible) {
                if (k <= i || k == j || j <= i) continue;
                const Site& c = sites[at(k)];
                if (Predicates::exists(a, b, c, {rank[at(i)], rank[at(j)], rank[at(k)]}).sign < 0)
                    continue;
                if (none(
                        [&](Index q) {
                            return Predicates::in_circle(
                                a, b, c, sites[at(q)],
                                {rank[at(i)], rank[at(j)], rank[at(k)], rank[at(q)]});
                        },
                        {i, j, k}))
                    result.faces.push_back({i, j, k});
            }
        }
    std::sort(result.faces.begin(), result.faces.end());
    return result;
}

/// Faces and hidden sites are those of the oracle.
template <class Predicates>
void expect_oracle(const Sites& sites, const oracle::Tessellation& expected) {
    const auto chosen = tessellation<Predicates>(sites);
    std::string input;
    for (const Site& s : sites)
        input += testing::PrintToString(s.x) + " " + testing::PrintToString(s.y) + " " +
                 testing::PrintToString(s.r) + "\n";
    ASSERT_EQ(chosen.faces, expected.faces) << input;
    ASSERT_EQ(chosen.hidden.size(), expected.hidden.size()) << input;
    for (std::size_t i = 0; i < chosen.hidden.size(); ++i)
        ASSERT_EQ(chosen.hidden[i][0], expected.hidden[i][0]) << input;
}

}  // namespace signum::brute_force
