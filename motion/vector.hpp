#pragma once
/// Places, speeds and boxes in the plane (D = 2) and in space (D = 3).

namespace signum::motion {

/// One thing an axis.
template <class T, int D>
struct PerAxis {
    T values[D]{};

    [[nodiscard]] constexpr T& operator[](int axis) noexcept { return values[axis]; }
    [[nodiscard]] constexpr const T& operator[](int axis) const noexcept { return values[axis]; }
    [[nodiscard]] constexpr T* begin() noexcept { return values; }
    [[nodiscard]] constexpr T* end() noexcept { return values + D; }
    [[nodiscard]] constexpr const T* begin() const noexcept { return values; }
    [[nodiscard]] constexpr const T* end() const noexcept { return values + D; }
    constexpr void fill(const T& value) noexcept {
        for (T& each : values) each = value;
    }
    friend bool operator==(const PerAxis&, const PerAxis&) = default;
};

template <int D>
using Vector = PerAxis<double, D>;

template <int D>
[[nodiscard, gnu::always_inline]] inline double dot(const Vector<D>& a,
                                                    const Vector<D>& b) noexcept {
    double sum = a[0] * b[0];
    for (int i = 1; i < D; ++i) sum += a[i] * b[i];
    return sum;
}

/// An axis-parallel box: low < high in each coordinate.
template <int D>
struct Box {
    Vector<D> low{};
    Vector<D> high{};
};

}  // namespace signum::motion
