#pragma once
/// Cramer's rule in space, for any type of number: where three planes meet. For sources only.

namespace signum::spatial {

/// The points p with (x, y, z)·p = height.
template <class Number>
struct Plane {
    Number x;
    Number y;
    Number z;
    Number height;
};

/// det(b, c, d), and what that times the meeting point of three planes comes to.
template <class Number>
struct Meeting {
    Number determinant;
    Number x;
    Number y;
    Number z;
};
template <class Number>
[[gnu::always_inline]] constexpr void meet(Meeting<Number>& meeting, const Plane<Number>& b,
                                           const Plane<Number>& c, const Plane<Number>& d) {
    const Number cd_x = c.y * d.z - c.z * d.y;
    const Number cd_y = c.z * d.x - c.x * d.z;
    const Number cd_z = c.x * d.y - c.y * d.x;
    const Number db_x = d.y * b.z - d.z * b.y;
    const Number db_y = d.z * b.x - d.x * b.z;
    const Number db_z = d.x * b.y - d.y * b.x;
    const Number bc_x = b.y * c.z - b.z * c.y;
    const Number bc_y = b.z * c.x - b.x * c.z;
    const Number bc_z = b.x * c.y - b.y * c.x;
    meeting.determinant = b.x * cd_x + b.y * cd_y + b.z * cd_z;
    meeting.x = b.height * cd_x + c.height * db_x + d.height * bc_x;
    meeting.y = b.height * cd_y + c.height * db_y + d.height * bc_y;
    meeting.z = b.height * cd_z + c.height * db_z + d.height * bc_z;
}

}  // namespace signum::spatial
