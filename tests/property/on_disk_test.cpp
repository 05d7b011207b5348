/// Tessellations whose sites lie on a disk have the faces of the whole, in order: read in slices of
/// any number, in parts of any number, by one thread or several.

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <system_error>
#include <vector>

#include <gtest/gtest.h>

#include "../../tool/generate/generate.hpp"
#include "../../triangulation/distributed/on_disk.hpp"
#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../thoroughness.hpp"

namespace signum {
namespace {

using distributed::Placed;
using distributed::WholeCounts;

template <class S>
distributed::SlicedSites in_slices(const std::vector<S>& sites, std::size_t slices) {
    return {slices, [&sites, slices](std::size_t slice) {
                std::vector<Placed> some;
                const std::size_t end = sites.size() * (slice + 1) / slices;
                for (std::size_t i = sites.size() * slice / slices; i < end; ++i)
                    some.push_back({sites[i], static_cast<std::int64_t>(i)});
                return some;
            }};
}
std::function<std::size_t(std::int64_t)> in_parts(std::size_t parts) {
    return [parts](std::int64_t) { return parts; };
}
const std::string folder = std::filesystem::temp_directory_path().string();

struct Result {
    WholeCounts counts;
    std::vector<std::int64_t> numbers;  ///< of faces or cells
    std::vector<double> told;
};
template <class S>
Result built(const std::vector<S>& sites, std::size_t slices, Metric metric,
             distributed::DiskOptions options) {
    Result result;
    options.folder = folder;
    options.progress = [&](double share) { result.told.push_back(share); };
    distributed::triangulate_on_disk(
        in_slices(sites, slices), {.metric = metric, .dimension = std::same_as<S, Site3> ? 3U : 2U},
        options, [&](const WholeCounts& counts) { result.counts = counts; },
        [&](std::span<const std::int64_t> numbers) {
            result.numbers.insert(result.numbers.end(), numbers.begin(), numbers.end());
        });
    return result;
}

class OnDiskFaces : public testing::TestWithParam<Metric> {};

TEST_P(OnDiskFaces, AreThoseOfTheWhole) {
    for (const Distribution distribution : all_distributions) {
        const int count = is_fast ? 20'000 : 3000;
        const std::vector<Site> sites = generate(distribution, {.count = count, .radius_to = 3.0});
        const Tessellation whole = triangulate(sites, GetParam(), {.threads = 1});
        std::vector<std::int64_t> numbers;
        for (const Face& face : whole.faces())
            numbers.insert(numbers.end(), face.begin(), face.end());
        for (const auto& [slices, parts, threads] :
             {std::array<std::size_t, 3>{1, 1, 1}, {3, 4, 2}, {7, 5, 1}}) {
            const Result found =
                built(sites, slices, GetParam(),
                      {.parts = in_parts(parts), .threads = static_cast<int>(threads)});
            ASSERT_EQ(found.numbers, numbers) << name_of(distribution) << ", " << parts << " parts";
            EXPECT_EQ(found.counts.sites, count);
            EXPECT_EQ(found.counts.parts, parts);
            EXPECT_EQ(found.counts.hidden, static_cast<std::int64_t>(whole.hidden().size()));
            EXPECT_EQ(found.counts.faces, static_cast<std::int64_t>(whole.faces().size()));
            EXPECT_EQ(
                found.counts.infinite_faces,
                std::ranges::count(whole.faces(), -1, [](const Face& face) { return face[0]; }));
            EXPECT_TRUE(std::ranges::is_sorted(found.told));
            EXPECT_EQ(found.told.back(), 1.0);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(, OnDiskFaces, testing::ValuesIn(all_metrics),
                         [](const testing::TestParamInfo<Metric>& info) {
                             return std::string(name_of(info.param));
                         });

TEST(OnDisk, CellsAreThoseOfTheWhole) {
    for (const SpaceDistribution distribution : all_space_distributions) {
        const std::vector<Site3> sites =
            generate(distribution, {.count = is_fast ? 4000 : 1000, .radius_to = 30.0});
        const SpaceTessellation whole =
            triangulate(std::span<const Site3>(sites), Power(), {.threads = 1});
        if (whole.dimension < 3) continue;
        std::vector<std::int64_t> numbers;
        for (const SpaceCell& cell : whole.cells)
            numbers.insert(numbers.end(), cell.begin(), cell.end());
        for (const std::size_t parts : {1U, 4U}) {
            const Result found =
                built(sites, 3, Metric::power, {.parts = in_parts(parts), .threads = 2});
            ASSERT_EQ(found.numbers, numbers) << name_of(distribution) << ", " << parts << " parts";
            EXPECT_EQ(found.counts.hidden, static_cast<std::int64_t>(whole.hidden.size()));
        }
    }
    const std::vector<Site3> sites = {{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
    EXPECT_THROW(static_cast<void>(built(sites, 1, Metric::euclidean, {})), std::invalid_argument);
}

TEST(OnDisk, SaysWhatItCannot) {
    std::vector<Site> sites = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    const auto build = [&](const distributed::DiskOptions& options) {
        static_cast<void>(built(sites, 2, Metric::power, options));
    };
    EXPECT_THROW(build({.parts = in_parts(2)}), distributed::NoStructure);
    sites = {};
    EXPECT_THROW(build({.parts = in_parts(2)}), distributed::NoStructure);
    sites = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    EXPECT_NO_THROW(build({.parts = in_parts(500)}));
    EXPECT_THROW(build({.parts = in_parts(0)}), std::invalid_argument);
    EXPECT_THROW(build({.parts = in_parts(501)}), std::invalid_argument);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(build({.parts = in_parts(2), .stop = stop.get_token()}), Stopped);
    sites[1].r = HUGE_VAL;
    EXPECT_THROW(build({.parts = in_parts(2)}), std::invalid_argument);
}

TEST(OnDisk, SaysWhereItCannotWrite) {
    const std::vector<Site> sites = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    EXPECT_THROW(distributed::triangulate_on_disk(
                     in_slices(sites, 1), {}, {.parts = in_parts(2), .folder = "/nowhere"},
                     [](const WholeCounts&) {}, [](std::span<const std::int64_t>) {}),
                 std::system_error);
}

}  // namespace
}  // namespace signum
