#pragma once
/// What was measured, to be asked. For the sources of study/.

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "rows.hpp"

namespace signum::study {

using Cells = std::vector<Setting>;

class Results {
 public:
    explicit Results(const std::vector<Row>& rows) {
        for (const Row& row : rows) {
            values_.try_emplace({row.setting, row.contestant, row.quantity}, row.value);
            if (std::ranges::find(cells_, row.setting) == cells_.end())
                cells_.push_back(row.setting);
        }
    }

    /// The cells of which it holds, in the order of the plan.
    [[nodiscard]] Cells cells(const std::function<bool(const Setting&)>& which) const {
        Cells found;
        std::ranges::copy_if(cells_, std::back_inserter(found), which);
        return found;
    }
    [[nodiscard]] std::optional<Interval> interval(const Setting& cell,
                                                   const std::string& contestant,
                                                   const std::string& quantity) const {
        const auto found = values_.find({cell, contestant, quantity});
        if (found == values_.end()) return std::nullopt;
        return found->second;
    }
    [[nodiscard]] std::optional<double> value(const Setting& cell, const std::string& contestant,
                                              const std::string& quantity) const {
        const auto found = interval(cell, contestant, quantity);
        return found ? std::optional(found->median) : std::nullopt;
    }

 private:
    Cells cells_;
    std::map<std::tuple<Setting, std::string, std::string>, Interval> values_;
};

}  // namespace signum::study
