#pragma once
/// validate() of simplices without infinity. For sources of the module only.

#include <string>

#include "../../triangulation/validate_finite.hpp"
#include "arrays.hpp"

namespace signum::python {

/// Whether no number in a table of them is below 0, or rows have four: what has no infinity.
[[nodiscard]] bool has_no_infinity(const py::object& faces);
/// Throws ValueError as the functions that read arrays do.
[[nodiscard]] FiniteValidation validated_finite(const py::object& sites,
                                                const py::object& simplices,
                                                const std::string& weight_is, int threads,
                                                const py::object& progress);

}  // namespace signum::python
