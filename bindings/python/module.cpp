/// The module signum._signum; signum/__init__.py gives its names to users.

#include "parts.hpp"

PYBIND11_MODULE(_signum, module) {
    using namespace signum::python;
    module.doc() = "The compiled part of signum.";
    bind_plane(module);
    bind_space(module);
    bind_predicates(module);
    bind_voronoi(module);
    bind_dynamic(module);
    bind_motion(module);
}
