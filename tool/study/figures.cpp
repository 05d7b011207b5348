#include "figures.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

namespace signum::study {
namespace {

using Names = std::vector<std::string>;

std::string text_of(const toml::table& table, std::string_view key) {
    return table[key].value_or(std::string());
}

Names names_of(const toml::node_view<const toml::node>& array) {
    Names names;
    if (const toml::array* all = array.as_array())
        for (const toml::node& name : *all) names.push_back(name.value_or(std::string()));
    return names;
}

Names split(std::string_view text, char at) {
    Names parts;
    while (!text.empty()) {
        const std::string_view part = text.substr(0, text.find(at));
        if (!part.empty()) parts.emplace_back(part);
        text.remove_prefix(std::min(part.size() + 1, text.size()));
    }
    return parts;
}

/// Of "column:list" the column.
std::string head_of(const std::string& dimension) {
    return dimension.substr(0, dimension.find(':'));
}

/// "a=1 b=2 a=3": of a column the last value is wanted.
class Filter {
 public:
    explicit Filter(std::string_view text) {
        for (const std::string& each : split(text, ' ')) {
            const std::size_t sign = each.find('=');
            value_of(each.substr(0, sign)) = each.substr(sign + 1);
        }
    }
    [[nodiscard]] bool fits(const Row& row) const {
        return std::ranges::all_of(wanted, [&](const auto& each) {
            const auto& [column, value] = each;
            const std::string text = text_in(row, column);
            return value.ends_with('*') ? text.starts_with(value.substr(0, value.size() - 1))
                                        : text == value;
        });
    }
    std::string& value_of(const std::string& column) {
        const auto found = std::ranges::find(wanted, column, &Wanted::first);
        return found != wanted.end() ? found->second : wanted.emplace_back(column, "").second;
    }

    using Wanted = std::pair<std::string, std::string>;
    std::vector<Wanted> wanted;
};

/// An empty line begins a new line, another end of a line is a space.
std::string folded(std::string text) {
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1)) {
        if (text.substr(at, 2) == "\n\n")
            text.erase(at, 1);
        else
            text[at] = ' ';
    }
    return text;
}

std::optional<double> number_in(std::string_view text) {
    double number = 0.0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (fault != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return number;
}

/// The tables of an array in a table, each within this one.
std::vector<toml::table> all_within(const toml::table& outer, std::string_view array) {
    std::vector<toml::table> all;
    if (const toml::array* inner = outer[array].as_array())
        for (const toml::node& each : *inner) all.push_back(within(outer, *each.as_table()));
    return all;
}

class Drawing {
 public:
    Drawing(const toml::table& page, const std::vector<Row>& rows) : page_(page), rows_(rows) {}

    [[nodiscard]] Plot plot(const toml::table& figure) const {
        Plot plot{text_of(figure, "name"), figure["columns"].value_or(1), {}};
        const std::string cells = text_of(figure, "cells");
        std::vector<toml::table> panels = all_within(figure, "panel");
        if (panels.empty()) panels = {figure};
        for (const std::string& some : combinations(text_of(figure, "panels"), cells))
            for (const toml::table& spec : panels)
                plot.panels.push_back(panel(spec, text_of(spec, "cells") + some));
        return plot;
    }

 private:
    /// What a value of a column is called.
    static std::string in_words(const toml::table& spec, const std::string& column,
                                const std::string& value) {
        if (column == "packing") return fmt::format("{:.3g} %", 100.0 * number_in(value).value());
        if (column == "size_ratio") return value == "1" ? "one size" : "1 : " + value;
        if (column == "time_step") return value == "0" ? "events" : value + " s";
        return spec["words"][value].value_or(value);
    }

    /// The place of a name in a list of the page.
    [[nodiscard]] std::optional<std::size_t> place(const std::string& list,
                                                   const std::string& name) const {
        const Names names = names_of(page_["lists"][list]);
        const auto found = std::ranges::find(names, name);
        if (found == names.end()) return std::nullopt;
        return static_cast<std::size_t>(found - names.begin());
    }

    /// Of "column:list" the list, of "column" the values that rows have: words in the order of the
    /// list of the column's name, numbers by size.
    [[nodiscard]] Names values_of(const std::string& dimension, const std::string& cells) const {
        const Names parts = split(dimension, ':');
        if (parts.size() > 1) return names_of(page_["lists"][parts[1]]);
        std::map<double, std::string> found;
        for (const Row* row : rows_that_fit(rows_, cells)) {
            const std::string value = text_in(*row, parts[0]);
            const auto place_in_list = place(parts[0], value);
            const auto order =
                place_in_list ? std::optional<double>(*place_in_list) : number_in(value);
            if (order) found[*order] = value;
        }
        Names values;
        for (const auto& [order, value] : found) values.push_back(value);
        return values;
    }

    /// A filter for each value of a column, with each of the next.
    [[nodiscard]] Names combinations(const std::string& dimensions,
                                     const std::string& cells) const {
        if (dimensions.empty()) return {""};
        Names result;
        const std::string first = dimensions.substr(0, dimensions.find(' '));
        const std::string rest = dimensions.substr(std::min(first.size() + 1, dimensions.size()));
        for (const std::string& value : values_of(first, cells)) {
            const std::string one = fmt::format(" {}={}", head_of(first), value);
            for (const std::string& more : combinations(rest, cells + one))
                result.push_back(one + more);
        }
        return result;
    }

    [[nodiscard]] Panel panel(const toml::table& spec, const std::string& cells) const {
        Panel panel;
        panel.title = title(spec, "panel_title", cells);
        panel.x_label = text_of(spec, "x_label");
        panel.y_label = text_of(spec, "y_label");
        const std::string log = text_of(spec, "log");
        panel.x_is_log = log.find('x') != std::string::npos;
        panel.y_is_log = log.find('y') != std::string::npos;
        panel.y_least = spec["y_least"].value_or(panel.y_least);
        panel.y_most = spec["y_most"].value_or(panel.y_most);
        panel.place_of_zero = spec["zero"].value_or(0.0);
        panel.stacked = spec["stacked"].value_or(false);
        if (const toml::array* uprights = spec["uprights"].as_array())
            for (const toml::node& each : *uprights) {
                const toml::array& upright = *each.as_array();
                panel.uprights.push_back(
                    {upright[0].value_or(0.0), upright[1].value_or(std::string())});
            }
        const std::string thesis_of = text_of(spec, "thesis_of");
        const toml::array* thesis = spec["thesis"].as_array();
        if (thesis && (thesis_of.empty() || Filter(cells).value_of("metric") == thesis_of)) {
            panel.quoted.title = "the thesis";
            for (const toml::node& each : *thesis) {
                const double y = each.as_array()->get(1)->value_or(0.0);
                panel.quoted.points.push_back({each.as_array()->get(0)->value_or(0.0), y, y, y});
            }
        }
        const Names categories = categories_of(spec);
        const std::string x = text_of(spec, "x");
        for (const std::string& category : categories)
            panel.categories.push_back(in_words(spec, head_of(x), category));
        add_series(panel, spec, cells, categories);
        if (panel.stacked) make_shares(panel, spec, cells, categories);
        return panel;
    }

    /// The names of a list along the axis of x; empty where x is a number.
    [[nodiscard]] Names categories_of(const toml::table& spec) const {
        const Names x = split(text_of(spec, "x"), ':');
        if (x.size() < 2) return {};
        Names names = names_of(page_["lists"][x[1]]);
        if (spec["present"].value_or(false))
            std::erase_if(names, [&](const std::string& name) {
                return rows_that_fit(rows_,
                                     fmt::format("{} {}={}", text_of(spec, "cells"), x[0], name))
                    .empty();
            });
        return names;
    }

    void add_series(Panel& panel, const toml::table& spec, const std::string& cells,
                    const Names& categories) const {
        const auto add = [&](const toml::table& of, const std::string& one, std::string name,
                             std::optional<std::size_t> style) {
            const int look = static_cast<int>(style.value_or(panel.series.size())) + 1;
            panel.series.push_back(
                {std::move(name), of["style"].value_or(look), categories.empty(),
                 points(of, fmt::format("{} {} {}", cells, text_of(of, "rows"), one), categories)});
        };
        const std::string dimensions = text_of(spec, "series");
        const std::string column = head_of(dimensions);
        if (!dimensions.empty())
            for (const std::string& one : combinations(dimensions, cells)) {
                const std::string name = Filter(one).value_of(column);
                add(spec, one,
                    spec.contains("series_title") ? title(spec, "series_title", one)
                                                  : in_words(spec, column, name),
                    place(column, name));
            }
        for (const toml::table& more : all_within(spec, "more"))
            add(more, "", text_of(more, "curve"), std::nullopt);
    }

    /// A title with the values of its cells in it.
    static std::string title(const toml::table& spec, std::string_view key,
                             const std::string& cells) {
        Values values;
        for (const auto& [column, value] : Filter(cells).wanted) {
            values[column] = in_words(spec, column, value);
            std::string name = column;
            std::string capital = value;
            for (std::string* text : {&name, &capital})
                (*text)[0] = static_cast<char>(std::toupper((*text)[0]));
            values[name] = capital;
        }
        return filled(text_of(spec, key), values).value();
    }

    /// By rising x.
    [[nodiscard]] std::vector<PlotPoint> points(const toml::table& spec, const std::string& filter,
                                                const Names& categories) const {
        const std::string x = text_of(spec, "x");
        const std::string column = head_of(x);
        const std::size_t prefix = Filter(filter).value_of("quantity").size() - 1;
        const auto x_of = [&](const Row& row) -> std::optional<double> {
            std::string text = text_in(row, column);
            if (!categories.empty()) {
                const auto found = std::ranges::find(categories, text);
                if (found == categories.end()) return std::nullopt;
                return static_cast<double>(found - categories.begin());
            }
            if (column == "quantity") text.erase(0, prefix);
            if (spec["zero"] && text == "ties") return spec["zero"].value<double>();
            auto number = number_in(text);
            if (number && spec["decades"])
                number = std::pow(10.0, std::round(std::log10(*number)) - 0.5);
            if (number) *number *= spec["x_times"].value_or(1.0);
            return number;
        };
        std::vector<PlotPoint> result;
        for (const Row* row : rows_that_fit(rows_, filter))
            if (const auto at = x_of(*row)) {
                const double times = spec["times"].value_or(1.0);
                const double over = spec["over"].value_or(1.0);
                const auto scaled = [&](double y) { return times * y / over; };
                result.push_back({*at, scaled(row->value.median), scaled(row->value.low),
                                  scaled(row->value.high)});
            }
        std::ranges::stable_sort(result, {}, &PlotPoint::x);
        if (spec["a_second"] && !result.empty()) {
            const double rate = static_cast<double>(result.size()) / result.back().x;
            for (PlotPoint& point : result)
                point = {point.x, rate * point.y, rate * point.low, rate * point.high};
        }
        return result;
    }

    /// A number a category for every series, of the most sites; then their shares.
    void make_shares(Panel& panel, const toml::table& spec, const std::string& cells,
                     const Names& categories) const {
        const auto number = [&](const std::string& filter, const std::string& count) {
            const auto found = rows_that_fit(rows_, fmt::format("{} {}", filter, count));
            return found.empty() ? 0.0 : found[0]->value.median;
        };
        std::int64_t most = 0;
        const auto there = rows_that_fit(rows_, cells);
        if (there.empty()) return;
        for (const Row* row : there) most = std::max(most, row->setting.count);
        const std::string column = split(text_of(spec, "x"), ':')[0];
        for (std::size_t i = 0; i < categories.size(); ++i) {
            const std::string here =
                fmt::format("{} {}={} sites={} ", cells, column, categories[i], most);
            std::vector<double> parts;
            for (const toml::table& more : all_within(spec, "more"))
                parts.push_back(number(here, text_of(more, "rows")));
            const double all = spec["whole"] ? number(here, "quantity=" + text_of(spec, "whole"))
                                             : std::accumulate(parts.begin(), parts.end(), 0.0);
            for (std::size_t s = 0; s < parts.size(); ++s) {
                const double y = all > 0.0 ? 100.0 * parts[s] / all : 0.0;
                panel.series[s].points.resize(categories.size());
                panel.series[s].points[i] = {static_cast<double>(i), y, y, y};
            }
        }
    }

    const toml::table& page_;
    const std::vector<Row>& rows_;
};

}  // namespace

toml::table within(const toml::table& outer, const toml::table& inner) {
    toml::table all = outer;
    for (const auto& [key, value] : inner) all.insert_or_assign(key, value);
    for (const char* key : {"cells", "rows"})
        all.insert_or_assign(key, text_of(outer, key) + " " + text_of(inner, key));
    return all;
}

std::vector<const Row*> rows_that_fit(const std::vector<Row>& rows, std::string_view filter) {
    const Filter wanted(filter);
    std::vector<const Row*> found;
    for (const Row& row : rows)
        if (wanted.fits(row)) found.push_back(&row);
    return found;
}

std::optional<Figure> figure_of(const toml::table& page, const toml::table& figure,
                                const std::vector<Row>& rows, const Values& values) {
    Values all = values;
    for (const auto& [key, value] : figure)
        if (value.is_string()) all.try_emplace(std::string(key.str()), value.value_or(""));
    const auto text = filled(folded(text_of(figure, "text")), all);
    if (!text) return std::nullopt;
    Figure result = {{}, text_of(figure, "title"), *text, text_of(figure, "description"), ""};
    result.plot.name = text_of(figure, "name");
    if (!figure.contains("cells")) return result;
    result.plot = Drawing(page, rows).plot(figure);
    for (const Panel& panel : result.plot.panels)
        for (const Series& series : panel.series)
            if (!series.points.empty()) return result;
    return std::nullopt;
}

}  // namespace signum::study
