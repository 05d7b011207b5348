/// The power metric of the plane and of space.

#include <algorithm>
#include <array>
#include <utility>

#include "../../predicates/power.hpp"
#include "../../predicates/power/edge.hpp"
#include "../../predicates/space.hpp"
#include "../../predicates/space/ties.hpp"
#include "ledger.hpp"
#include "power_oracle.hpp"
#include "sites.hpp"

namespace signum::fuzz {
namespace {

template <class Site>
void ask_plane(const Configuration<2>& given, Ledger& ledger) {
    const Scaled<2, 4> scaled(given.kind, given.balls);
    std::array<std::size_t, 4> at = {0, 1, 2, 3};
    const auto site = [&](std::size_t m) { return site_of<Site>(given.balls[at[m]]); };

    int turn = power_oracle::turn<2>(chosen<2, 4>(scaled, at));
    ledger.note(Predicate::ccw, ccw_decision(site(0), site(1), site(2)), turn);
    if (turn < 0) std::swap(at[1], at[2]);
    if (turn != 0) {
        const power_oracle::Question<2> question(given.kind, chosen<2, 4>(scaled, at));
        const int right = question.sign();
        const Decision said = power::in_circle_decision(site(0), site(1), site(2), site(3));
        ledger.note(Predicate::in_circle, said, right);
        if (right == 0) {
            const auto places = ranks<2, 4>(given, at);
            const std::array<Point, 4> p = {power::centre(site(0)), power::centre(site(1)),
                                            power::centre(site(2)), power::centre(site(3))};
            ledger.note(Predicate::in_circle_perturbed,
                        {power::in_circle_tie(p[0], p[1], p[2], p[3], places), said.stage},
                        question.sign_of_tie(places), true);
        }
    } else if (given.balls[0].centre != given.balls[1].centre) {
        const std::array<std::size_t, 3> three = {0, 1, 2};
        const int right = power_oracle::in_segment(given.kind, chosen<2, 3>(scaled, three));
        const Decision said = power::in_segment_decision(site(0), site(1), site(2));
        ledger.note(Predicate::infinite, said, right);
        if (right == 0) {
            const auto places = ranks<2, 3>(given, three);
            ledger.note(Predicate::infinite_perturbed,
                        {power::in_segment_tie(power::centre(site(0)), power::centre(site(1)),
                                               power::centre(site(2)), places),
                         said.stage},
                        power_oracle::in_segment_tie(chosen<2, 3>(scaled, three), places), true);
        }
    }
    const std::array<std::size_t, 3> last = {3, 0, 1};
    ledger.note(
        Predicate::nearer,
        power::nearer_decision(power::centre(site_of<Site>(given.balls[3])),
                               site_of<Site>(given.balls[0]), site_of<Site>(given.balls[1])),
        power_oracle::nearer<2>(given.kind, chosen<2, 3>(scaled, last)));
}

template <class Site>
void ask_space(const Configuration<3>& given, Ledger& ledger) {
    const Scaled<3, 5> scaled(given.kind, given.balls);
    std::array<std::size_t, 5> at = {0, 1, 2, 3, 4};
    const auto site = [&](std::size_t m) { return site_of<Site>(given.balls[at[m]]); };
    const auto centre = [](const Site& s) -> Point3 { return {s.x, s.y, s.z}; };

    const int turn = power_oracle::turn<3>(chosen<3, 5>(scaled, at));
    ledger.note(Predicate::ccw,
                ccw_decision(centre(site(0)), centre(site(1)), centre(site(2)), centre(site(3))),
                turn);
    if (turn < 0) std::swap(at[1], at[2]);
    if (turn != 0) {
        const power_oracle::Question<3> question(given.kind, chosen<3, 5>(scaled, at));
        const int right = question.sign();
        const std::array<Site, 5> sites = {site(0), site(1), site(2), site(3), site(4)};
        const Decision said =
            power::in_sphere_decision(sites[0], sites[1], sites[2], sites[3], sites[4]);
        ledger.note(Predicate::in_circle, said, right);
        if (right == 0) {
            const auto places = ranks<3, 5>(given, at);
            ledger.note(Predicate::in_circle_perturbed,
                        {power::in_sphere_tie(
                             sites, {places[0], places[1], places[2], places[3], places[4]}),
                         said.stage},
                        question.sign_of_tie(places), true);
        }
    }
    const std::array<std::size_t, 3> last = {4, 0, 1};
    ledger.note(
        Predicate::nearer,
        power::nearer_decision(centre(site_of<Site>(given.balls[4])), site_of<Site>(given.balls[0]),
                               site_of<Site>(given.balls[1])),
        power_oracle::nearer<3>(given.kind, chosen<3, 3>(scaled, last)));
}

}  // namespace

void ask_power(const Configuration<2>& configuration, Ledger& ledger) {
    if (configuration.kind == Kind::points) return ask_plane<Point>(configuration, ledger);
    if (configuration.kind == Kind::weights) return ask_plane<power::Site>(configuration, ledger);
    ask_plane<Site>(configuration, ledger);
}
void ask_power(const Configuration<3>& configuration, Ledger& ledger) {
    if (configuration.kind == Kind::points) return ask_space<Point3>(configuration, ledger);
    if (configuration.kind == Kind::weights) return ask_space<power::Site3>(configuration, ledger);
    ask_space<Site3>(configuration, ledger);
}

}  // namespace signum::fuzz
