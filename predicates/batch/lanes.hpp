#pragma once
/// The filters of several questions at once, a question a lane of a vector. For sources only.
///
/// A lane does what the filter of one question does: the same formulas (compared_ccw,
/// compared_in_circle) in a number that is a vector of doubles, each of whose operations is that
/// operation on each double, and so the same bound holds. Like a filter it decides in the default
/// environment alone.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "../../core/index.hpp"
#include "../../core/strided_sites.hpp"

namespace signum::predicates::batch {

/// n sites a question: the site of its own number of each operand, or those whose places are named.
template <std::size_t n>
struct Questions {
    std::array<const StridedSites*, n> operands;
    /// Of question i at i·n to i·n + n-1; null where none are named.
    const Index* places;
    std::size_t count;

    /// The place of question i's site in operand m.
    [[nodiscard]] std::size_t place(std::size_t m, std::size_t i) const noexcept {
        if (places != nullptr) return static_cast<std::size_t>(places[i * n + m]);
        return operands[m]->size() == 1 ? 0 : i;
    }
    [[nodiscard]] Site site(std::size_t m, std::size_t i) const noexcept {
        return (*operands[m])[place(m, i)];
    }
};

/// What the third numbers of sites are.
enum class Third : std::uint8_t { none, radius, weight };

/// The sign of question i, by the predicate for one.
template <std::size_t n>
using Ask = std::int8_t (*)(const Questions<n>& questions, std::size_t i) noexcept;
/// All signs; asks what the filter leaves open, and returns how many these were.
/// Precondition: the default environment.
template <std::size_t n>
using Filter = std::size_t (*)(const Questions<n>& questions, std::int8_t* signs,
                               Ask<n> ask) noexcept;

/// A part of a batch: so many questions at once have their sites brought together, where they do
/// not lie one behind another, before any of them is computed.
inline constexpr std::size_t part_of_batch = 128;

template <class S>
inline constexpr std::size_t numbers = sizeof(S) / sizeof(double);
template <class S>
using Copies = std::array<double, numbers<S> * part_of_batch>;

/// The sites of operand m for `count` questions from i on, one behind another as in an array of S,
/// where they are or copied: `least` at least, 0 where there are no more.
/// Not inlined, and so compiled once: wide instructions make it no faster.
template <class S, std::size_t n>
[[gnu::noinline]] const double* array_of(const Questions<n>& questions, std::size_t m,
                                         std::size_t i, std::size_t count, std::size_t least,
                                         Copies<S>& copies) noexcept {
    const StridedSites& sites = *questions.operands[m];
    const bool named = questions.places != nullptr;
    const bool serves_all = !named && (sites.size() == 1 || sites.stride() == 0);
    // Nothing is read but the numbers of sites.
    const bool together =
        sites.y() == sites.x() + 1 && (numbers<S> == 2 || sites.third() == sites.x() + 2);
    if (together && sites.stride() == sizeof(S) && !named && !serves_all && count >= least)
        return sites.x() + numbers<S> * i;
    if (serves_all && i > 0) return copies.data();
    double* next = copies.data();
    if (together && named) {
        const char* const first = reinterpret_cast<const char*>(sites.x());
        const std::ptrdiff_t stride = sites.stride();
        const Index* place = questions.places + i * n + m;
        for (std::size_t k = 0; k < count; ++k, place += n) {
            const double* from = reinterpret_cast<const double*>(first + *place * stride);
            for (std::size_t number = 0; number < numbers<S>; ++number) *next++ = from[number];
        }
    } else {
        for (std::size_t k = i; k < i + count; ++k) {
            const Site site = questions.site(m, k);
            *next++ = site.x;
            *next++ = site.y;
            if constexpr (numbers<S> == 3) *next++ = site.r;
        }
    }
    while (next < copies.data() + numbers<S> * least) *next++ = 0.0;
    return copies.data();
}

/// The filters, compiled for one set of instructions.
struct Instructions {
    const char* name;
    /// Of points, and of sites with a third number, which it passes over.
    std::array<Filter<3>, 2> ccw;
    /// By Third.
    std::array<Filter<4>, 3> in_circle;
};
/// Those that the processor at hand has, the widest first. Empty without Highway.
[[nodiscard]] std::span<const Instructions> instructions() noexcept;

/// All signs, and how many questions were asked one by one: all of them where there are no
/// instructions, or the environment is not the default.
std::size_t ccw(const Instructions* with, const Questions<3>& questions,
                std::int8_t* signs) noexcept;
std::size_t in_circle(const Instructions* with, const Questions<4>& questions,
                      std::int8_t* signs) noexcept;

}  // namespace signum::predicates::batch
