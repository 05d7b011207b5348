#include "measure.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "work.hpp"

namespace signum::study {

std::vector<Row> measure(const Cell& cell, const Pass& pass) {
    const auto start = std::chrono::steady_clock::now();
    std::vector<Row> rows;
    switch (cell.work) {
        case Work::construction:
            rows = measure_construction(cell, pass);
            break;
        case Work::deletion:
            rows = measure_deletion(cell, pass);
            break;
        case Work::stage_cost:
            rows = measure_stage_cost(cell, pass);
            break;
        case Work::first_error:
            rows = measure_first_error(cell);
            break;
        case Work::margin:
            rows = measure_margin(cell);
            break;
    }
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    rows.push_back({cell.setting, "study", std::string(end_of_cell), exactly(seconds)});
    return rows;
}

}  // namespace signum::study
