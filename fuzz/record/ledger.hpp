#pragma once
/// What a block of calls is asked about, and the count of what was answered.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "../../filters/tally.hpp"
#include "scaled.hpp"

namespace signum::fuzz {

/// The sites of a few calls: each predicate takes as many of them as it needs.
template <std::size_t d>
struct Configuration {
    Kind kind = Kind::points;
    std::array<Ball<d>, d + 2> balls;
    bool is_brief = false;  ///< asked for what is cheap alone
};

enum class Predicate : std::uint8_t {
    ccw,
    exists,               ///< of cubes and octahedra in space: how many, in their order
    in_circle,            ///< in space in_sphere
    in_circle_perturbed,  ///< where in_circle is 0; its stage is that of the 0
    infinite,             ///< in_circle_infinite; of the power metric in_segment
    infinite_perturbed,
    hides,
    nearer,
    meeting  ///< of two balls: that the time is right
};
inline constexpr std::size_t predicate_count = 9;

[[nodiscard]] constexpr std::string_view name_of(Predicate predicate, std::size_t dimension) {
    constexpr std::array<std::string_view, predicate_count> names = {
        "ccw",   "exists", "in_circle", "in_circle_perturbed", "infinite", "infinite_perturbed",
        "hides", "nearer", "meeting"};
    if (dimension == 3 && predicate == Predicate::in_circle) return "in_sphere";
    if (dimension == 3 && predicate == Predicate::in_circle_perturbed) return "in_sphere_perturbed";
    return names[static_cast<std::size_t>(predicate)];
}

struct Count {
    std::uint64_t calls = 0;
    std::array<std::uint64_t, stage_count> stages = {};
    std::uint64_t ties = 0;  ///< the right sign is 0, or the tie rule's
    std::uint64_t wrong = 0;
};

class Ledger {
 public:
    /// One call: what the library said, and what is right.
    void note(Predicate predicate, const Decision& said, int right, bool tied = false) {
        Count& count = counts_[static_cast<std::size_t>(predicate)];
        ++count.calls;
        ++count.stages[static_cast<std::size_t>(said.stage)];
        count.ties += static_cast<std::uint64_t>(right == 0 || tied);
        ++calls_;
        if (said.sign == right) return;
        ++count.wrong;
        last_wrong_ = Wrong{predicate, said.sign, right};
        is_wrong_ = true;
    }

    struct Wrong {
        Predicate predicate = Predicate::ccw;
        int said = 0;
        int right = 0;
    };
    /// Whether a call was wrong since this was asked last, and the last such.
    [[nodiscard]] bool take_wrong(Wrong& wrong) {
        wrong = last_wrong_;
        return std::exchange(is_wrong_, false);
    }

    [[nodiscard]] std::uint64_t calls() const { return calls_; }
    [[nodiscard]] const std::array<Count, predicate_count>& counts() const { return counts_; }

 private:
    std::array<Count, predicate_count> counts_;
    std::uint64_t calls_ = 0;
    Wrong last_wrong_;
    bool is_wrong_ = false;
};

/// The places of sites in the tie rule's order: falling size, rising coordinates, index.
template <std::size_t n, std::size_t d>
[[nodiscard]] std::array<std::int32_t, n> ranks_of(Kind kind,
                                                   const std::array<const Ball<d>*, n>& sites) {
    const auto precedes = [&](const Ball<d>& a, const Ball<d>& b) {
        // Squares are in the order of sizes without signs.
        const bool squared = kind == Kind::radii;
        const double a_size = squared ? std::abs(a.size) : a.size;
        const double b_size = squared ? std::abs(b.size) : b.size;
        if (a_size != b_size) return a_size > b_size;
        for (std::size_t k = 0; k < d; ++k)
            if (a.centre[k] != b.centre[k]) return a.centre[k] < b.centre[k];
        return &a <= &b;
    };
    std::array<std::int32_t, n> ranks{};
    for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = 0; b < a; ++b) ++ranks[precedes(*sites[b], *sites[a]) ? a : b];
    return ranks;
}

// One function a metric and a dimension; each asks all predicates that the configuration allows.
void ask_power(const Configuration<2>& configuration, Ledger& ledger);
void ask_power(const Configuration<3>& configuration, Ledger& ledger);
void ask_euclidean(const Configuration<2>& configuration, Ledger& ledger);
void ask_euclidean(const Configuration<3>& configuration, Ledger& ledger);
void ask_supremum(const Configuration<2>& configuration, Ledger& ledger);
void ask_supremum(const Configuration<3>& configuration, Ledger& ledger);
void ask_manhattan(const Configuration<2>& configuration, Ledger& ledger);
void ask_manhattan(const Configuration<3>& configuration, Ledger& ledger);

void ask_meeting(const Configuration<3>& configuration, Ledger& ledger);
/// What it is asked of, in the place of Mix.
void make_meeting(hard::Moves<3>& moves, Configuration<3>& into);

}  // namespace signum::fuzz
