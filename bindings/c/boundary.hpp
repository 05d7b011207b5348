#pragma once
/// The line between C and C++, which no exception crosses: what is thrown becomes a status and a
/// message, pointers that are null and structs of another size are refused.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "../../core/contract.hpp"
#include "../../core/index.hpp"
#include "../../exact/floating_environment.hpp"
#include "../../motion/simulation.hpp"
#include "../../triangulation/options.hpp"
#include "../../triangulation/validate.hpp"
#include "signum.h"

namespace signum::c {

/// An argument that is refused, and the site to blame.
class Refused : public std::invalid_argument {
 public:
    explicit Refused(const std::string& what, std::int64_t site = -1)
        : std::invalid_argument(what), site_(site) {}
    [[nodiscard]] std::int64_t site() const noexcept { return site_; }

 private:
    std::int64_t site_;
};

/// The text, as much of it as there is room for.
template <std::size_t n>
void write(char (&place)[n], std::string_view text) noexcept {
    const std::size_t length = std::min(text.size(), n - 1);
    std::memcpy(place, text.data(), length);
    place[length] = '\0';
}

inline signum_status tell(signum_error* error, signum_status status, std::string_view message = {},
                          std::int64_t site = -1) noexcept {
    if (error == nullptr) return status;
    error->status = status;
    error->reserved = 0;
    error->site = site;
    write(error->message, message);
    return status;
}

/// Does the work, in the default environment, and says how it ended; `about` is the site that it is
/// about, where it is about one.
template <class Work>
signum_status guarded(signum_error* error, std::int64_t about, Work&& work) noexcept {
    // What is refused is the same in every environment, too.
    const exact::IeeeEnvironment environment;
    try {
        work();
        return tell(error, SIGNUM_OK);
    } catch (const Refused& refused) {
        return tell(error, SIGNUM_INVALID_ARGUMENT, refused.what(), refused.site());
    } catch (const motion::BallError& refused) {
        return tell(error, SIGNUM_INVALID_ARGUMENT, refused.what(), refused.ball());
    } catch (const std::bad_alloc&) {
        return tell(error, SIGNUM_NO_MEMORY, "there is not enough memory");
    } catch (const Stopped& stopped) {
        return tell(error, SIGNUM_STOPPED, stopped.what());
    } catch (const BrokenStructure& broken) {
        return tell(error, SIGNUM_BROKEN_STRUCTURE, broken.what());
    } catch (const std::length_error& beyond) {
        return tell(error, SIGNUM_BEYOND_RANGE, beyond.what());
    } catch (const std::range_error& beyond) {
        return tell(error, SIGNUM_BEYOND_RANGE, beyond.what());
    } catch (const std::overflow_error& beyond) {
        return tell(error, SIGNUM_BEYOND_RANGE, beyond.what());
    } catch (const std::logic_error& refused) {
        return tell(error, SIGNUM_INVALID_ARGUMENT, refused.what(), about);
    } catch (const std::exception& mistake) {
        return tell(error, SIGNUM_INTERNAL, mistake.what());
    } catch (...) {
        return tell(error, SIGNUM_INTERNAL, "something was thrown that is no exception");
    }
}
template <class Work>
signum_status guarded(signum_error* error, Work&& work) noexcept {
    return guarded(error, -1, std::forward<Work>(work));
}

/// Refuses null, naming the argument.
inline void expect(const void* pointer, const char* name) {
    if (pointer == nullptr) throw Refused(std::string(name) + " is null");
}

/// An array of `count` things: null is none.
inline void expect_array(const void* first, std::int64_t count, const char* name) {
    if (count < 0) throw Refused(std::string("there are ") + std::to_string(count) + " " + name);
    if (count > 0) expect(first, name);
}
/// Room for as many numbers, or balls, as there are to write.
inline void expect_room(const void* first, std::int64_t count, std::size_t needed,
                        const char* name) {
    if (count != static_cast<std::int64_t>(needed))
        throw Refused("there is room for " + std::to_string(count) + " " + name + ", of " +
                      std::to_string(needed));
    expect_array(first, count, name);
}

/// Sites are nothing but their numbers, as many as the type has.
template <class S>
[[nodiscard]] S as(const double* numbers) noexcept {
    return [&]<std::size_t... k>(std::index_sequence<k...>) {
        return S{numbers[k]...};
    }
    (std::make_index_sequence<sizeof(S) / sizeof(double)>{});
}
template <std::size_t n>
[[nodiscard]] bool finite(const double* numbers) noexcept {
    return numbers != nullptr &&
           std::all_of(numbers, numbers + n, [](double x) { return x - x == 0.0; });
}

/// Refuses the size of a struct whose caller has not set it, or knows more than the library. What a
/// version adds to a struct begins and ends at a multiple of 8 bytes, so that an older, shorter
/// size ends between two fields.
template <class Struct>
void expect_size(const Struct& given, const char* name) {
    if (given.size < 8 || given.size > sizeof(Struct) || given.size % 8 != 0)
        throw Refused("the size of the " + std::string(name) + " is " + std::to_string(given.size) +
                      ": it is to be set by their initializer, and at most " +
                      std::to_string(sizeof(Struct)));
}
/// A struct that its caller may have in an older, shorter form: the rest is as `standard` has it.
template <class Struct>
[[nodiscard]] Struct read(const Struct* given, const Struct& standard, const char* name) {
    if (given == nullptr) return standard;
    expect_size(*given, name);
    Struct whole = standard;
    std::memcpy(&whole, given, given->size);
    return whole;
}
/// Gives one back, as much as there is room for.
template <class Struct>
void give(Struct* place, Struct whole, const char* name) {
    expect(place, name);
    expect_size(*place, name);
    whole.size = place->size;
    std::memcpy(place, &whole, whole.size);
}

/// An enumerator of C as that of C++. Refuses what is none.
template <class Enum>
[[nodiscard]] Enum enumerator(std::int32_t number, Enum last, const char* name) {
    if (number < 0 || number > static_cast<std::int32_t>(last))
        throw Refused("there is no " + std::string(name) + " " + std::to_string(number));
    return static_cast<Enum>(number);
}
[[nodiscard]] inline Metric metric_of(signum_metric metric) {
    return enumerator(metric, all_metrics.back(), "metric");
}
[[nodiscard]] inline WeightIs weight_of(signum_weight_is weight_is) {
    return enumerator(weight_is, WeightIs::weight, "meaning of a third number");
}

/// The options of C as those of C++; what they ask of sites is told apart.
struct Asked {
    Options options;
    WeightIs weight_is;
};
[[nodiscard]] Asked asked(const signum_options* options);
/// What a validation heeds of them.
[[nodiscard]] ValidationOptions for_validation(const Asked& asked);

/// `count` sites of `stride` doubles, the first `least_stride` + 1 of which are looked at. Throws
/// Refused for arrays that cannot be, for more sites than `most`, and for one with a number that is
/// not finite or beyond `largest`.
void expect_sites(const double* sites, std::int64_t count, std::int64_t stride,
                  std::int64_t least_stride, double largest, std::int64_t most = max_sites);

}  // namespace signum::c
