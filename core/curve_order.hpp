#pragma once
/// Items along a Hilbert curve through their places, in the plane and in space: an order in which
/// what follows one another is near. For sources only.

#include <algorithm>
#include <array>
#include <boost/sort/spreadsort/integer_sort.hpp>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace signum {

/// A range of one coordinate, halved so that its extent cannot overflow.
class AxisRange {
 public:
    void include(double value) noexcept {
        least_ = std::min(least_, 0.5 * value);
        greatest_ = std::max(greatest_, 0.5 * value);
    }
    [[nodiscard]] bool is_point() const noexcept { return !(greatest_ > least_); }
    /// The cell of a value among 2^bits.
    [[nodiscard]] std::uint32_t cell(double value, int bits) const noexcept {
        if (is_point()) return 0;
        const auto cells = static_cast<double>(std::uint32_t{1} << bits);
        const double place = (0.5 * value - least_) / (greatest_ - least_) * cells;
        return static_cast<std::uint32_t>(std::min(place, cells - 1.0));
    }

 private:
    double least_ = 0x1p1023;
    double greatest_ = -0x1p1023;
};

/// The curve as an automaton, some bits of each coordinate a step.
///
/// A state is how the curve lies in a cell: which axis stands for which, which of them are
/// mirrored, and whether it is run through from its end. Source of the rules from bit to bit:
/// Skilling, Programming the Hilbert curve, AIP Conference Proceedings 707, 2004.
template <std::size_t D>
class HilbertCurve {
 public:
    static constexpr int bits_per_step = D == 2 ? 4 : 2;

    /// The place on the curve of a cell of a cube of 2^bits a side. Precondition: bits is a
    /// multiple of bits_per_step.
    [[nodiscard]] static std::uint64_t place(const std::array<std::uint32_t, D>& cell,
                                             int bits) noexcept {
        std::uint64_t curve = 0;
        std::size_t state = 0;
        for (int shift = bits - bits_per_step; shift >= 0; shift -= bits_per_step) {
            std::size_t digits = 0;
            for (const std::uint32_t axis : cell)
                digits = digits << bits_per_step | (axis >> shift & ((1U << bits_per_step) - 1));
            const Step step = steps[state][digits];
            curve = curve << bits_per_step * D | step.curve;
            state = step.state;
        }
        return curve;
    }

 private:
    struct State {
        std::array<unsigned, D> axis;
        std::array<unsigned, D> is_mirrored;
        unsigned is_reversed;
        bool operator==(const State&) const = default;
    };
    struct Step {
        std::uint8_t curve;
        std::uint8_t state;
    };
    static constexpr std::size_t states = D == 2 ? 8 : 48;
    template <int bits>
    using Steps = std::array<std::array<Step, std::size_t{1} << D * bits>, states>;

    /// One bit of each coordinate, those of the first one highest; returns the part of the curve.
    static constexpr unsigned enter(State& state, std::size_t bits) {
        std::array<unsigned, D> at{};
        for (std::size_t k = 0; k < D; ++k)
            at[k] = (bits >> (D - 1 - state.axis[k]) & 1) ^ state.is_mirrored[k];
        unsigned part = 0;
        unsigned gray = 0;
        for (std::size_t k = 0; k < D; ++k) {
            gray ^= at[k];
            part = part << 1 | (gray ^ state.is_reversed);
            if (at[k] != 0) {
                state.is_mirrored[0] ^= 1;
            } else {
                std::swap(state.axis[0], state.axis[k]);
                std::swap(state.is_mirrored[0], state.is_mirrored[k]);
            }
        }
        state.is_reversed ^= gray;
        return part;
    }
    static constexpr Steps<1> steps_of_one_bit() {
        std::array<State, states> known{};
        for (std::size_t k = 0; k < D; ++k) known[0].axis[k] = static_cast<unsigned>(k);
        std::size_t count = 1;
        Steps<1> result{};
        for (std::size_t number = 0; number < states; ++number)
            for (std::size_t bits = 0; bits < result[number].size(); ++bits) {
                State state = known[number];
                const unsigned part = enter(state, bits);
                std::size_t next = 0;
                while (next < count && known[next] != state) ++next;
                if (next == count) known[count++] = state;
                result[number][bits] = {static_cast<std::uint8_t>(part),
                                        static_cast<std::uint8_t>(next)};
            }
        return result;
    }
    static constexpr Steps<bits_per_step> make_steps() {
        const Steps<1> of_one_bit = steps_of_one_bit();
        Steps<bits_per_step> result{};
        for (std::size_t number = 0; number < states; ++number)
            for (std::size_t digits = 0; digits < result[number].size(); ++digits) {
                Step all{0, static_cast<std::uint8_t>(number)};
                for (int bit = bits_per_step - 1; bit >= 0; --bit) {
                    std::size_t bits = 0;
                    for (std::size_t k = D; k-- > 0;)
                        bits = bits << 1 | (digits >> (k * bits_per_step + bit) & 1);
                    const Step one = of_one_bit[all.state][bits];
                    all = {static_cast<std::uint8_t>(all.curve << D | one.curve), one.state};
                }
                result[number][digits] = all;
            }
        return result;
    }
    static constexpr Steps<bits_per_step> steps = make_steps();
};

/// What is sorted, in one number from high bits to low: what comes before all else, a place on the
/// curve and an item.
struct CurveKeys {
    int item_bits;
    int axis_bits;

    [[nodiscard]] std::size_t item(std::uint64_t key) const noexcept {
        return key & ((std::uint64_t{1} << item_bits) - 1);
    }
};

/// Sorts keys, whose places on the curve are 0, by those over the items' own bounding box; where a
/// cell holds many, these on a scale of their own. place(item): an array of D numbers.
template <std::size_t D, class Place>
void sort_along_curve(std::span<std::uint64_t> keys, const CurveKeys& layout, const Place& place) {
    std::array<AxisRange, D> ranges;
    for (const std::uint64_t key : keys) {
        const std::array<double, D> p = place(layout.item(key));
        for (std::size_t k = 0; k < D; ++k) ranges[k].include(p[k]);
    }
    if (std::ranges::all_of(ranges, &AxisRange::is_point)) return;
    for (std::uint64_t& key : keys) {
        const std::array<double, D> p = place(layout.item(key));
        std::array<std::uint32_t, D> cell;
        for (std::size_t k = 0; k < D; ++k) cell[k] = ranges[k].cell(p[k], layout.axis_bits);
        key |= HilbertCurve<D>::place(cell, layout.axis_bits) << layout.item_bits;
    }
    boost::sort::spreadsort::integer_sort(keys.begin(), keys.end());

    constexpr std::size_t crowd = 64;
    for (std::size_t first = 0; first < keys.size();) {
        std::size_t last = first + 1;
        while (last < keys.size() &&
               keys[last] >> layout.item_bits == keys[first] >> layout.item_bits)
            ++last;
        // The corners of a bounding box lie in different cells, so that a cell holds fewer.
        if (last - first > crowd && last - first < keys.size()) {
            const std::span<std::uint64_t> cell = keys.subspan(first, last - first);
            for (std::uint64_t& key : cell) key = layout.item(key);
            sort_along_curve<D>(cell, layout, place);
        }
        first = last;
    }
}

}  // namespace signum
