#pragma once
/// Meeting times behind the filter: the one double, by the rule of meeting.hpp.

#include "ball.hpp"
#include "meeting.hpp"

namespace signum::motion {

/// The meeting time of two balls, the second one's partner seen as the image says: a.x - b.x less
/// image · box lengths.
template <int D>
[[nodiscard]] double exact_meeting(const Ball<D>& a, const Ball<D>& b, const Image<D>& image,
                                   const Effects<D>& effects);

/// The meeting time of a ball and a side of the box.
template <int D>
[[nodiscard]] double exact_meeting(const Ball<D>& ball, Wall wall, const Effects<D>& effects);

/// The same as exact_meeting() by double-doubles, for a pair that meets, at some time near `about`;
/// NaN where they do not tell the double.
template <int D>
[[nodiscard]] double refined_meeting(const Ball<D>& a, const Ball<D>& b, const Image<D>& image,
                                     const Effects<D>& effects, double about) noexcept;
template <int D>
[[nodiscard]] double refined_meeting(const Ball<D>& ball, Wall wall, const Effects<D>& effects,
                                     double about) noexcept;

}  // namespace signum::motion
