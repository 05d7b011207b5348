#pragma once
/// Sites of space as arrays give them. For sources of the module only.

#include <span>
#include <type_traits>
#include <variant>
#include <vector>

#include "../../core/site.hpp"
#include "arrays.hpp"

namespace signum::python {

/// Points, balls, or sites that carry a weight.
using Sites = std::variant<std::vector<Point3>, std::vector<Site3>, std::vector<power::Site3>>;

/// ask() of the sites in their own type.
template <class Ask>
auto with_sites(const Sites& sites, Ask ask) {
    return std::visit([&](const auto& all) { return ask(std::span(all)); }, sites);
}

template <class S>
std::vector<S> copied(const Rows& rows) {
    std::vector<S> sites(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if constexpr (std::is_same_v<S, Point3>)
            sites[i] = {rows.at(i, 0), rows.at(i, 1), rows.at(i, 2)};
        else
            sites[i] = {rows.at(i, 0), rows.at(i, 1), rows.at(i, 2), rows.at(i, 3)};
    }
    return sites;
}
/// Of rows of three numbers points; of four balls, or with `weights` sites that carry one. Throws
/// ValueError for other rows.
[[nodiscard]] inline Sites sites_of(const py::object& object, bool weights) {
    const Rows rows(object, "sites", 3, 4);
    if (rows.columns() == 3) return copied<Point3>(rows);
    if (weights) return copied<power::Site3>(rows);
    return copied<Site3>(rows);
}

}  // namespace signum::python
