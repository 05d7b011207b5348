/// Of any dimension, and of space: one text judges both.

#include "validate.hpp"

#include "../space/validate.hpp"
#include "check.hpp"

namespace signum {

template <int D>
Validation validate(const TessellationOf<D>& tessellation, std::span<const power::SiteOf<D>> sites,
                    const ValidationOptions& options) {
    return any_dimension::check(tessellation, sites, options);
}

#define SIGNUM_INSTANTIATE(D)                                                                    \
    template Validation validate<D>(const TessellationOf<D>&, std::span<const power::SiteOf<D>>, \
                                    const ValidationOptions&);
SIGNUM_INSTANTIATE(1)
SIGNUM_INSTANTIATE(2)
SIGNUM_INSTANTIATE(3)
SIGNUM_INSTANTIATE(4)
SIGNUM_INSTANTIATE(5)
SIGNUM_INSTANTIATE(6)
#undef SIGNUM_INSTANTIATE

Validation validate(const SpaceTessellation& tessellation, std::span<const Point3> sites,
                    const ValidationOptions& options) {
    return any_dimension::check(tessellation, sites, options);
}
Validation validate(const SpaceTessellation& tessellation, std::span<const Site3> sites,
                    const ValidationOptions& options) {
    return any_dimension::check(tessellation, sites, options);
}
Validation validate(const SpaceTessellation& tessellation, std::span<const power::Site3> sites,
                    const ValidationOptions& options) {
    return any_dimension::check(tessellation, sites, options);
}

}  // namespace signum
