#pragma once
/// Spheres, by the cells in which their centres lie, to be looked through four at a time.

#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "../core/large_array.hpp"
#include "ball.hpp"

namespace signum::motion {

/// How far into its cell a sphere's centre lies, and its radius, which may be infinite, in units of
/// about a cell's width. They are floats: whoever asks allows for their rounding.
template <int D>
struct Shell {
    PerAxis<float, D> into{};
    float reach = 0.0F;
    Slot ball = 0;
};

/// A list for each cell: a chunk of four places, and further ones where these do not suffice.
template <int D>
class ShellLists {
 public:
    explicit ShellLists(std::size_t lists) : chunks_(lists), next_(lists, none), lists_(lists) {}

    [[nodiscard]] std::size_t size() const noexcept { return lists_; }

    void insert(std::uint32_t list, const Shell<D>& shell) {
        std::uint32_t c = list;
        std::size_t lane = find(c, none);
        while (lane == lanes && next_[c] != none) lane = find(c = next_[c], none);
        if (lane == lanes) {
            c = next_[c] = new_chunk();
            lane = 0;
        }
        for (int k = 0; k < D; ++k) chunks_[c].into[k][lane] = shell.into[k];
        chunks_[c].reach[lane] = shell.reach;
        chunks_[c].ball[lane] = shell.ball;
    }
    /// Precondition: it is there.
    void remove(std::uint32_t list, Slot ball) noexcept {
        std::uint32_t before = none;
        std::uint32_t c = list;
        std::size_t lane = find(c, ball);
        while (lane == lanes) {
            before = c;
            c = next_[c];
            lane = find(c, ball);
        }
        chunks_[c].ball[lane] = none;
        chunks_[c].into[0][lane] = far_off;
        if (before == none || chunks_[c].ball != Chunk{}.ball) return;
        next_[before] = next_[c];
        next_[c] = std::exchange(free_, c);
    }
    /// Appends to the first `size` of `balls` those of a list whose spheres overlap with one that
    /// lies, seen from the list's cell, where told.
    [[gnu::always_inline]] void find_overlapping(std::uint32_t list, const Shell<D>& shell,
                                                 std::vector<Slot>& balls,
                                                 std::size_t& size) const {
        for (std::uint32_t c = list; c != none; c = next_[c]) {
            const Chunk& chunk = chunks_[c];
            if (balls.size() < size + lanes) [[unlikely]]
                balls.resize(2 * size + 16 * lanes);
            Floats square{};
            for (int k = 0; k < D; ++k) {
                const Floats d = shell.into[k] - chunk.into[k];
                square += d * d;
            }
            const Floats reach = shell.reach + chunk.reach;
            const auto beyond = square >= reach * reach;
            // Written, and perhaps forgotten: whether it is near is anybody's guess.
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                balls[size] = chunk.ball[lane];
                size += static_cast<std::size_t>(beyond[lane] + 1);
            }
        }
    }

 private:
    static constexpr std::size_t lanes = 4;
    static constexpr Slot none = ~Slot{0};
    static constexpr float far_off = std::numeric_limits<float>::infinity();
    using Floats = float __attribute__((vector_size(lanes * sizeof(float))));

    struct Chunk {
        Floats into[D] = {Floats{} + far_off};  // of a place that is empty, far off on one axis
        Floats reach{};
        std::array<Slot, lanes> ball = {none, none, none, none};
    };

    [[nodiscard]] std::size_t find(std::uint32_t chunk, Slot ball) const noexcept {
        std::size_t lane = 0;
        while (lane < lanes && chunks_[chunk].ball[lane] != ball) ++lane;
        return lane;
    }
    [[nodiscard]] std::uint32_t new_chunk() {
        if (free_ == none) {
            chunks_.emplace_back();
            next_.push_back(none);
            return static_cast<std::uint32_t>(chunks_.size() - 1);
        }
        return std::exchange(free_, std::exchange(next_[free_], none));
    }

    LargeArray<Chunk, Pages::large> chunks_;
    LargeArray<std::uint32_t, Pages::large> next_;
    std::size_t lists_;
    std::uint32_t free_ = none;
};

}  // namespace signum::motion
