#include "rows.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <numeric>
#include <optional>
#include <ranges>
#include <stdexcept>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

#include <fmt/format.h>

namespace signum::study {
namespace {

using Member = std::variant<std::string Setting::*, std::int64_t Setting::*, double Setting::*,
                            std::string Row::*, double Interval::*, std::size_t Interval::*>;

template <class Owner, class T>
auto& in(Owner& row, T Setting::*member) {
    return row.setting.*member;
}
template <class Owner, class T>
auto& in(Owner& row, T Row::*member) {
    return row.*member;
}
template <class Owner, class T>
auto& in(Owner& row, T Interval::*member) {
    return row.value.*member;
}

/// Of the tables of both kinds, or of one.
struct Column {
    std::string_view name;
    Member member;
    std::optional<Of> of = {};
};
constexpr std::array all_columns = {Column{"experiment", &Setting::experiment},
                                    Column{"metric", &Setting::metric, Of::sites},
                                    Column{"distribution", &Setting::distribution, Of::sites},
                                    Column{"sites", &Setting::count, Of::sites},
                                    Column{"perturbation", &Setting::perturbation, Of::sites},
                                    Column{"radius_from", &Setting::radius_from, Of::sites},
                                    Column{"radius_to", &Setting::radius_to, Of::sites},
                                    Column{"balls", &Setting::count, Of::balls},
                                    Column{"size_ratio", &Setting::size_ratio, Of::balls},
                                    Column{"packing", &Setting::packing, Of::balls},
                                    Column{"time_step", &Setting::time_step, Of::balls},
                                    Column{"contestant", &Row::contestant},
                                    Column{"quantity", &Row::quantity},
                                    Column{"value", &Interval::median},
                                    Column{"low", &Interval::low},
                                    Column{"high", &Interval::high},
                                    Column{"runs", &Interval::runs}};

auto columns(Of of) {
    return all_columns |
           std::views::filter([of](const Column& column) { return column.of.value_or(of) == of; });
}

std::string text_at(const Row& row, const Column& column) {
    return std::visit([&](auto member) { return fmt::format("{}", in(row, member)); },
                      column.member);
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
    bool is_first = true;
    for (const Column& column : columns(of)) {
        if (!std::exchange(is_first, false)) {
            if (line.empty()) return false;
            line.remove_prefix(1);
        }
        const std::string_view field = line.substr(0, line.find(','));
        if (!std::visit([&](auto member) { return read_field(field, in(row, member)); },
                        column.member))
            return false;
        line.remove_prefix(field.size());
    }
    return line.empty();
}

/// What `write` makes of the columns, with a comma between them.
template <class Write>
std::string line_of(Of of, const Write& write, std::string_view comma) {
    std::string text;
    for (const Column& column : columns(of)) text += fmt::format("{}{}", write(column), comma);
    text.resize(text.size() - comma.size());
    return text;
}

}  // namespace

std::string text_in(const Row& row, std::string_view name) {
    const auto* const found = std::ranges::find(all_columns, name, &Column::name);
    if (found == all_columns.end())
        throw std::invalid_argument(fmt::format("there is no column {}", name));
    return text_at(row, *found);
}

std::string csv_header(Of of) {
    return line_of(
               of, [](const Column& column) { return column.name; }, ",") +
           "\n";
}

std::string csv_line(const Row& row, Of of) {
    return line_of(
               of, [&](const Column& column) { return text_at(row, column); }, ",") +
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
        const auto write = [&](const Column& column) {
            return std::visit(
                [&]<class T, class Owner>(T Owner::*member) {
                    constexpr std::string_view quote = std::is_same_v<T, std::string> ? "\"" : "";
                    return fmt::format("\"{0}\": {1}{2}{1}", column.name, quote, in(row, member));
                },
                column.member);
        };
        text += text.size() > 1 ? ",\n{" : "\n{";
        text += line_of(of, write, ", ") + "}";
    }
    return text + "\n]";
}

}  // namespace signum::study
