/// The Euclidean metric with additive weights, of the plane and of space.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "../../predicates/euclidean.hpp"
#include "../../predicates/space.hpp"
#include "euclidean_oracle.hpp"
#include "sites.hpp"

namespace signum::fuzz {
namespace {

using euclidean_oracle::Cover;
using euclidean_oracle::Sphere;

/// The sites with radii that are really smaller, as the tie rule thinks of them: that of the last
/// by 2^-scale units; with `two` that of the one before by the eighth power of that. Ties are
/// decided at first order, so that what the others lose makes no difference.
template <std::size_t n>
[[nodiscard]] std::array<Exact<2>, n> shrunken(const std::array<const Exact<2>*, n>& sites,
                                               const std::array<std::int32_t, n>& ranks,
                                               std::uint64_t scale, bool two) {
    const std::uint64_t shift = two ? 8 * scale : scale;
    std::array<Exact<2>, n> result;
    for (std::size_t m = 0; m < n; ++m) {
        for (std::size_t k = 0; k < 2; ++k) result[m].centre[k] = sites[m]->centre[k] << shift;
        result[m].size = sites[m]->size << shift;
        if (ranks[m] == static_cast<std::int32_t>(n) - 1)
            result[m].size -= Integer(1, shift - scale);
        if (two && ranks[m] == static_cast<std::int32_t>(n) - 2) result[m].size -= Integer(1);
    }
    return result;
}
/// The answer of `question`, of which 0 is none, about the shrunken sites; 0 where numbers are too
/// long to ask, or where the first two do not decide. A question is the sign of a polynomial of
/// degree 16 at most, once roots are squared away, so that 2^-scale is as good as infinitesimal.
template <std::size_t n, class Question>
[[nodiscard]] int ask_shrunken(int span, const std::array<const Exact<2>*, n>& sites,
                               const std::array<std::int32_t, n>& ranks, Question question) {
    if (span > 200) return 0;
    const auto scale = static_cast<std::uint64_t>(16 * (span + 2) + 64);
    for (const bool two : {false, true}) {
        if (two && span > 64) return 0;
        const std::array<Exact<2>, n> shrunk = shrunken(sites, ranks, scale, two);
        std::array<const Exact<2>*, n> places;
        for (std::size_t m = 0; m < n; ++m) places[m] = &shrunk[m];
        if (const int sign = question(places); sign != 0) return sign;
    }
    return 0;
}

constexpr auto exists_strictly = [](const auto& sites) {
    const Sphere<2> sphere(std::array{sites[0], sites[1], sites[2]});
    return sphere.is_degenerate() ? 0 : (sphere.exists() ? 1 : -1);
};
constexpr auto conflicts_strictly = [](const auto& sites) {
    const Sphere<2> sphere(std::array{sites[0], sites[1], sites[2]});
    return sphere.is_degenerate() || !sphere.exists() ? 0 : sphere.conflict(*sites[3]);
};
constexpr auto reaches_strictly = [](const auto& sites) {
    if (euclidean_oracle::cover(*sites[0], *sites[2]) != Cover::none ||
        euclidean_oracle::cover(*sites[1], *sites[2]) != Cover::none)
        return -1;
    return euclidean_oracle::across_line(*sites[0], *sites[1], *sites[2]);
};

/// The questions about one configuration of the plane.
class Plane {
 public:
    using Predicates = euclidean::Perturbed<>;

    Plane(const Configuration<2>& given, Ledger& ledger)
        : given_(given),
          ledger_(ledger),
          scaled_(given.kind, given.balls),
          // Infinitesimals take long.
          asks_ties_(ledger.calls() % 8 < 2) {}

    void ask() {
        ask_hides();
        ask_nearer();
        if (given_.is_brief) return;
        ask_circle({0, 1, 2, 3});
        ask_circle({0, 2, 1, 3});
        ask_infinite();
    }

 private:
    [[nodiscard]] Site site(std::size_t m) const { return site_of<Site>(given_.balls[m]); }
    [[nodiscard]] const Exact<2>& exact(std::size_t m) const { return scaled_.balls[m]; }

    void ask_hides() {
        const std::array<std::size_t, 2> at = {0, 3};
        const auto places = ranks<2, 2>(given_, at);
        const Cover cover = euclidean_oracle::cover(exact(0), exact(3));
        const bool touches = cover == Cover::touches;
        const int right = cover == Cover::none || (touches && places[0] > places[1]) ? -1 : 1;
        ledger_.note(Predicate::hides, Predicates::hides(site(0), site(3), places), right, touches);
    }
    void ask_nearer() {
        const std::array<std::size_t, 2> at = {0, 1};
        const auto places = ranks<2, 2>(given_, at);
        const int sign = euclidean_oracle::nearer(exact(3), exact(0), exact(1));
        const int right = sign != 0 ? sign : (places[0] < places[1] ? 1 : -1);
        const Point p = {given_.balls[3].centre[0], given_.balls[3].centre[1]};
        ledger_.note(Predicate::nearer, Predicates::nearer(p, site(0), site(1), places), right,
                     sign == 0);
    }
    /// Whether a circle touches the first three, and whether the last conflicts with it.
    void ask_circle(const std::array<std::size_t, 4>& at) {
        const auto sites = chosen<2, 4>(scaled_, at);
        const std::array<std::size_t, 3> three = {at[0], at[1], at[2]};
        const auto three_sites = chosen<2, 3>(scaled_, three);
        const auto three_places = ranks<2, 3>(given_, three);
        const auto places = ranks<2, 4>(given_, at);
        const Sphere<2> circle(three_sites);
        bool exists = circle.exists();
        if (circle.is_degenerate()) {
            if (!asks_ties_) return;
            const int right =
                ask_shrunken(scaled_.span, three_sites, three_places, exists_strictly);
            if (right == 0) return;
            exists = right > 0;
        }
        const Site i = site(at[0]), j = site(at[1]), k = site(at[2]), q = site(at[3]);
        ledger_.note(Predicate::exists, Predicates::exists(i, j, k, three_places), exists ? 1 : -1,
                     circle.is_degenerate());
        if (!exists) return;
        bool hidden = false;
        for (std::size_t m = 0; m < 3; ++m)
            hidden |= euclidean_oracle::cover(*sites[m], *sites[3]) != Cover::none;
        int right = 0;
        if (!circle.is_degenerate() && !hidden) {
            right = circle.conflict(*sites[3]);
            ledger_.note(Predicate::in_circle, euclidean::in_circle_decision(i, j, k, q, places),
                         right);
        }
        if (right != 0 || !asks_ties_) return;
        right = ask_shrunken(scaled_.span, sites, places, conflicts_strictly);
        if (right != 0)
            ledger_.note(Predicate::in_circle_perturbed, Predicates::in_circle(i, j, k, q, places),
                         right, true);
    }
    void ask_infinite() {
        const std::array<std::size_t, 3> at = {0, 1, 2};
        const auto sites = chosen<2, 3>(scaled_, at);
        if (euclidean_oracle::cover(*sites[0], *sites[1]) != Cover::none ||
            euclidean_oracle::cover(*sites[1], *sites[0]) != Cover::none)
            return;
        int right = euclidean_oracle::across_line(*sites[0], *sites[1], *sites[2]);
        ledger_.note(Predicate::infinite,
                     euclidean::in_circle_infinite_decision(site(0), site(1), site(2)), right);
        if (right != 0 || !asks_ties_) return;
        const auto places = ranks<2, 3>(given_, at);
        right = ask_shrunken(scaled_.span, sites, places, reaches_strictly);
        if (right != 0)
            ledger_.note(Predicate::infinite_perturbed,
                         Predicates::in_circle_infinite(site(0), site(1), site(2), places), right,
                         true);
    }

    const Configuration<2>& given_;
    Ledger& ledger_;
    Scaled<2, 4> scaled_;
    bool asks_ties_;
};

}  // namespace

void ask_euclidean(const Configuration<2>& configuration, Ledger& ledger) {
    Plane(configuration, ledger).ask();
}

void ask_euclidean(const Configuration<3>& configuration, Ledger& ledger) {
    const Scaled<3, 5> scaled(configuration.kind, configuration.balls);
    const auto site = [&](std::size_t m) { return site_of<Site3>(configuration.balls[m]); };
    const Cover cover = euclidean_oracle::cover(scaled.balls[0], scaled.balls[4]);
    ledger.note(Predicate::hides, euclidean::hides_decision(site(0), site(4)),
                cover == Cover::none ? -1 : 1, cover == Cover::touches);
    if (configuration.is_brief) return;
    for (const bool turned : {false, true}) {
        const std::size_t j = turned ? 2 : 1;
        const std::array<std::size_t, 4> at = {0, j, 3 - j, 3};
        const Sphere<3> sphere(chosen<3, 4>(scaled, at));
        ledger.note(Predicate::exists,
                    euclidean::exists_decision(site(0), site(j), site(3 - j), site(3)),
                    sphere.exists() ? 1 : -1, sphere.is_degenerate());
        if (sphere.exists())
            ledger.note(
                Predicate::in_circle,
                euclidean::in_sphere_decision(site(0), site(j), site(3 - j), site(3), site(4)),
                sphere.conflict(scaled.balls[4]));
    }
}

}  // namespace signum::fuzz
