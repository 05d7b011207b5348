/// The supremum and the Manhattan metric of the plane.

#include <array>
#include <cstddef>
#include <cstdint>

#include "../../predicates/manhattan.hpp"
#include "../../predicates/supremum.hpp"
#include "narrow.hpp"
#include "rectangular_oracle.hpp"
#include "sites.hpp"

namespace signum::fuzz {
namespace {

using namespace rectangular_oracle;

/// Radii under the tie rule are less by an infinitesimal each. Sums hold fewer than 2^8 of any, so
/// that these are as good: the last site's 2^30 units, those before 2^20, 2^10 and 1, of which
/// `shift` bits make the unit of all numbers.
constexpr int shift = 40;

/// The questions about one configuration in numbers of one type.
template <class Metric, class Number>
class Questions {
 public:
    using Predicates = rectangular::Perturbed<Metric>;
    using Four = std::array<Square<Number>, 4>;

    Questions(const Configuration<2>& given, int unit, Ledger& ledger)
        : given_(given), ledger_(ledger), all_(squares(given, unit, 0)) {
        const auto places = ranks<2, 4>(given, std::array<std::size_t, 4>{0, 1, 2, 3});
        ranks_ = places;
        shrunken_ = squares(given, unit, shift);
        for (std::size_t m = 0; m < 4; ++m)
            shrunken_[m].r -= Number(std::int64_t{1} << 10 * places[m]);
    }

    void ask() {
        ask_hides();
        ask_nearer();
        ask_circle({0, 1, 2, 3});
        ask_circle({0, 2, 1, 3});
        ask_infinite();
    }

 private:
    [[nodiscard]] static Four squares(const Configuration<2>& given, int unit, int extra) {
        Four result;
        for (std::size_t m = 0; m < 4; ++m) {
            const auto number = [&](double value) {
                return number_of<Number>(digits_of(value), unit, extra);
            };
            const Number x = number(given.balls[m].centre[0]);
            const Number y = number(given.balls[m].centre[1]);
            if constexpr (std::is_same_v<Metric, rectangular::Supremum>)
                result[m] = {x, y, number(given.balls[m].size)};
            else
                result[m] = {x + y, y - x, number(given.balls[m].size)};
        }
        return result;
    }
    [[nodiscard]] Site site(std::size_t m) const { return site_of<Site>(given_.balls[m]); }
    template <std::size_t n>
    [[nodiscard]] std::array<std::int32_t, n> places(const std::array<std::size_t, n>& at) const {
        std::array<std::int32_t, n> result;
        for (std::size_t m = 0; m < n; ++m) result[m] = ranks_[at[m]];
        return result;
    }

    void ask_hides() {
        const int right = covers(shrunken_[0], shrunken_[3]) ? 1 : -1;
        const bool tied = (right > 0) != covers(all_[0], all_[3]);
        ledger_.note(Predicate::hides, Predicates::hides(site(0), site(3), places<2>({0, 3})),
                     right, tied);
    }
    void ask_nearer() {
        const int sign = rectangular_oracle::nearer(all_[3], all_[0], all_[1]);
        const auto order = places<2>({0, 1});
        const Point p = {given_.balls[3].centre[0], given_.balls[3].centre[1]};
        ledger_.note(Predicate::nearer, Predicates::nearer(p, site(0), site(1), order),
                     sign != 0 ? sign : (order[0] < order[1] ? 1 : -1), sign == 0);
    }
    void ask_circle(const std::array<std::size_t, 4>& at) {
        Four exact;
        Four shrunk;
        for (std::size_t m = 0; m < 4; ++m) {
            exact[m] = all_[at[m]];
            shrunk[m] = shrunken_[at[m]];
        }
        const Touching found = touching(shrunk);
        const bool exists = found.open < 4;
        const Site i = site(at[0]), j = site(at[1]), k = site(at[2]), q = site(at[3]);
        ledger_.note(Predicate::exists,
                     Predicates::exists(i, j, k, places<3>({at[0], at[1], at[2]})),
                     exists ? 1 : -1);
        if (!exists) return;
        const int right = -sign_of(gap(inscribed(exact, found), exact[3]));
        ledger_.note(Predicate::in_circle,
                     rectangular::in_circle_decision<Metric>(i, j, k, q, places<4>(at)), right);
        if (right != 0 && !asks_all_) return;
        ledger_.note(Predicate::in_circle_perturbed,
                     Predicates::in_circle(i, j, k, q, places<4>(at)),
                     -sign_of(gap(inscribed(shrunk, found), shrunk[3])), right == 0);
    }
    void ask_infinite() {
        const std::size_t side = quadrant(shrunken_[0], shrunken_[1]);
        if (side == 4) return;
        const auto order = places<3>({0, 1, 2});
        const int right = reaches(all_[0], all_[1], all_[2], side);
        ledger_.note(
            Predicate::infinite,
            rectangular::in_circle_infinite_decision<Metric>(site(0), site(1), site(2), order),
            right);
        if (right != 0 && !asks_all_) return;
        ledger_.note(Predicate::infinite_perturbed,
                     Predicates::in_circle_infinite(site(0), site(1), site(2), order),
                     reaches(shrunken_[0], shrunken_[1], shrunken_[2], side), right == 0);
    }

    const Configuration<2>& given_;
    Ledger& ledger_;
    Four all_;
    Four shrunken_;
    std::array<std::int32_t, 4> ranks_;
    bool asks_all_ = ledger_.calls() % 16 == 0;
};

template <class Metric>
void ask_plane_of(const Configuration<2>& given, Ledger& ledger) {
    const Units units = units_of(given.balls);
    if (units.span + shift <= narrow_bits)
        Questions<Metric, Narrow>(given, units.lowest, ledger).ask();
    else
        Questions<Metric, Integer>(given, units.lowest, ledger).ask();
}

}  // namespace

void ask_supremum(const Configuration<2>& configuration, Ledger& ledger) {
    ask_plane_of<rectangular::Supremum>(configuration, ledger);
}
void ask_manhattan(const Configuration<2>& configuration, Ledger& ledger) {
    ask_plane_of<rectangular::Manhattan>(configuration, ledger);
}

}  // namespace signum::fuzz
