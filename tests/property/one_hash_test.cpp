/// One number for all that constructions give, whatever the number of threads: a pinned hash of the
/// arrays of every metric, of space, of every distribution and of sites made to be hard.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "../../core/insertion_rounds.hpp"
#include "../../tool/generate/generate.hpp"
#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/triangulate.hpp"

namespace signum {
namespace {

class Hash {
 public:
    void add(Index number) noexcept {
        value_ = mix(value_ * 0x9E3779B97F4A7C15U + static_cast<std::uint32_t>(number));
    }
    template <std::size_t n>
    void add(const std::array<Index, n>& numbers) noexcept {
        for (const Index number : numbers) add(number);
    }
    void add(const Hidden& hidden) noexcept { add(std::array{hidden.site, hidden.by}); }
    template <class T>
    void add_all(const std::vector<T>& list) noexcept {
        add(static_cast<Index>(list.size()));
        for (const T& item : list) add(item);
    }
    [[nodiscard]] std::uint64_t value() const noexcept { return value_; }

 private:
    std::uint64_t value_ = 1;
};

/// Enough that several threads work, in space too; and that they do at its joins.
constexpr std::int64_t count = 20'000;
constexpr std::int64_t count_in_space = 70'000;
constexpr std::int64_t count_for_joins = 400'000;

std::uint64_t hash_of_all(int threads) {
    Hash hash;
    std::vector<std::vector<Site>> sets = {generate_hard({.count = count})};
    for (const Distribution distribution : all_distributions)
        sets.push_back(generate(distribution, {.count = count, .radius_to = 3.0}));
    for (const std::vector<Site>& sites : sets)
        for (const Metric metric : all_metrics)
            for (const Order order : all_orders) {
                const TessellationArrays arrays =
                    triangulate(sites, metric, {.order = order, .threads = threads}).arrays();
                hash.add_all(arrays.faces);
                hash.add_all(arrays.neighbours);
                hash.add_all(arrays.hidden);
            }
    std::vector<std::vector<Site3>> sets_in_space = {
        generate_hard_in_space({.count = count_in_space}),
        generate(SpaceDistribution::random, {.count = count_for_joins, .radius_to = 3.0})};
    for (const SpaceDistribution distribution : all_space_distributions)
        sets_in_space.push_back(
            generate(distribution, {.count = count_in_space, .radius_to = 15.0}));
    for (const std::vector<Site3>& sites : sets_in_space) {
        const SpaceTessellation tessellation = triangulate(sites, Power{}, {.threads = threads});
        hash.add_all(tessellation.cells);
        hash.add_all(tessellation.neighbours);
        hash.add_all(tessellation.hidden);
    }
    return hash.value();
}

class OneHash : public testing::TestWithParam<int> {};

TEST_P(OneHash, WhateverTheNumberOfThreads) {
    EXPECT_EQ(hash_of_all(GetParam()), 8510114235063970147U);
}

INSTANTIATE_TEST_SUITE_P(, OneHash, testing::Values(1, 2, 3, 7, 16),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace signum
