#pragma once
/// The radii of atoms that touch without a bond, in Ångström.
///
/// Sources: A. Bondi, J. Phys. Chem. 68 (1964) 441; for elements of the main groups that it lacks
/// M. Mantina et al., J. Phys. Chem. A 113 (2009) 5806; for those that neither has, most metals,
/// S. Alvarez, Dalton Trans. 42 (2013) 8617. Actinides behind thorium, but for U, have none here.

#include <optional>
#include <string_view>

namespace signum {

/// By the symbol of the element, in letters of any case; D is hydrogen. Nothing for what is no
/// element of the table.
[[nodiscard]] std::optional<double> van_der_waals_radius(std::string_view element) noexcept;

/// Whether this is an element's symbol, in letters of any case, with a radius or without.
[[nodiscard]] bool is_element(std::string_view symbol) noexcept;

}  // namespace signum
