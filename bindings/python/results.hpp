#pragma once
/// Results that more than one part of the module makes.

#include <optional>

#include <pybind11/pybind11.h>

#include "../../triangulation/tessellation.hpp"
#include "../../triangulation/validate.hpp"
#include "../../voronoi/conic.hpp"
#include "arrays.hpp"

namespace signum::python {

/// x and y, finite or not. Throws ValueError unless there are two numbers.
[[nodiscard]] inline Point point_of(const py::object& object, const std::string& what) {
    const py::array array = doubles(object);
    if (array.ndim() != 1 || array.size() != 2)
        throw py::value_error(what + ": two numbers are needed, x and y");
    const auto numbers = array.unchecked<double, 1>();
    return {numbers(0), numbers(1)};
}

/// x0, y0, x1, y1.
[[nodiscard]] inline std::optional<Box> box_of(const py::object& object) {
    if (object.is_none()) return std::nullopt;
    const py::array array = doubles(object);
    if (array.ndim() != 1 || array.size() != 4)
        throw py::value_error("box: four numbers are needed, x0, y0, x1, y1");
    const auto numbers = array.unchecked<double, 1>();
    return Box{numbers(0), numbers(1), numbers(2), numbers(3)};
}

}  // namespace signum::python
