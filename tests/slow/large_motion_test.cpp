/// Moving balls, many and for long: one log, nothing missed, energy kept, and what is known of
/// gases.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../property/motion_oracle.hpp"
#include "../property/motion_scenes.hpp"

namespace signum::motion {
namespace {

const std::uint64_t many_strikes = is_fast ? 1'000'000 : 10'000;

/// A hash of a log (FNV-1a), and of how many strikes.
class Digest {
 public:
    void add(const Strike& strike) {
        for (const std::uint64_t number :
             {std::bit_cast<std::uint64_t>(strike.time), static_cast<std::uint64_t>(strike.wall),
              static_cast<std::uint64_t>(strike.a), static_cast<std::uint64_t>(strike.b),
              std::bit_cast<std::uint64_t>(strike.impulse)})
            hash_ = (hash_ ^ number) * 0x100000001B3;
        ++strikes_;
    }
    friend bool operator==(const Digest&, const Digest&) = default;
    [[nodiscard]] std::uint64_t strikes() const noexcept { return strikes_; }

 private:
    std::uint64_t hash_ = 0xCBF29CE484222325;
    std::uint64_t strikes_ = 0;
};

/// Digests after some numbers of strikes; the last is of the whole log.
template <int D>
std::vector<Digest> digests(const Scene<D>& scene, Structure structure,
                            const std::vector<std::uint64_t>& stops) {
    Simulation<D> simulation(start<D>(scene.bodies, scene.effects), scene.effects, {structure});
    Digest digest;
    std::vector<Digest> result;
    for (const std::uint64_t stop : stops) {
        simulation.run({.strikes = stop - digest.strikes()},
                       [&](const Strike& strike) { digest.add(strike); });
        result.push_back(digest);
        if (digest.strikes() < stop) break;
    }
    return result;
}

/// A structure beside lists; one that takes long over the first part of the log.
class OneLog : public testing::TestWithParam<std::pair<Structure, std::size_t>> {
 protected:
    template <int D>
    static void expect_one_log() {
        const auto [structure, parts] = GetParam();
        const std::vector<std::uint64_t> all = {many_strikes / 500, many_strikes / 50,
                                                many_strikes};
        const std::vector<std::uint64_t> stops(all.begin(),
                                               all.begin() + static_cast<std::ptrdiff_t>(parts));
        for (const Scene<D>& scene : all_scenes<D>(10'000)) {
            SCOPED_TRACE(scene.name);
            EXPECT_EQ(digests(scene, structure, stops), digests(scene, Structure::lists, stops));
        }
    }
};
TEST_P(OneLog, InThePlane) {
    expect_one_log<2>();
}
TEST_P(OneLog, InSpace) {
    expect_one_log<3>();
}
INSTANTIATE_TEST_SUITE_P(LargeMotion, OneLog,
                         testing::Values(std::pair{Structure::pairs, 1},
                                         std::pair{Structure::segments, 2},
                                         std::pair{Structure::cells, 3},
                                         std::pair{Structure::tree, 3},
                                         std::pair{Structure::levels, 3}),
                         [](const auto& info) { return std::string(name_of(info.param.first)); });

TEST(LargeMotion, TenMillionElasticStrikesKeepTheEnergy) {
    const Scene<3> scene = gas<3>(1000, true, 3);
    Simulation<3> simulation(start<3>(scene.bodies, scene.effects), scene.effects);
    const double before = energy(simulation);
    simulation.run({.strikes = 10 * many_strikes});
    EXPECT_NEAR(energy(simulation) / before, 1.0, 1e-12);
}

TEST(LargeMotion, NothingGoesThroughAtAHundredThousandTimes) {
    const int looks = is_fast ? 100'000 : 1000;
    expect_nothing_through(gas<2>(100, true, 21), looks, 0.05);
    expect_nothing_through(gas<3>(125, false, 22), looks, 0.05);
    Scene<2> bouncing = falling<2>(100, 23);
    bouncing.effects.restitution = 1.0;
    expect_nothing_through(bouncing, looks, 0.05);
}

TEST(LargeMotion, TenThousandStrikesAreTheOracles) {
    const std::size_t strikes = is_fast ? 10'000 : 100;
    for (const std::size_t number : {3U, 8U, 30U}) {
        SCOPED_TRACE(number);
        expect_log_of_oracle(gas<2>(number, false, 41), 1e9, strikes);
        Scene<2> bouncing = falling<2>(number, 42);
        bouncing.effects.restitution = 1.0;
        expect_log_of_oracle(bouncing, 1e9, strikes);
    }
    expect_log_of_oracle(gas<3>(8, false, 43), 1e9, strikes);
    // Of all images that come by, the oracle asks every one.
    expect_log_of_oracle(gas<2>(9, true, 44), 100.0, strikes);
}

/// Z from the virial of the strikes, beside what is known (Henderson 1975; Carnahan, Starling
/// 1969).
template <int D>
double compressibility(double packing) {
    Scene<D> scene = gas<D>(10'000, true, 17);
    // The lattice is of width 1, the balls as large as the packing asks for.
    const double of_a_ball = D == 2 ? M_PI : 4.0 / 3.0 * M_PI;
    for (Body<D>& body : scene.bodies)
        body.radius = D == 2 ? std::sqrt(packing / of_a_ball) : std::cbrt(packing / of_a_ball);
    Simulation<D> simulation(start<D>(scene.bodies, scene.effects), scene.effects);
    simulation.run({.strikes = many_strikes});
    const double begin = simulation.state().time;
    const double virial = simulation.counts().virial;
    simulation.run({.strikes = 2 * many_strikes});
    return 1.0 + (simulation.counts().virial - virial) /
                     (2.0 * energy(simulation) * (simulation.state().time - begin));
}

TEST(LargeMotion, GasesHaveTheKnownPressure) {
    for (const double eta : {0.1, 0.3, 0.5}) {
        const double known = (1.0 + eta * eta / 8.0) / ((1.0 - eta) * (1.0 - eta));
        EXPECT_NEAR(compressibility<2>(eta) / known, 1.0, 0.005) << "discs, " << eta;
    }
    for (const double eta : {0.1, 0.25, 0.4}) {
        const double known = (1.0 + eta + eta * eta - eta * eta * eta) / std::pow(1.0 - eta, 3);
        EXPECT_NEAR(compressibility<3>(eta) / known, 1.0, 0.005) << "spheres, " << eta;
    }
}

}  // namespace
}  // namespace signum::motion
