#pragma once
/// Results that more than one part of the module makes.

#include <cstddef>
#include <optional>
#include <string>
#include <typeinfo>

#include <pybind11/pybind11.h>

#include "../../core/index.hpp"
#include "../../triangulation/tessellation.hpp"
#include "../../triangulation/validate.hpp"
#include "../../voronoi/conic.hpp"
#include "arrays.hpp"

namespace signum::python {

/// What all classes of the module have: an object that __new__ alone has made is refused by all
/// methods, where pybind11 would read memory that nobody has filled; and so is pickling, of which
/// the older protocols would have pybind11 end the process.
template <class Class>
void complete(Class& bound) {
    py::detail::get_type_info(typeid(typename Class::type))->operator_new =
        [](std::size_t) -> void* {
        throw py::type_error("this object is empty: __new__ alone has made it, without __init__");
    };
    const std::string refusal =
        "cannot pickle or copy a " + std::string(py::str(bound.attr("__name__")));
    bound.def(
        "__reduce_ex__",
        [refusal](const py::object&, const py::object&) -> py::object {
            throw py::type_error(refusal);
        },
        py::arg("protocol"), "Raises TypeError.");
}

/// A float, or what turns into one. Throws TypeError otherwise.
[[nodiscard]] inline double number_of(const py::object& object, const std::string& what) {
    try {
        return object.cast<double>();
    } catch (const py::cast_error&) {
        throw py::type_error(what + ": a float is needed, or what turns into one");
    }
}

/// Throws ValueError where no tessellation has as many sites: an array without memory of its own
/// may have any number of rows, and going through them would not end.
inline void refuse_too_many(std::size_t sites) {
    if (sites > static_cast<std::size_t>(max_sites))
        throw py::value_error("too many sites: " + std::to_string(sites) + ", the limit is " +
                              std::to_string(max_sites));
}

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
