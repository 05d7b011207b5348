#include "html.hpp"

namespace signum::study {
namespace {

constexpr std::string_view before_title = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>)";
constexpr std::string_view after_title = R"(</title>
<style>
:root { color-scheme: light dark; --ink: #1c1e21; --paper: #fdfdfb; --soft: #5c6066; --line: #d8d8d2;
        --good: #00704a; --bad: #b3261e; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e4e4e0; --paper: #17191c; --soft: #a0a4aa; --line: #3a3d42;
          --good: #4cc38a; --bad: #ff8a80; }
}
body { margin: 0 auto; padding: 2rem 1.2rem 5rem; max-width: 56rem; color: var(--ink);
       background: var(--paper); font: 1.05rem/1.6 Georgia, "Liberation Serif", serif; }
h1 { font-size: 2rem; line-height: 1.2; }
h2 { font-size: 1.35rem; margin-top: 3.2rem; }
p, ul, dl, table { max-width: 44rem; }
sup { line-height: 0; }
figure { margin: 1.2rem 0 0; }
img { display: block; width: 30rem; max-width: 100%; background: #fff; }
figure > svg { display: block; width: 100%; height: auto; }
svg text, svg tspan { font-family: "Helvetica Neue", Arial, "Liberation Sans", sans-serif; }
table { border-collapse: collapse; font-size: .95rem; }
th, td { text-align: left; padding: .35rem 1rem .35rem 0; border-bottom: 1px solid var(--line);
         vertical-align: top; }
table.wide { max-width: none; font-size: .75rem; }
table.wide td { padding-right: .6rem; }
dt { font-weight: bold; margin-top: .7rem; }
dd { margin: 0; }
pre { font-size: .85rem; overflow-x: auto; }
code { font-size: .92em; overflow-wrap: anywhere; }
.film > svg { max-width: 46rem; max-height: 90vh; }
.run { max-width: none; }
.run td { overflow-wrap: anywhere; }
.good { color: var(--good); } .not_good { color: var(--bad); font-weight: bold; }
.good, .not_good, .not_told { white-space: nowrap; }
.soft { color: var(--soft); }
</style>
</head>
<body>
)";

}  // namespace

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

std::string html_head(std::string_view title) {
    std::string text(before_title);
    text += title;
    text += after_title;
    return text;
}

}  // namespace signum::study
