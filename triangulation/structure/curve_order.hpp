#pragma once
/// Items along a Hilbert curve through their places, in the plane and in space: an order in which
/// what follows one another is near. For sources only.

#include <algorithm>
#include <array>
#include <bit>
#include <boost/sort/pdqsort/pdqsort.hpp>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "../../core/large_array.hpp"
#include "../../core/parallel.hpp"
#include "../../exact/floating_environment.hpp"

namespace signum {

/// A range of one coordinate, halved so that its extent cannot overflow.
class AxisRange {
 public:
    void include(double value) noexcept {
        least_ = std::min(least_, 0.5 * value);
        greatest_ = std::max(greatest_, 0.5 * value);
    }
    void include(const AxisRange& other) noexcept {
        least_ = std::min(least_, other.least_);
        greatest_ = std::max(greatest_, other.greatest_);
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
void sort_along_curve(std::span<std::uint64_t> keys, const CurveKeys& layout, const Place& place,
                      const Workers& workers);

/// Sorts keys by `bits` of them, from `shift` on, by counting, into `sorted`, which has room
/// for as many; O(size).
inline void sort_by_digit(std::span<const std::uint64_t> keys, std::span<std::uint64_t> sorted,
                          int shift, int bits, const Workers& workers) {
    const std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
    static_cast<void>(deal(
        workers, keys.size(), std::size_t{1} << bits,
        [&](std::size_t i) { return static_cast<std::size_t>(keys[i] >> shift & mask); },
        [](std::size_t) {}, [&](std::size_t i, std::size_t place) { sorted[place] = keys[i]; }));
}

/// Sorts keys from first to last whose first bits are the same; of no use elsewhere.
template <std::size_t D, class Place>
void sort_cells(std::span<std::uint64_t> keys, const CurveKeys& layout, const Place& place,
                const Workers& workers) {
    constexpr std::size_t few = 24;
    constexpr std::size_t crowd = 64;
    if (keys.size() <= few) {
        for (std::size_t i = 1; i < keys.size(); ++i) {
            const std::uint64_t key = keys[i];
            std::size_t k = i;
            for (; k > 0 && keys[k - 1] > key; --k) keys[k] = keys[k - 1];
            keys[k] = key;
        }
        return;
    }
    boost::sort::pdqsort_branchless(keys.begin(), keys.end());
    const auto cell_of = [&](std::uint64_t key) { return key >> layout.item_bits; };
    for (std::size_t first = 0, last; first < keys.size(); first = last) {
        last = first + 1;
        while (last < keys.size() && cell_of(keys[last]) == cell_of(keys[first])) ++last;
        if (last - first <= crowd) continue;
        const std::span<std::uint64_t> cell = keys.subspan(first, last - first);
        for (std::uint64_t& key : cell) key = layout.item(key);
        sort_along_curve<D>(cell, layout, place, workers);
    }
}

template <std::size_t D, class Place>
void sort_along_curve(std::span<std::uint64_t> keys, const CurveKeys& layout, const Place& place,
                      const Workers& workers) {
    const std::size_t n = keys.size();
    std::array<AxisRange, D> box;
    std::mutex one_at_a_time;
    workers.each_range(n, [&](std::size_t begin, std::size_t end) {
        const exact::IeeeEnvironment environment;
        std::array<AxisRange, D> own;
        for (std::size_t i = begin; i < end; ++i) {
            const std::array<double, D> p = place(layout.item(keys[i]));
            for (std::size_t k = 0; k < D; ++k) own[k].include(p[k]);
        }
        const std::lock_guard lock(one_at_a_time);
        for (std::size_t k = 0; k < D; ++k) box[k].include(own[k]);
    });
    // The corners of the box lie in different cells, so that a crowd is smaller than what it is in.
    if (std::ranges::all_of(box, &AxisRange::is_point)) return;
    workers.each_range(n, [&](std::size_t begin, std::size_t end) {
        const exact::IeeeEnvironment environment;
        for (std::size_t i = begin; i < end; ++i) {
            const std::array<double, D> p = place(layout.item(keys[i]));
            std::array<std::uint32_t, D> cell;
            for (std::size_t k = 0; k < D; ++k) cell[k] = box[k].cell(p[k], layout.axis_bits);
            keys[i] |= HilbertCurve<D>::place(cell, layout.axis_bits) << layout.item_bits;
        }
    });

    // As many of the first bits as part nearly all items, in two digits, the second one first; what
    // these leave together is little, unless the items crowd.
    constexpr std::size_t few = 256;
    if (n < few) return sort_cells<D>(keys, layout, place, workers);
    const int curve_bits = static_cast<int>(D) * layout.axis_bits;
    const int digit = std::min(curve_bits, static_cast<int>(std::bit_width(n))) / 2;
    const int rest = layout.item_bits + curve_bits - 2 * digit;
    {
        LargeArray<std::uint64_t> room(n);
        sort_by_digit(keys, room, rest, digit, workers);
        sort_by_digit(room, keys, rest + digit, digit, workers);
        give_back(workers, room);
    }
    // Ranges end where such ones do; found before any is sorted, for that may change their keys.
    const auto are_together = [&](std::size_t i, std::size_t k) {
        return keys[i] >> rest == keys[k] >> rest;
    };
    std::vector<std::size_t> bounds = {0};
    const std::size_t ranges = workers.range_count(n);
    for (std::size_t range = 1; range < ranges; ++range) {
        std::size_t bound = std::max(bounds.back(), n * range / ranges);
        while (bound > bounds.back() && bound < n && are_together(bound - 1, bound)) ++bound;
        bounds.push_back(bound);
    }
    bounds.push_back(n);
    workers.each(ranges, [&](std::size_t range) {
        for (std::size_t first = bounds[range], last; first < bounds[range + 1]; first = last) {
            last = first + 1;
            while (last < bounds[range + 1] && are_together(first, last)) ++last;
            sort_cells<D>(keys.subspan(first, last - first), layout, place, workers);
        }
    });
}

}  // namespace signum
