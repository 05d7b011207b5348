#pragma once
/// Places, speeds and boxes in the plane (D = 2) and in space (D = 3).

#include <cmath>
#include <numbers>

#include "../core/contract.hpp"
#include "field.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::motion {

/// One thing an axis.
template <class T, int D>
struct PerAxis {
    T values[D]{};  ///< in the order of the axes

    /// That of an axis: 0, 1, 2.
    [[nodiscard]] constexpr T& operator[](int axis) noexcept { return values[axis]; }
    /// The same.
    [[nodiscard]] constexpr const T& operator[](int axis) const noexcept { return values[axis]; }
    /// The first one.
    [[nodiscard]] constexpr T* begin() noexcept { return values; }
    /// Behind the last one.
    [[nodiscard]] constexpr T* end() noexcept { return values + D; }
    /// The first one.
    [[nodiscard]] constexpr const T* begin() const noexcept { return values; }
    /// Behind the last one.
    [[nodiscard]] constexpr const T* end() const noexcept { return values + D; }
    /// Gives all of them one value.
    constexpr void fill(const T& value) noexcept {
        for (T& each : values) each = value;
    }
    friend bool operator==(const PerAxis&, const PerAxis&) = default;
};

/// A place, a velocity, an acceleration.
template <int D>
using Vector = PerAxis<double, D>;

/// By components, in numbers of any kind.
template <class T, int D>
[[nodiscard, gnu::always_inline]] constexpr PerAxis<T, D> operator+(PerAxis<T, D> a,
                                                                    const PerAxis<T, D>& b) {
    for (int k = 0; k < D; ++k) a[k] = a[k] + b[k];
    return a;
}
/// The same.
template <class T, int D>
[[nodiscard, gnu::always_inline]] constexpr PerAxis<T, D> operator-(PerAxis<T, D> a,
                                                                    const PerAxis<T, D>& b) {
    for (int k = 0; k < D; ++k) a[k] = a[k] - b[k];
    return a;
}
/// The same.
template <class T, int D>
[[nodiscard, gnu::always_inline]] constexpr PerAxis<T, D> operator*(const T& factor,
                                                                    PerAxis<T, D> v) {
    for (int k = 0; k < D; ++k) v[k] = factor * v[k];
    return v;
}

/// a·b, rounded.
template <int D>
[[nodiscard, gnu::always_inline]] inline double dot(const Vector<D>& a,
                                                    const Vector<D>& b) noexcept {
    double sum = a[0] * b[0];
    for (int i = 1; i < D; ++i) sum += a[i] * b[i];
    return sum;
}
/// The same in other numbers.
template <class T, int D>
[[nodiscard]] auto dot(const PerAxis<T, D>& a, const PerAxis<T, D>& b) {
    auto sum = a[0] * b[0];
    for (int i = 1; i < D; ++i) sum = sum + a[i] * b[i];
    return sum;
}
/// |v|, rounded.
template <int D>
[[nodiscard, gnu::always_inline]] inline double norm(const Vector<D>& v) noexcept {
    return std::sqrt(dot(v, v));
}

/// A ball's area or volume.
template <int D>
[[nodiscard]] constexpr double ball_volume(double radius) noexcept {
    constexpr double of_radius_1 = D == 2 ? std::numbers::pi : 4.0 / 3.0 * std::numbers::pi;
    return of_radius_1 * (D == 2 ? 1.0 : radius) * radius * radius;
}

/// An angular velocity, in radians per unit of time: one number in the plane, counterclockwise.
template <int D>
using Spin = PerAxis<double, D == 2 ? 1 : 3>;

/// spin × arm.
[[nodiscard]] inline Vector<2> turned(const Spin<2>& spin, const Vector<2>& arm) noexcept {
    return {{-spin[0] * arm[1], spin[0] * arm[0]}};
}
/// The same in space.
[[nodiscard]] inline Vector<3> turned(const Spin<3>& spin, const Vector<3>& arm) noexcept {
    return {{spin[1] * arm[2] - spin[2] * arm[1], spin[2] * arm[0] - spin[0] * arm[2],
             spin[0] * arm[1] - spin[1] * arm[0]}};
}
/// arm × push: the torque.
[[nodiscard]] inline Spin<2> torque(const Vector<2>& arm, const Vector<2>& push) noexcept {
    return {{arm[0] * push[1] - arm[1] * push[0]}};
}
/// The same in space.
[[nodiscard]] inline Spin<3> torque(const Vector<3>& arm, const Vector<3>& push) noexcept {
    return {turned(arm, push)};
}

/// An axis-parallel box: low < high in each coordinate.
template <int D>
struct Box {
    Vector<D> low{};   ///< the corner of least coordinates
    Vector<D> high{};  ///< the opposite corner

    /// Describes the members.
    static constexpr void each_field(const auto& visit) {
        visit(&Box::low, {"low", dimensions::length});
        visit(&Box::high, {"high", dimensions::length});
    }

    /// How long its sides are, rounded.
    [[nodiscard]] constexpr Vector<D> lengths() const noexcept { return high - low; }
    /// Its area or volume, rounded.
    [[nodiscard]] constexpr double volume() const noexcept {
        double volume = 1.0;
        for (const double length : lengths()) volume *= length;
        return volume;
    }
};

}  // namespace signum::motion

SIGNUM_IEEE_END
