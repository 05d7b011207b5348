#include "validate.hpp"

#include "any_dimension/check.hpp"

namespace signum {

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
