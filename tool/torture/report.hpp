#pragma once
/// What is said of a trial: in words, as JSON, as a page with pictures.

#include <array>
#include <string>

#include "trial.hpp"

namespace signum::torture {

struct Report {
    std::string plugin;
    double seconds;
    std::array<Trial, functions> trials;
    [[nodiscard]] bool is_faultless() const noexcept;
};

[[nodiscard]] std::string in_words(const Report& report);
[[nodiscard]] std::string as_json(const Report& report);
[[nodiscard]] std::string as_page(const Report& report);

}  // namespace signum::torture
