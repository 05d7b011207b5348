#include "template.hpp"

#include <cctype>

#include <fmt/format.h>

#include "figures.hpp"

namespace signum::study {
namespace {

/// The name between braces at the head of the text; empty where there is none.
std::string_view name_at(std::string_view text) {
    std::size_t end = 1;
    while (end < text.size() && (std::isalnum(text[end]) || text[end] == '_')) ++end;
    return end < text.size() && text[end] == '}' ? text.substr(1, end - 1) : std::string_view();
}

}  // namespace

std::optional<std::string> filled(std::string_view text, const Values& values) {
    std::string result;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const std::string_view name = text[at] == '{' ? name_at(text.substr(at)) : "";
        if (!name.empty()) {
            const auto found = values.find(std::string(name));
            if (found == values.end()) return std::nullopt;
            result += found->second;
            at += name.size() + 1;
        } else if (text[at] == '[') {
            Values there = values;
            std::erase_if(there, [](const auto& value) { return value.second.empty(); });
            const std::size_t end = text.find(']', at);
            result += filled(text.substr(at + 1, end - at - 1), there).value_or("");
            at = end;
        } else {
            result += text[at];
        }
    }
    return result;
}

std::string html_of(std::string_view name, const Values& values) {
    return filled(page_table("html")[name].value_or(""), values).value();
}

std::string html_text(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '"')
            result += "&quot;";
        else
            result += c;
    }
    return result;
}

std::string table_line(const std::vector<std::string>& cells, std::string_view first,
                       std::string_view others) {
    std::string text = "<tr>";
    for (const std::string& cell : cells)
        text += fmt::format("<{0}>{1}</{0}>", &cell == &cells.front() ? first : others, cell);
    return text + "</tr>\n";
}

}  // namespace signum::study
