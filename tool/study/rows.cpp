#include "rows.hpp"

#include <charconv>
#include <map>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <variant>

#include <fmt/format.h>

namespace signum::study {
namespace {

using Field = std::variant<std::string*, std::int64_t*, double*, std::size_t*>;

/// The columns of a table, and where they are in a row. They stand here alone.
std::vector<std::pair<std::string_view, Field>> fields_of(Row& row, Of of) {
    Setting& at = row.setting;
    std::vector<std::pair<std::string_view, Field>> fields = {{"experiment", &at.experiment}};
    if (of == Of::sites)
        fields.insert(fields.end(), {{"metric", &at.metric},
                                     {"distribution", &at.distribution},
                                     {"sites", &at.count},
                                     {"perturbation", &at.perturbation},
                                     {"radius_from", &at.radius_from},
                                     {"radius_to", &at.radius_to}});
    else
        fields.insert(fields.end(), {{"balls", &at.count},
                                     {"size_ratio", &at.size_ratio},
                                     {"packing", &at.packing},
                                     {"time_step", &at.time_step}});
    fields.insert(fields.end(), {{"contestant", &row.contestant},
                                 {"quantity", &row.quantity},
                                 {"value", &row.value.median},
                                 {"low", &row.value.low},
                                 {"high", &row.value.high},
                                 {"runs", &row.value.runs}});
    return fields;
}

std::string text_of(const Field& field) {
    return std::visit([](const auto* value) { return fmt::format("{}", *value); }, field);
}

/// Of a column, whose number it becomes or whose word it is.
bool read_field(std::string_view text, std::string& word) {
    word = text;
    return true;
}
template <class Number>
bool read_field(std::string_view text, Number& number) {
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, number);
    return result.ec == std::errc{} && result.ptr == end;
}

bool read_row(std::string_view line, Row& row, Of of) {
    const auto fields = fields_of(row, of);
    for (const auto& [name, field] : fields) {
        const std::string_view text = line.substr(0, line.find(','));
        if (!std::visit([&](auto* value) { return read_field(text, *value); }, field)) return false;
        line.remove_prefix(text.size());
        const bool is_last = name == fields.back().first;
        if (line.empty() != is_last) return false;
        if (!is_last) line.remove_prefix(1);
    }
    return true;
}

/// What `write` makes of the columns of a row, with a comma between them.
template <class Write>
std::string line_of(Row row, Of of, std::string_view comma, const Write& write) {
    std::string text;
    for (const auto& [name, field] : fields_of(row, of))
        text += fmt::format("{}{}", write(name, field), comma);
    return text.substr(0, text.size() - comma.size());
}

}  // namespace

std::map<std::string, std::string> columns_of(const Row& row, Of of) {
    Row copy = row;
    std::map<std::string, std::string> columns;
    for (const auto& [name, field] : fields_of(copy, of))
        columns[std::string(name)] = text_of(field);
    return columns;
}

std::string csv_header(Of of) {
    return line_of({}, of, ",", [](std::string_view name, const Field&) { return name; }) + "\n";
}

std::string csv_line(const Row& row, Of of) {
    return line_of(row, of, ",",
                   [](std::string_view, const Field& field) { return text_of(field); }) +
           "\n";
}

Table read_csv(std::string_view text, Of of) {
    Table table;
    const std::string header = csv_header(of);
    if (!text.starts_with(header)) {
        if (std::string_view(header).starts_with(text)) return table;  // cut off at once
        throw std::invalid_argument("line 1 is not the header of a study");
    }
    table.bytes = header.size();
    std::size_t complete = 0;
    std::size_t place = header.size();
    for (std::size_t number = 2;; ++number) {
        const std::size_t end = text.find('\n', place);
        if (end == std::string_view::npos) break;
        Row& row = table.rows.emplace_back();
        if (!read_row(text.substr(place, end - place), row, of))
            throw std::invalid_argument(fmt::format("line {} is no row of a study", number));
        place = end + 1;
        if (row.quantity != end_of_cell) continue;
        complete = table.rows.size();
        table.bytes = place;
    }
    table.rows.resize(complete);
    return table;
}

std::vector<Row> combined(const std::vector<Row>& passes) {
    std::vector<Row> rows;
    std::vector<std::vector<double>> values;
    std::map<std::tuple<Setting, std::string, std::string>, std::size_t> places;
    for (const Row& row : passes) {
        const auto [found, is_new] =
            places.try_emplace({row.setting, row.contestant, row.quantity}, rows.size());
        if (is_new) {
            rows.push_back(row);
            values.emplace_back();
        }
        values[found->second].push_back(row.value.median);
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (values[i].size() < 2) continue;
        if (rows[i].quantity == end_of_cell) {
            const double sum = std::accumulate(values[i].begin(), values[i].end(), 0.0);
            rows[i].value = {sum, sum, sum, values[i].size()};
        } else {
            rows[i].value = median_of(std::move(values[i]));
        }
    }
    return rows;
}

std::string json_array(const std::vector<Row>& rows, Of of) {
    std::string text = "[";
    for (const Row& row : rows) {
        const auto write = [](std::string_view name, const Field& field) {
            const char* quote = std::holds_alternative<std::string*>(field) ? "\"" : "";
            return fmt::format("\"{0}\": {1}{2}{1}", name, quote, text_of(field));
        };
        text += text.size() > 1 ? ",\n{" : "\n{";
        text += line_of(row, of, ", ", write) + "}";
    }
    return text + "\n]";
}

}  // namespace signum::study
