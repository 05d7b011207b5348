#pragma once
/// The parts of the module: each binds one idea, in the order of module.cpp.

#include <pybind11/pybind11.h>

namespace signum::python {

void bind_plane(pybind11::module_& module);
void bind_finite(pybind11::module_& module);
void bind_space(pybind11::module_& module);
void bind_predicates(pybind11::module_& module);
void bind_voronoi(pybind11::module_& module);
void bind_dynamic(pybind11::module_& module);
void bind_motion(pybind11::module_& module);

}  // namespace signum::python
