#pragma once
/// The configurations of a block: which patterns, moved how, in which shares.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "ledger.hpp"

namespace signum::fuzz {

/// How often what makes numbers long is taken: once in so many configurations.
struct Shares {
    std::int64_t raw;   ///< any finite bit patterns
    std::int64_t far;   ///< exponents at the ends of the doubles' range, all alike
    std::int64_t tiny;  ///< one number that is nothing beside the others
    /// Two that touch but for such a number, of which only the cheap predicates are asked; 0 where
    /// there is no need of it.
    std::int64_t brief = 0;
    bool extreme = false;  ///< all are hard::Moves::extremes, and nothing else
};

/// Of what is left seven eighths are patterns, of which three quarters are moved by 0 to 4 ulps in
/// one to three numbers and one quarter are not; one eighth have any significands and exponents at
/// most 60 apart.
template <std::size_t d>
class Mix {
 public:
    Mix(std::uint64_t seed, const Shares& shares) : moves_(seed), shares_(shares) {}

    void make(Kind kind, Configuration<d>& into) {
        into.kind = kind;
        auto& balls = into.balls;
        if (shares_.extreme) return moves_.extremes(kind, balls);
        into.is_brief = shares_.brief != 0 && moves_.once_in(shares_.brief);
        if (into.is_brief) {
            moves_.lattice(kind, balls);
            std::array<Ball<d>, 2> pair;
            moves_.nest(kind, pair);
            balls.front() = pair[0];
            balls.back() = pair[1];
            balls.front().centre[0] = tiny();
            return moves_.scale(kind, balls, static_cast<int>(moves_.integer(-60, 60)));
        }
        if (moves_.once_in(shares_.raw)) return moves_.raw(kind, balls);
        if (moves_.once_in(8)) {
            moves_.raw(kind, balls, static_cast<int>(moves_.integer(0, 60)));
            if (moves_.once_in(2)) moves_.copy(balls);
            if (moves_.once_in(2)) moves_.put_on_circle_of_three(balls);
        } else {
            moves_.any_pattern(kind, balls);
            for (std::size_t m = balls.size() - 1; m > 0; --m)
                std::swap(balls[m], balls[static_cast<std::size_t>(
                                        moves_.integer(0, static_cast<std::int64_t>(m)))]);
            if (!moves_.once_in(4))
                moves_.move_by_ulps(kind, balls, static_cast<int>(moves_.integer(1, 3)), 4);
            if (moves_.once_in(shares_.tiny)) {
                auto& ball = balls[static_cast<std::size_t>(moves_.integer(0, d))];
                ball.centre[static_cast<std::size_t>(moves_.integer(0, d - 1))] = tiny();
            }
        }
        if (moves_.once_in(shares_.far)) {
            const auto exponent = static_cast<int>(moves_.integer(320, 440));
            moves_.scale(kind, balls, moves_.once_in(2) ? -exponent : exponent);
        } else if (moves_.once_in(4)) {
            moves_.scale(kind, balls, static_cast<int>(moves_.integer(-60, 60)));
        }
    }

 private:
    [[nodiscard]] double tiny() {
        return std::ldexp(static_cast<double>(moves_.integer(-1000, 1000)), -460);
    }

    hard::Moves<d> moves_;
    Shares shares_;
};

}  // namespace signum::fuzz
