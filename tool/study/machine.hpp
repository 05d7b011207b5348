#pragma once
/// What the times of a study belong to: the machine and the compiler.

#include <string>
#include <utility>
#include <vector>

namespace signum::study {

/// Names and values, to be shown in this order: processor, its number of cores, memory, system,
/// compiler.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> describe_machine();

}  // namespace signum::study
