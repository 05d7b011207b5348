#include "report.hpp"

#include <string_view>

#include <fmt/format.h>

#include "html.hpp"

namespace signum::study {
namespace {

/// Before and after the title.
constexpr std::string_view before_title = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>)";
constexpr std::string_view after_title = R"(: a study by signum</title>
<style>
:root { color-scheme: light dark; --ink: #1c1e21; --paper: #fdfdfb; --soft: #5c6066; --line: #d8d8d2; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e4e4e0; --paper: #17191c; --soft: #a0a4aa; --line: #3a3d42; }
}
body { margin: 0 auto; padding: 2rem 1.2rem 5rem; max-width: 56rem; color: var(--ink);
       background: var(--paper); font: 1.05rem/1.6 Georgia, "Liberation Serif", serif; }
h1 { font-size: 2rem; line-height: 1.2; }
h2 { font-size: 1.35rem; margin-top: 3.2rem; }
p, ul, dl, table { max-width: 44rem; }
sup { line-height: 0; }
figure { margin: 1.2rem 0 0; }
img { display: block; width: 30rem; max-width: 100%; background: #fff; }
svg { display: block; width: 100%; height: auto; }
svg text, svg tspan { font-family: "Helvetica Neue", Arial, "Liberation Sans", sans-serif; }
table { border-collapse: collapse; font-size: .95rem; }
th, td { text-align: left; padding: .35rem 1rem .35rem 0; border-bottom: 1px solid var(--line);
         vertical-align: top; }
table.wide { max-width: none; font-size: .75rem; }
table.wide td { padding-right: .6rem; }
dt { font-weight: bold; margin-top: .7rem; }
dd { margin: 0; }
code { font-size: .92em; overflow-wrap: anywhere; }
.soft { color: var(--soft); }
</style>
</head>
<body>
)";

std::string account_of(const Account& account) {
    std::string text = fmt::format(
        "<h2>How this was made</h2>\n<p><code>{}</code> with signum {}, in {} of "
        "measuring. All numbers stand in <code>results.csv</code> and <code>results.json</code> "
        "beside this page, those of each pass in <code>measurements.csv</code>, the pictures and "
        "their scripts in <code>figures/</code>.</p>\n",
        html_text(account.command), html_text(account.version),
        account.seconds < 120.0 ? fmt::format("{:.0f} seconds", account.seconds)
                                : fmt::format("{:.0f} minutes", account.seconds / 60.0));
    if (account.measured < account.planned)
        text += fmt::format(
            "<p><strong>Not complete:</strong> {} of {} measurements. The same command goes "
            "on.</p>\n",
            account.measured, account.planned);
    text += "<table>\n";
    for (const auto& [name, value] : account.machine)
        text += fmt::format("<tr><th>{}</th><td>{}</td></tr>\n", html_text(name), html_text(value));
    return text + "</table>\n";
}

}  // namespace

std::string html_report(const Page& page, const Account& account) {
    std::string text = fmt::format("{}{}{}<h1>{}</h1>\n{}", before_title, page.title, after_title,
                                   page.title, page.introduction);
    for (std::size_t i = 0; i < page.figures.size(); ++i) {
        const auto& [figure, svg] = page.figures[i];
        text += fmt::format("<section id=\"{}\">\n<h2>{}. {}</h2>\n{}\n", figure.plot.name, i + 1,
                            figure.title, figure.text);
        if (!svg.empty()) text += fmt::format("<figure>\n{}\n</figure>\n", svg);
        text += "</section>\n";
    }
    return text + page.glossary + account_of(account) + "</body>\n</html>\n";
}

}  // namespace signum::study
