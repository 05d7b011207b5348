#pragma once
/// Pictures in formats that another program makes of an SVG: PNG, and PDF.
///
/// Laws:
///  1. The program is rsvg-convert, or else inkscape.
///  2. The bytes come back; what is written on the way lies in a scratch folder that goes.

#include <cstdint>
#include <string>
#include <string_view>

namespace signum {

enum class Converted : std::uint8_t { png, pdf };

class SvgConverter {
 public:
    /// Throws MachineError where there is no such program, and names a package that has one.
    SvgConverter();

    /// The bytes of the picture, its pixels those of the SVG. Throws MachineError. Some 20 ms and
    /// more of large pictures.
    [[nodiscard]] std::string convert(std::string_view svg, Converted format) const;

 private:
    std::string program_;
};

}  // namespace signum
