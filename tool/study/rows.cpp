#include "rows.hpp"

#include <array>
#include <charconv>
#include <map>
#include <numeric>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "motion/setting.hpp"

namespace signum::study {
namespace {

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

/// All columns of a row, in their order.
template <class Row>
auto all_fields(Row& row) {
    return std::tuple_cat(std::remove_const_t<decltype(row.setting)>::fields(row.setting),
                          std::tie(row.contestant, row.quantity, row.value.median, row.value.low,
                                   row.value.high, row.value.runs));
}

template <class At>
bool read_row(std::string_view line, RowOf<At>& row) {
    bool is_right = true;
    std::size_t left = At::columns.size() + 6;
    const auto read_next = [&](auto& field) {
        const std::size_t comma = line.find(',');
        --left;
        is_right = is_right && (comma == std::string_view::npos) == (left == 0) &&
                   read_field(line.substr(0, comma), field);
        if (comma != std::string_view::npos) line.remove_prefix(comma + 1);
    };
    std::apply([&](auto&... field) { (read_next(field), ...); }, all_fields(row));
    return is_right;
}

}  // namespace

template <class At>
std::string csv_header() {
    std::string text;
    for (const std::string_view column : At::columns) text += fmt::format("{},", column);
    return text + "contestant,quantity,value,low,high,runs\n";
}

template <class At>
std::string csv_line(const RowOf<At>& row) {
    std::string text;
    std::apply([&](const auto&... field) { ((text += fmt::format("{},", field)), ...); },
               all_fields(row));
    text.back() = '\n';
    return text;
}

template <class At>
TableOf<At> read_csv(std::string_view text) {
    TableOf<At> table;
    const std::string header = csv_header<At>();
    if (!text.starts_with(header)) {
        if (header.starts_with(text)) return table;  // cut off at once
        throw std::invalid_argument("line 1 is not the header of a study");
    }
    table.bytes = header.size();
    std::size_t complete = 0;
    std::size_t place = header.size();
    for (std::size_t number = 2;; ++number) {
        const std::size_t end = text.find('\n', place);
        if (end == std::string_view::npos) break;
        RowOf<At> row;
        if (!read_row(text.substr(place, end - place), row))
            throw std::invalid_argument(fmt::format("line {} is no row of a study", number));
        place = end + 1;
        const bool ends = row.quantity == end_of_cell;
        table.rows.push_back(std::move(row));
        if (ends) {
            complete = table.rows.size();
            table.bytes = place;
        }
    }
    table.rows.resize(complete);
    return table;
}

template <class At>
std::vector<RowOf<At>> combined(const std::vector<RowOf<At>>& passes) {
    std::vector<RowOf<At>> rows;
    std::vector<std::vector<double>> values;
    std::map<std::string, std::size_t> places;
    for (const RowOf<At>& row : passes) {
        const auto [found, is_new] = places.try_emplace(
            csv_line(RowOf<At>{row.setting, row.contestant, row.quantity, {}}), rows.size());
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

template <class At>
std::string json_array(const std::vector<RowOf<At>>& rows) {
    const auto in_json = [](const auto& field) {
        if constexpr (std::is_same_v<decltype(field), const std::string&>)
            return fmt::format("\"{}\"", field);
        else
            return fmt::format("{}", field);
    };
    std::string text = "[";
    for (const RowOf<At>& row : rows) {
        text += text.size() > 1 ? ",\n{" : "\n{";
        std::size_t column = 0;
        std::apply(
            [&](const auto&... field) {
                ((text += fmt::format("\"{}\": {}, ", At::columns[column++], in_json(field))), ...);
            },
            At::fields(row.setting));
        text += fmt::format(
            "\"contestant\": \"{}\", \"quantity\": \"{}\", \"value\": {}, \"low\": {}, \"high\": "
            "{}, \"runs\": {}}}",
            row.contestant, row.quantity, row.value.median, row.value.low, row.value.high,
            row.value.runs);
    }
    return text + "\n]";
}

template std::string csv_header<Setting>();
template std::string csv_line(const Row&);
template TableOf<Setting> read_csv(std::string_view);
template std::vector<Row> combined(const std::vector<Row>&);
template std::string json_array(const std::vector<Row>&);

template std::string csv_header<MotionSetting>();
template std::string csv_line(const MotionRow&);
template TableOf<MotionSetting> read_csv(std::string_view);
template std::vector<MotionRow> combined(const std::vector<MotionRow>&);
template std::string json_array(const std::vector<MotionRow>&);

}  // namespace signum::study
