#pragma once
/// Sorting a few things. (std::sort does as well, but g++ 12 warns of what it would do with many.)

#include <cstddef>

namespace signum::any_dimension {

/// Sorts the places 0, ..., count-1 by exchanging neighbours: is_after(i, k) compares what lies at
/// two places, exchange(i, k) exchanges it. Whether the exchanges were even in number.
template <class IsAfter, class Exchange>
bool sort_few(std::size_t count, IsAfter is_after, Exchange exchange) {
    bool is_even = true;
    for (std::size_t i = 1; i < count; ++i)
        for (std::size_t k = i; k > 0 && is_after(k - 1, k); --k) {
            exchange(k - 1, k);
            is_even = !is_even;
        }
    return is_even;
}

/// The first `count` of an array, rising.
template <class Array>
bool sort_few(std::size_t count, Array& array) {
    return sort_few(
        count, [&](std::size_t i, std::size_t k) { return array[k] < array[i]; },
        [&](std::size_t i, std::size_t k) {
            const auto held = array[i];
            array[i] = array[k];
            array[k] = held;
        });
}

}  // namespace signum::any_dimension
