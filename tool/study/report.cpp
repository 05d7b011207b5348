#include "report.hpp"

#include <string_view>

#include <fmt/format.h>

#include "html.hpp"

namespace signum::study {
namespace {

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
    std::string text =
        fmt::format("{}<h1>{}</h1>\n{}", html_head(page.title + ": a study by signum"), page.title,
                    page.introduction);
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
