/// What C++20 has words for, in those of C++17.

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace signum {
namespace words {

template <class T>
using Bare = std::remove_cv_t<std::remove_reference_t<T>>;

template <class A, class B>
inline constexpr bool same = std::is_same_v<A, B>;

// Whether a type has a member of that name, of data or a function that is alone of its name.
#define SIGNUM_MEMBER(name)                                                    \
    template <class T, class = void>                                           \
    struct Has_##name : std::false_type {};                                    \
    template <class T>                                                         \
    struct Has_##name<T, std::void_t<decltype(&T::name)>> : std::true_type {}; \
    template <class T>                                                         \
    inline constexpr bool has_##name = Has_##name<Bare<T>>::value;
SIGNUM_MEMBER(z)
SIGNUM_MEMBER(r)
SIGNUM_MEMBER(w)
SIGNUM_MEMBER(window)
SIGNUM_MEMBER(sign)
SIGNUM_MEMBER(filter)
SIGNUM_MEMBER(zero)
SIGNUM_MEMBER(difference)
SIGNUM_MEMBER(difference_of_squares)
#undef SIGNUM_MEMBER
template <class T, class = void>
inline constexpr bool has_exactly = false;
template <class T>
inline constexpr bool has_exactly<T, std::void_t<decltype(T::exactly(0.0))>> = true;

template <class T>
class span {
 public:
    constexpr span() noexcept = default;
    constexpr span(T* first, std::size_t size) noexcept : first_(first), size_(size) {}
    template <std::size_t n>
    constexpr span(T (&array)[n]) noexcept : first_(array), size_(n) {}
    [[nodiscard]] constexpr T* begin() const noexcept { return first_; }
    [[nodiscard]] constexpr T* end() const noexcept { return first_ + size_; }
    [[nodiscard]] constexpr T* data() const noexcept { return first_; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }
    [[nodiscard]] constexpr bool empty() const noexcept { return size_ == 0; }
    [[nodiscard]] constexpr T& front() const noexcept { return *first_; }
    [[nodiscard]] constexpr T& operator[](std::size_t i) const noexcept { return first_[i]; }
    [[nodiscard]] constexpr span subspan(std::size_t from) const noexcept {
        return {first_ + from, size_ - from};
    }

 private:
    T* first_ = nullptr;
    std::size_t size_ = 0;
};

template <class To, class From>
[[nodiscard]] constexpr To bit_cast(const From& from) noexcept {
    return __builtin_bit_cast(To, from);
}
[[nodiscard]] constexpr int countl_zero(std::uint64_t x) noexcept {
    return x == 0 ? 64 : __builtin_clzll(x);
}
[[nodiscard]] constexpr int countr_zero(std::uint64_t x) noexcept {
    return x == 0 ? 64 : __builtin_ctzll(x);
}
[[nodiscard]] constexpr int bit_width(std::uint64_t x) noexcept {
    return 64 - countl_zero(x);
}
[[nodiscard]] constexpr std::uint64_t bit_ceil(std::uint64_t x) noexcept {
    return x <= 1 ? 1 : std::uint64_t{1} << bit_width(x - 1);
}

}  // namespace words
}  // namespace signum
