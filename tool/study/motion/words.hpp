#pragma once
/// What the page of moving balls says of numbers: computed from the rows, the thesis's among them.

#include <toml++/toml.h>

#include "../rows.hpp"
#include "../template.hpp"

namespace signum::study {

/// The thesis's tables, as they stand in pages/motion.toml, as rows of an experiment "thesis": by
/// contestant auto what is the same for all structures.
[[nodiscard]] std::vector<Row> thesis_rows(const toml::table& page);

/// The values in the text of a part of the page; empty where there are no rows to compute them
/// from.
[[nodiscard]] Values words_of(const std::string& figure, const toml::table& page,
                              const std::vector<Row>& rows);

}  // namespace signum::study
