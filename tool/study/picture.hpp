#pragma once
/// What goes wrong, as a picture: for who reads on.

#include <cstdint>
#include <string>

namespace signum::study {

struct Picture {
    std::string svg;
    std::int64_t sites = 0;
    std::int64_t edges = 0;
    std::int64_t wrong = 0;
};

/// The tessellation of sites on a circle as single precision makes it, its wrong edges thick.
[[nodiscard]] Picture wrong_picture();

}  // namespace signum::study
