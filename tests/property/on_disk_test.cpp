/// Tessellations whose sites lie on a disk have the faces of the whole, in order: read in slices of
/// any number, in parts of any number, by one thread or several. Pieces of a call that was cut off
/// lead to the same faces, damaged or not.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <system_error>
#include <utility>
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

TEST(OnDisk, SaysThatSitesHaveChanged) {
    std::vector<Site> sites = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 3, 0}};
    distributed::SlicedSites slices = in_slices(sites, 1);
    bool is_first = true;
    // Another place, one more, one less.
    const std::array<std::function<void(std::vector<Placed>&)>, 3> changes = {
        [](auto& some) { some[4].site.x = 4.0; },
        [](auto& some) {
            some.push_back({Site{5, 1, 0}, 5});
        },
        [](auto& some) { some.pop_back(); }};
    for (const auto& change : changes) {
        is_first = true;
        const distributed::SlicedSites changing = {1, [&](std::size_t slice) {
                                                       std::vector<Placed> some =
                                                           slices.read(slice);
                                                       if (!std::exchange(is_first, false))
                                                           change(some);
                                                       return some;
                                                   }};
        EXPECT_THROW(distributed::triangulate_on_disk(
                         changing, {.metric = Metric::power}, {.folder = folder},
                         [](const WholeCounts&) {}, [](std::span<const std::int64_t>) {}),
                     distributed::SitesChanged);
    }
}

TEST(OnDisk, SaysWhereItCannotWrite) {
    const std::vector<Site> sites = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    EXPECT_THROW(distributed::triangulate_on_disk(
                     in_slices(sites, 1), {}, {.parts = in_parts(2), .folder = "/nowhere"},
                     [](const WholeCounts&) {}, [](std::span<const std::int64_t>) {}),
                 std::system_error);
}

/// A folder for pieces, and calls that keep them there.
class OnDiskPieces : public testing::Test {
 protected:
    static constexpr std::size_t parts = 6;
    const std::vector<Site> sites =
        generate(Distribution::random, {.count = is_fast ? 20'000 : 3000, .radius_to = 3.0});
    std::string pieces = folder + "/signum-pieces-XXXXXX";
    distributed::PiecesFound found;  ///< by the last call

    OnDiskPieces() { EXPECT_NE(::mkdtemp(pieces.data()), nullptr); }
    OnDiskPieces(const OnDiskPieces&) = delete;
    OnDiskPieces& operator=(const OnDiskPieces&) = delete;
    ~OnDiskPieces() override { std::filesystem::remove_all(pieces); }

    [[nodiscard]] distributed::DiskOptions options(int threads = 1) {
        return {.parts = in_parts(parts),
                .threads = threads,
                .pieces = {.folder = pieces, .found = [&](const auto& some) { found = some; }}};
    }
    [[nodiscard]] std::vector<std::string> files(const std::string& what) const {
        std::vector<std::string> paths;
        for (const auto& entry : std::filesystem::directory_iterator(pieces))
            if (entry.path().filename().string().starts_with(what))
                paths.push_back(entry.path().string());
        std::ranges::sort(paths);
        return paths;
    }
    /// A call that is asked to stop once two parts are settled. How many it settles.
    template <class S>
    std::size_t stopped(const std::vector<S>& these, Metric metric) {
        std::stop_source stop;
        distributed::DiskOptions cut = options();
        cut.stop = stop.get_token();
        cut.folder = folder;
        cut.progress = [&](double) {
            if (files("faces-").size() == 2) stop.request_stop();
        };
        EXPECT_THROW(distributed::triangulate_on_disk(
                         in_slices(these, 3),
                         {.metric = metric, .dimension = std::same_as<S, Site3> ? 3U : 2U}, cut,
                         [](const WholeCounts&) {}, [](std::span<const std::int64_t>) {}),
                     Stopped);
        EXPECT_EQ(files("sites-").size(), parts);
        const std::size_t settled = files("faces-").size();
        EXPECT_GE(settled, 2U);
        EXPECT_LT(settled, parts);
        EXPECT_EQ(files("").size(), parts + settled);
        return settled;
    }
    template <class S>
    void expect_goes_on(const std::vector<S>& these, Metric metric) {
        const Result whole = built(these, 3, metric, {.parts = in_parts(parts)});
        EXPECT_EQ(whole.counts.settled, parts);
        const std::size_t settled = stopped(these, metric);
        const Result rest = built(these, 5, metric, options(2));
        EXPECT_EQ(rest.numbers, whole.numbers);
        EXPECT_EQ(rest.counts.settled, parts - settled);
        EXPECT_EQ(rest.counts.hidden, whole.counts.hidden);
        EXPECT_EQ(rest.counts.faces, whole.counts.faces);
        EXPECT_EQ(rest.counts.infinite_faces, whole.counts.infinite_faces);
        EXPECT_TRUE(std::ranges::is_sorted(rest.told));
        EXPECT_EQ(rest.told.back(), 1.0);
        EXPECT_EQ(found.all, 2 * parts);
        EXPECT_EQ(found.whole, parts + settled);
        EXPECT_TRUE(found.damaged.empty());
    }
};

TEST_F(OnDiskPieces, LeadToTheFacesOfTheWhole) {
    expect_goes_on(sites, Metric::power);
}

TEST_F(OnDiskPieces, LeadToThoseOfDiscs) {
    expect_goes_on(sites, Metric::euclidean);
}

TEST_F(OnDiskPieces, LeadToTheCellsOfSpace) {
    expect_goes_on(
        generate(SpaceDistribution::random, {.count = is_fast ? 4000 : 1000, .radius_to = 30.0}),
        Metric::power);
}

TEST_F(OnDiskPieces, AreAllThereWhenFacesCannotBePut) {
    const auto put_nothing = [](std::span<const std::int64_t>) {
        throw std::system_error(ENOSPC, std::generic_category());
    };
    distributed::DiskOptions cut = options();
    cut.folder = folder;
    EXPECT_THROW(distributed::triangulate_on_disk(
                     in_slices(sites, 3), {}, cut, [](const WholeCounts&) {}, put_nothing),
                 std::system_error);
    const Result rest = built(sites, 3, Metric::power, options());
    EXPECT_EQ(rest.numbers, built(sites, 1, Metric::power, {}).numbers);
    EXPECT_EQ(rest.counts.settled, 0U);
    EXPECT_EQ(found.whole, 2 * parts);
}

TEST_F(OnDiskPieces, AreMadeAnewWhereTheyAreDamaged) {
    const Result whole = built(sites, 3, Metric::power, options());
    EXPECT_EQ(found.whole, 0U);
    const auto size = [](const std::string& path) { return std::filesystem::file_size(path); };
    const auto flip = [](const std::string& path, std::uint64_t place) {
        std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
        file.seekg(static_cast<std::streamoff>(place));
        const auto byte = static_cast<char>(file.get() ^ 4);
        file.seekp(static_cast<std::streamoff>(place));
        file.put(byte);
    };
    const std::vector<std::string> faces = files("faces-");
    const std::vector<std::string> own = files("sites-");
    std::filesystem::resize_file(faces[0], 0);
    std::filesystem::resize_file(faces[1], size(faces[1]) - 24);
    flip(faces[2], size(faces[2]) / 2);
    flip(faces[3], size(faces[3]) - 12);  // of how many are hidden
    std::filesystem::copy_file(faces[5], faces[4],
                               std::filesystem::copy_options::overwrite_existing);
    flip(own[0], 100);
    std::filesystem::resize_file(own[1], size(own[1]) + 40);
    std::filesystem::remove(own[2]);
    const Result again = built(sites, 3, Metric::power, options());
    EXPECT_EQ(again.numbers, whole.numbers);
    EXPECT_EQ(again.counts.hidden, whole.counts.hidden);
    EXPECT_EQ(again.counts.settled, 5U);
    EXPECT_EQ(found.whole, parts - 3 + 1);
    std::vector<std::string> damaged = {own[0], own[1]};
    damaged.insert(damaged.end(), faces.begin(), faces.begin() + 5);
    EXPECT_EQ(found.damaged, damaged);
    EXPECT_EQ(built(sites, 3, Metric::power, options()).counts.settled, 0U);
}

TEST_F(OnDiskPieces, AreNotTakenForOtherWork) {
    const auto expect_nothing_taken = [&](const std::vector<Site>& these, Metric metric,
                                          const distributed::DiskOptions& call) {
        static_cast<void>(built(sites, 3, Metric::power, options()));
        const Result result = built(these, 3, metric, call);
        EXPECT_EQ(found.whole, 0U);
        EXPECT_EQ(result.numbers, built(these, 1, metric, {}).numbers);
    };
    std::vector<Site> others = sites;
    others.back().r += 1.0;
    expect_nothing_taken(others, Metric::power, options());
    expect_nothing_taken(sites, Metric::euclidean, options());
    distributed::DiskOptions in_fewer = options();
    in_fewer.parts = in_parts(parts - 1);
    expect_nothing_taken(sites, Metric::power, in_fewer);
}

TEST_F(OnDiskPieces, AreLeftToWhomTheyBelong) {
    WholeCounts asked;
    distributed::DiskOptions first = options();
    first.pieces.belong = [&](const WholeCounts& counts) { asked = counts; };
    static_cast<void>(built(sites, 3, Metric::power, first));
    EXPECT_EQ(asked.sites, std::ssize(sites));
    EXPECT_EQ(asked.parts, parts);
    std::vector<Site> others = sites;
    others.front().x += 1.0;
    distributed::DiskOptions second = options();
    second.pieces.belong = [&](const WholeCounts& counts) {
        EXPECT_NE(counts.checksum, asked.checksum);
        throw std::invalid_argument("other sites");
    };
    EXPECT_THROW(static_cast<void>(built(others, 3, Metric::power, second)), std::invalid_argument);
    EXPECT_EQ(built(sites, 4, Metric::power, options()).counts.settled, 0U);
    EXPECT_EQ(found.whole, 2 * parts);
}

}  // namespace
}  // namespace signum
