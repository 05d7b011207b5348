#include "rows.hpp"

#include <array>
#include <charconv>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace signum::study {
namespace {

constexpr std::size_t columns = 13;

template <class Number>
bool read_number(std::string_view text, Number& number) {
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, number);
    return result.ec == std::errc{} && result.ptr == end;
}

bool read_row(std::string_view line, Row& row) {
    std::array<std::string_view, columns> words;
    for (std::size_t i = 0; i < columns; ++i) {
        const std::size_t comma = line.find(',');
        if ((comma == std::string_view::npos) != (i + 1 == columns)) return false;
        words[i] = line.substr(0, comma);
        if (comma != std::string_view::npos) line.remove_prefix(comma + 1);
    }
    row.setting.experiment = words[0];
    row.setting.metric = words[1];
    row.setting.distribution = words[2];
    row.contestant = words[7];
    row.quantity = words[8];
    return read_number(words[3], row.setting.sites) &&
           read_number(words[4], row.setting.perturbation) &&
           read_number(words[5], row.setting.radius_from) &&
           read_number(words[6], row.setting.radius_to) &&
           read_number(words[9], row.value.median) && read_number(words[10], row.value.low) &&
           read_number(words[11], row.value.high) && read_number(words[12], row.value.runs);
}

}  // namespace

std::string csv_header() {
    return "experiment,metric,distribution,sites,perturbation,radius_from,radius_to,contestant,"
           "quantity,value,low,high,runs\n";
}

std::string csv_line(const Row& row) {
    const Setting& at = row.setting;
    return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", at.experiment, at.metric,
                       at.distribution, at.sites, at.perturbation, at.radius_from, at.radius_to,
                       row.contestant, row.quantity, row.value.median, row.value.low,
                       row.value.high, row.value.runs);
}

Table read_csv(std::string_view text) {
    Table table;
    const std::string header = csv_header();
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
        Row row;
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

std::vector<Row> combined(const std::vector<Row>& passes) {
    std::vector<Row> rows;
    std::vector<std::vector<double>> values;
    std::map<std::string, std::size_t> places;
    for (const Row& row : passes) {
        const auto [found, is_new] = places.try_emplace(
            csv_line({row.setting, row.contestant, row.quantity, {}}), rows.size());
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

std::string json_array(const std::vector<Row>& rows) {
    std::string text = "[";
    for (const Row& row : rows) {
        const Setting& at = row.setting;
        text += fmt::format(
            "{}\n{{\"experiment\": \"{}\", \"metric\": \"{}\", \"distribution\": \"{}\", "
            "\"sites\": "
            "{}, \"perturbation\": {}, \"radius\": [{}, {}], \"contestant\": \"{}\", \"quantity\": "
            "\"{}\", \"value\": {}, \"low\": {}, \"high\": {}, \"runs\": {}}}",
            text.size() > 1 ? "," : "", at.experiment, at.metric, at.distribution, at.sites,
            at.perturbation, at.radius_from, at.radius_to, row.contestant, row.quantity,
            row.value.median, row.value.low, row.value.high, row.value.runs);
    }
    return text + "\n]";
}

}  // namespace signum::study
