#pragma once
/// What programs call coordinates: X, POINT_X, X_UTM, easting, stop_lon, Latitude (deg).

#include <cstdint>
#include <optional>
#include <string_view>

namespace signum {

/// Names that belong together: x with y, easting with northing, longitude with latitude, E with N.
enum class NameFamily : std::uint8_t { letters, projected, geographic, initials };
struct CoordinateName {
    NameFamily family;
    int axis;  ///< 0 is x, 1 is y, 2 is z
    friend bool operator==(const CoordinateName&, const CoordinateName&) = default;
};

/// Of a column's name, in any case; nothing where it is none, such as x_error or latitude_zone.
[[nodiscard]] std::optional<CoordinateName> coordinate_named(std::string_view name);

/// Whether a column of that name numbers or names the rows, such as OBJECTID, fid or #: it is never
/// a coordinate.
[[nodiscard]] bool is_name_of_identifier(std::string_view name);

}  // namespace signum
