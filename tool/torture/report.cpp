#include "report.hpp"

#include <cmath>
#include <cstring>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace signum::torture {
namespace {

std::string hexadecimal(const Question& question) {
    std::string text;
    for (std::size_t m = 0; m < points_of(question.asked); ++m) {
        if (m > 0) text += "  ";
        for (std::size_t k = 0; k < dimension_of(question.asked); ++k)
            text += fmt::format("{}{:a}", k > 0 ? " " : "", question.point(m)[k]);
    }
    return text;
}
std::string in_words(Sign sign) {
    return sign > 0 ? "+1" : fmt::format("{}", sign);
}
std::string in_words(const Lost& lost) {
    return lost.signal == 0 ? std::string("did not come back")
                            : fmt::format("ended the process ({})", ::strsignal(lost.signal));
}
/// What there is to say about one function: its signs in a word or two.
std::string verdict_of(const Trial& trial) {
    if (trial.convention == Convention::unknown && trial.asked() == 0) return "not judged";
    if (trial.is_faultless()) return fmt::format("none of {} signs wrong", trial.asked());
    std::string text = fmt::format("{} of {} signs wrong", trial.wrong(), trial.asked());
    if (!trial.lost.empty()) text += fmt::format(", {} calls lost", trial.lost.size());
    return text;
}

nlohmann::ordered_json numbers_of(const Question& question) {
    nlohmann::ordered_json numbers = nlohmann::ordered_json::array();
    for (std::size_t k = 0; k < question.size(); ++k)
        numbers.push_back(fmt::format("{:a}", question.numbers[k]));
    return numbers;
}

/// All pixels of one sign, a stretch of a row after the other.
std::string path_of(const std::vector<std::int8_t>& signs, int sign) {
    std::string path;
    for (int row = 0; row < picture_side; ++row)
        for (int column = 0; column < picture_side;) {
            const int from = column;
            while (column < picture_side &&
                   signs[static_cast<std::size_t>(row * picture_side + column)] == sign)
                ++column;
            if (column > from)
                path += fmt::format("M{} {}h{}", from, picture_side - 1 - row, column - from);
            else
                ++column;
        }
    return path;
}
std::string picture_of(const std::vector<std::int8_t>& signs, std::string_view title) {
    return fmt::format(
        R"svg(<figure><svg viewBox="0 0 {0} {0}" width="384" height="384" role="img" )svg"
        R"svg(aria-label="{1}"><rect width="{0}" height="{0}" fill="#0072b2"/>)svg"
        R"svg(<g transform="translate(0 .5)" fill="none" shape-rendering="crispEdges">)svg"
        R"svg(<path stroke="#f0e442" d="{2}"/><path stroke="#d55e00" d="{3}"/></g></svg>)svg"
        R"svg(<figcaption>{1}</figcaption></figure>)svg",
        picture_side, title, path_of(signs, 0), path_of(signs, -1));
}
std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '<')
            result += "&lt;";
        else if (c == '&')
            result += "&amp;";
        else
            result += c;
    }
    return result;
}

}  // namespace

bool Report::is_faultless() const noexcept {
    for (const Trial& trial : trials)
        if (!trial.is_faultless()) return false;
    return true;
}

std::string in_words(const Report& report) {
    std::string text;
    for (const Asked asked : all_asked) {
        const Trial& trial = report.trials[place_of(asked)];
        if (!trial.is_there) {
            text += fmt::format("{:<9} is not in the library\n", name_of(asked));
            continue;
        }
        text += fmt::format("{:<9} {}; signs: {}\n", name_of(asked), verdict_of(trial),
                            name_of(trial.convention));
        if (trial.convention == Convention::unknown && trial.lost.empty())
            text +=
                "  is --returns right, and does it take a pointer to the coordinates of each "
                "point?\n";
        for (std::size_t family = 0; family < trial.counts.size(); ++family) {
            const Count& count = trial.counts[family];
            // Of points that somebody gave one wants to know that they were asked.
            const bool is_own = families()[family].name == own_points_name;
            if (count.wrong == 0 && !(is_own && count.asked > 0)) continue;
            text += fmt::format("  {:<14} {:>9} of {:>9} wrong", families()[family].name,
                                count.wrong, count.asked);
            if (count.not_a_number > 0) text += fmt::format(", {} NaN", count.not_a_number);
            text += "\n";
        }
        if (trial.smallest)
            text += fmt::format("  smallest: {}({}) is {}, said {:g}\n", name_of(asked),
                                hexadecimal(trial.smallest->question),
                                in_words(trial.smallest->right), trial.smallest->said);
        for (const Lost& lost : trial.lost)
            text += fmt::format("  {}({}) {}\n", name_of(asked), hexadecimal(lost.question),
                                in_words(lost));
    }
    return text;
}

std::string as_json(const Report& report) {
    nlohmann::ordered_json json;
    json["format"] = "signum.torture";
    json["version"] = 1;
    json["plugin"] = report.plugin;
    json["faultless"] = report.is_faultless();
    json["functions"] = nlohmann::ordered_json::object();
    for (const Asked asked : all_asked) {
        const Trial& trial = report.trials[place_of(asked)];
        auto& of_function = json["functions"][std::string(name_of(asked))];
        of_function["found"] = trial.is_there;
        if (!trial.is_there) continue;
        of_function["convention"] = name_of(trial.convention);
        of_function["asked"] = trial.asked();
        of_function["wrong"] = trial.wrong();
        for (std::size_t family = 0; family < trial.counts.size(); ++family) {
            const Count& count = trial.counts[family];
            if (count.asked == 0) continue;
            of_function["families"][std::string(families()[family].name)] = {
                {"asked", count.asked},
                {"wrong", count.wrong},
                {"nan", count.not_a_number},
                {"far", families()[family].is_far}};
        }
        if (trial.smallest) {
            auto& smallest = of_function["smallest"];
            smallest["numbers"] = numbers_of(trial.smallest->question);
            smallest["right"] = trial.smallest->right;
            // NaN has no number in JSON.
            if (std::isfinite(trial.smallest->said))
                smallest["said"] = trial.smallest->said;
            else
                smallest["said"] = fmt::format("{}", trial.smallest->said);
        }
        of_function["lost"] = nlohmann::ordered_json::array();
        for (const Lost& lost : trial.lost)
            of_function["lost"].push_back({{"numbers", numbers_of(lost.question)},
                                           {"family", families()[lost.family].name},
                                           {"signal", lost.signal}});
    }
    json["seconds"] = report.seconds;
    return json.dump(2) + "\n";
}

std::string as_page(const Report& report) {
    std::string page = fmt::format(
        R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>Torture of {0}</title>
<meta name="viewport" content="width=device-width">
<style>
:root {{ color-scheme: light dark }}
body {{ font: 16px/1.5 sans-serif; max-width: 60em; margin: 2em auto; padding: 0 1em }}
table {{ border-collapse: collapse }} td, th {{ padding: .2em .8em; text-align: right; border-bottom: 1px solid #8888 }}
td:first-child, th:first-child, td:last-child {{ text-align: left }}
code {{ overflow-wrap: anywhere }} figure {{ display: inline-block; margin: 0 1em 1em 0 }}
.wrong {{ color: #d55e00; font-weight: bold }} svg {{ image-rendering: pixelated }}
</style></head><body>
<h1>Torture of {0}</h1>
<p class="{1}">{2}. Each function was asked questions whose exact answer is known, for {3:.0f} s in all.</p>
)",
        escaped(report.plugin), report.is_faultless() ? "right" : "wrong",
        report.is_faultless() ? "No sign is wrong" : "Signs are wrong, or calls were lost",
        report.seconds);
    for (const Asked asked : all_asked) {
        const Trial& trial = report.trials[place_of(asked)];
        if (!trial.is_there) continue;
        page += fmt::format(
            "<h2>{}</h2>\n<p>{}. The meaning of its signs: {}.</p>\n"
            "<table><tr><th>family</th><th>asked</th><th>wrong</th><th>NaN</th>"
            "<th></th></tr>\n",
            name_of(asked), verdict_of(trial), name_of(trial.convention));
        for (std::size_t family = 0; family < trial.counts.size(); ++family) {
            const Count& count = trial.counts[family];
            if (count.asked == 0) continue;
            page += fmt::format(
                "<tr><td>{}</td><td>{}</td><td class=\"{}\">{}</td><td>{}</td><td>{}</td></tr>\n",
                families()[family].name, count.asked, count.wrong > 0 ? "wrong" : "", count.wrong,
                count.not_a_number, families()[family].says);
        }
        page += "</table>\n";
        if (trial.smallest)
            page += fmt::format(
                "<p>The simplest of the wrong answers: <code>{}({})</code> is {}, and the plugin "
                "says {:g}.</p>\n",
                name_of(asked), hexadecimal(trial.smallest->question),
                in_words(trial.smallest->right), trial.smallest->said);
        for (const Lost& lost : trial.lost)
            page += fmt::format("<p class=\"wrong\"><code>{}({})</code> {}.</p>\n", name_of(asked),
                                hexadecimal(lost.question), in_words(lost));
        if (!trial.said.empty())
            page += fmt::format(
                "<p>A point goes through 256 × 256 neighbouring doubles about a tie. Blue is "
                "positive, yellow 0, red negative.</p>\n{}{}\n",
                picture_of(trial.said, "the plugin"), picture_of(trial.right, "exactly"));
    }
    return page + "</body></html>\n";
}

}  // namespace signum::torture
