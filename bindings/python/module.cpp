/// The module signum._signum; signum/__init__.py gives its names to users.

#include "../c/signum.h"
#include "parts.hpp"

PYBIND11_MODULE(_signum, module) {
    using namespace signum::python;
    module.doc() = "The compiled part of signum.";
    module.attr("__version__") = signum_version();
    bind_plane(module);
    bind_finite(module);
    bind_space(module);
    bind_predicates(module);
    bind_voronoi(module);
    bind_dynamic(module);
    bind_motion(module);
}
