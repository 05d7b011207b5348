#include "figures.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "../../triangulation/metric.hpp"

namespace signum::study {
namespace {

using Names = std::vector<std::string>;

std::string text_of(const toml::table& table, std::string_view key,
                    const std::string& otherwise = "") {
    return table[key].value_or(otherwise);
}

/// The array in a table; an empty one where there is none.
const toml::array& array_in(const toml::table& table, std::string_view key) {
    static const toml::array none;
    const toml::array* const found = table.at_path(key).as_array();
    return found ? *found : none;
}

Names split(std::string_view text) {
    Names parts;
    while (!text.empty()) {
        const std::string_view part = text.substr(0, text.find(' '));
        if (!part.empty()) parts.emplace_back(part);
        text.remove_prefix(std::min(part.size() + 1, text.size()));
    }
    return parts;
}

/// Of "column:list" the column.
std::string column_of(const std::string& dimension) {
    return dimension.substr(0, dimension.find(':'));
}

/// "{column}, {column}"
std::string in_braces(const std::string& dimensions) {
    std::string text;
    for (const std::string& each : split(dimensions))
        text += fmt::format("{}{{{}}}", text.empty() ? "" : ", ", column_of(each));
    return text;
}

/// "a=1 b=2 a=3" as columns and values; of a column the last value is wanted.
Values wanted_by(std::string_view filter) {
    Values wanted;
    for (const std::string& each : split(filter)) {
        const std::size_t sign = each.find('=');
        wanted[each.substr(0, sign)] = each.substr(sign + 1);
    }
    return wanted;
}

/// An empty line begins a new line, another end of a line is a space.
std::string folded(std::string text) {
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1))
        if (text.substr(at, 2) == "\n\n")
            text.erase(at, 1);
        else
            text[at] = ' ';
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
    for (const toml::node& each : array_in(outer, array))
        all.push_back(within(outer, *each.as_table()));
    return all;
}

/// What a value of a column is called.
std::string in_words(const toml::table& spec, const std::string& column, const std::string& value) {
    if (column == "packing") return fmt::format("{:.3g} %", 100.0 * number_in(value).value());
    if (column == "size_ratio") return value == "1" ? "one size" : "1 : " + value;
    if (column == "time_step") return value == "0" ? "events" : value + " s";
    return spec["words"][value].value_or(value);
}

/// A title with the values of cells in it.
std::string title(const toml::table& spec, const std::string& words, const std::string& cells) {
    Values values = wanted_by(cells);
    for (auto& [column, value] : values) value = in_words(spec, column, value);
    return filled(words, values).value();
}

class Drawing {
 public:
    Drawing(const toml::table& page, const Records& records) : page_(page), records_(records) {}

    [[nodiscard]] std::vector<Panel> panels(const toml::table& figure) const {
        std::vector<toml::table> specs = all_within(figure, "panel");
        if (specs.empty()) specs = {figure};
        std::vector<Panel> panels;
        for (const std::string& some :
             combinations(text_of(figure, "panels"), text_of(figure, "cells")))
            for (const toml::table& spec : specs)
                panels.push_back(panel(spec, text_of(spec, "cells") + some));
        return panels;
    }

 private:
    /// Of the page; metrics are listed in their own table.
    [[nodiscard]] Names list(const std::string& name) const {
        Names names;
        if (name == "metric")
            for (const Metric metric : all_metrics) names.emplace_back(name_of(metric));
        for (const toml::node& each : array_in(page_, "lists." + name))
            names.push_back(each.value_or(""));
        return names;
    }

    /// The place of a name in the list of its column.
    [[nodiscard]] std::optional<std::size_t> place(const std::string& column,
                                                   const std::string& name) const {
        const Names names = list(column);
        const auto found = std::ranges::find(names, name);
        if (found == names.end()) return std::nullopt;
        return static_cast<std::size_t>(found - names.begin());
    }

    /// Of "column:list" the list, of "column" the values that rows have: words in the order of the
    /// list of the column's name, numbers by size.
    [[nodiscard]] Names values_of(const std::string& dimension, const std::string& cells) const {
        const std::string column = column_of(dimension);
        if (column != dimension) return list(dimension.substr(column.size() + 1));
        std::map<double, std::string> found;
        for (const Record* record : that_fit(records_, cells)) {
            const std::string value = record->columns.at(column);
            if (const auto in_list = place(column, value))
                found[static_cast<double>(*in_list)] = value;
            else if (const auto number = number_in(value))
                found[*number] = value;
        }
        Names values;
        for (const auto& [order, value] : found) values.push_back(value);
        return values;
    }

    /// A filter for each value of a column, with each of the next.
    [[nodiscard]] Names combinations(const std::string& dimensions,
                                     const std::string& cells) const {
        Names result = {""};
        for (const std::string& dimension : split(dimensions)) {
            Names longer;
            for (const std::string& some : result)
                for (const std::string& value : values_of(dimension, cells + some))
                    longer.push_back(fmt::format("{} {}={}", some, column_of(dimension), value));
            result = std::move(longer);
        }
        return result;
    }

    [[nodiscard]] Panel panel(const toml::table& spec, std::string cells) const {
        Panel panel;
        const std::string x = text_of(spec, "x");
        const bool has_categories = x.find(':') != std::string::npos;
        panel.title =
            title(spec, text_of(spec, "panel_title", in_braces(text_of(spec, "panels"))), cells);
        if (!panel.title.empty()) panel.title[0] = static_cast<char>(std::toupper(panel.title[0]));
        panel.x_label = text_of(spec, "x_label", has_categories ? "" : x);
        panel.y_label = text_of(spec, "y_label");
        const std::string log = text_of(spec, "log");
        panel.x_is_log = log.find('x') != std::string::npos;
        panel.y_is_log = log.find('y') != std::string::npos;
        if (!panel.y_is_log) panel.y_least = spec["y_least"].value_or(0.0);
        panel.stacked = spec["stacked"].value_or(false);
        if (panel.stacked) panel.y_most = 100.0;
        panel.place_of_zero = spec["zero"].value_or(0.0);
        for (const toml::node& each : array_in(spec, "uprights"))
            panel.uprights.push_back(
                {each.at_path("[0]").value_or(0.0), each.at_path("[1]").value_or(std::string())});
        Values wanted = wanted_by(cells);
        if (text_of(spec, "thesis_of", wanted["metric"]) == wanted["metric"])
            for (const toml::node& each : array_in(spec, "thesis")) {
                const double y = each.at_path("[1]").value_or(0.0);
                panel.quoted.title = "the thesis";
                panel.quoted.points.push_back({each.at_path("[0]").value_or(0.0), y, y, y});
            }

        Names categories;
        if (has_categories) categories = values_of(x, cells);
        if (spec["present"].value_or(false))
            std::erase_if(categories, [&](const std::string& name) {
                const std::string cells_of_all = text_of(spec, "cells");
                return that_fit(records_, fmt::format("{} {}={}", cells_of_all, column_of(x), name))
                    .empty();
            });
        for (const std::string& category : categories)
            panel.categories.push_back(in_words(spec, column_of(x), category));
        if (panel.stacked) {
            const Names sites = values_of("sites", cells);
            if (sites.empty()) return panel;
            cells += " sites=" + sites.back();
        }
        add_series(panel, spec, cells, categories);
        if (panel.stacked)
            make_shares(panel, points(spec,
                                      fmt::format("{} {} quantity={}", cells, text_of(spec, "rows"),
                                                  text_of(spec, "whole")),
                                      categories));
        return panel;
    }

    void add_series(Panel& panel, const toml::table& spec, const std::string& cells,
                    const Names& categories) const {
        const auto add = [&](const toml::table& of, const std::string& one, std::string name,
                             std::optional<std::size_t> style) {
            const int look = static_cast<int>(style.value_or(panel.series.size())) + 1;
            panel.series.push_back(
                {std::move(name), of["style"].value_or(look), categories.empty(),
                 points(of, fmt::format("{} {}{}", cells, text_of(of, "rows"), one), categories)});
        };
        const std::string series = text_of(spec, "series");
        if (!series.empty())
            for (const std::string& one : combinations(series, cells)) {
                const auto [column, value] = *wanted_by(one).begin();
                add(spec, one, title(spec, text_of(spec, "series_title", in_braces(series)), one),
                    place(column, value));
            }
        for (const toml::table& more : all_within(spec, "more"))
            add(more, "", text_of(more, "curve"), std::nullopt);
    }

    /// By rising x.
    [[nodiscard]] std::vector<PlotPoint> points(const toml::table& spec, const std::string& filter,
                                                const Names& categories) const {
        const std::string column = column_of(text_of(spec, "x"));
        const std::size_t prefix = wanted_by(filter)["quantity"].size() - 1;
        const auto x_of = [&](const Record& record) -> std::optional<double> {
            std::string text = record.columns.at(column);
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
        for (const Record* record : that_fit(records_, filter))
            if (const auto x = x_of(*record))
                result.push_back({*x, record->value.median, record->value.low, record->value.high});
        std::ranges::stable_sort(result, {}, &PlotPoint::x);
        double times = spec["times"].value_or(1.0);
        if (spec["a_second"] && !result.empty())
            times = static_cast<double>(result.size()) / result.back().x;
        for (PlotPoint& point : result)
            for (double PlotPoint::*y : {&PlotPoint::y, &PlotPoint::low, &PlotPoint::high})
                point.*y = times * point.*y / spec["over"].value_or(1.0);
        return result;
    }

    /// From numbers to their shares of a whole, or of all of a category where there is none.
    static void make_shares(Panel& panel, const std::vector<PlotPoint>& whole) {
        for (std::size_t i = 0; i < panel.categories.size(); ++i) {
            const auto x = static_cast<double>(i);
            const auto number = [&](const std::vector<PlotPoint>& points) {
                const auto found = std::ranges::find(points, x, &PlotPoint::x);
                return found == points.end() ? 0.0 : found->y;
            };
            double all = number(whole);
            if (whole.empty())
                for (const Series& series : panel.series) all += number(series.points);
            for (Series& series : panel.series) {
                const double y = all > 0.0 ? 100.0 * number(series.points) / all : 0.0;
                std::erase_if(series.points, [&](const PlotPoint& point) { return point.x == x; });
                series.points.insert(series.points.begin() + static_cast<std::ptrdiff_t>(i),
                                     {x, y, y, y});
            }
        }
    }

    const toml::table& page_;
    const Records& records_;
};

}  // namespace

toml::table within(const toml::table& outer, const toml::table& inner) {
    toml::table all = outer;
    for (const auto& [key, value] : inner) all.insert_or_assign(key, value);
    for (const char* key : {"cells", "rows"})
        all.insert_or_assign(key, text_of(outer, key) + " " + text_of(inner, key));
    return all;
}

std::vector<const Record*> that_fit(const Records& records, std::string_view filter) {
    const Values wanted = wanted_by(filter);
    std::vector<const Record*> found;
    const auto there = records.find(wanted.at("experiment"));
    if (there == records.end()) return found;
    for (const Record& record : there->second)
        if (std::ranges::all_of(wanted, [&](const auto& each) {
                const std::string& text = record.columns.at(each.first);
                const std::string& value = each.second;
                return value.ends_with('*')
                           ? text.compare(0, value.size() - 1, value, 0, value.size() - 1) == 0
                           : text == value;
            }))
            found.push_back(&record);
    return found;
}

std::optional<Figure> figure_of(const toml::table& page, const toml::table& figure,
                                const Records& records, const Values& values) {
    Values all = values;
    for (const auto& [key, value] : figure)
        if (value.is_string()) all.try_emplace(std::string(key.str()), value.value_or(""));
    const auto text = filled(folded(text_of(figure, "text")), all);
    if (!text) return std::nullopt;
    Figure result = {{}, text_of(figure, "title"), *text, text_of(figure, "description"), ""};
    result.plot = {
        text_of(figure, "name"), figure.contains("panel") || figure.contains("panels") ? 2 : 1, {}};
    if (!figure.contains("x") && !figure.contains("panel")) return result;
    toml::table spec = figure;
    spec.insert("cells", "experiment=" + result.plot.name);  // where nothing else is said
    result.plot.panels = Drawing(page, records).panels(spec);
    for (const Panel& panel : result.plot.panels)
        for (const Series& series : panel.series)
            if (!series.points.empty()) return result;
    return std::nullopt;
}

}  // namespace signum::study
