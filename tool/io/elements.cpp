#include "elements.hpp"

#include <algorithm>
#include <array>

namespace signum {
namespace {

struct ElementRadius {
    std::string_view symbol;
    double radius;
};

/// By Bondi, then by Mantina and others, last by Alvarez.
constexpr std::array known_radii = std::to_array<ElementRadius>(
    {{"H", 1.20},  {"D", 1.20},  {"He", 1.40}, {"Li", 1.82}, {"C", 1.70},  {"N", 1.55},
     {"O", 1.52},  {"F", 1.47},  {"Ne", 1.54}, {"Na", 2.27}, {"Mg", 1.73}, {"Si", 2.10},
     {"P", 1.80},  {"S", 1.80},  {"Cl", 1.75}, {"Ar", 1.88}, {"K", 2.75},  {"Ni", 1.63},
     {"Cu", 1.40}, {"Zn", 1.39}, {"Ga", 1.87}, {"As", 1.85}, {"Se", 1.90}, {"Br", 1.85},
     {"Kr", 2.02}, {"Pd", 1.63}, {"Ag", 1.72}, {"Cd", 1.58}, {"In", 1.93}, {"Sn", 2.17},
     {"Te", 2.06}, {"I", 1.98},  {"Xe", 2.16}, {"Pt", 1.75}, {"Au", 1.66}, {"Hg", 1.55},
     {"Tl", 1.96}, {"Pb", 2.02}, {"U", 1.86},  {"Be", 1.53}, {"B", 1.92},  {"Al", 1.84},
     {"Ca", 2.31}, {"Ge", 2.11}, {"Rb", 3.03}, {"Sr", 2.49}, {"Sb", 2.06}, {"Cs", 3.43},
     {"Ba", 2.68}, {"Bi", 2.07}, {"V", 2.42},  {"Cr", 2.45}, {"Mn", 2.45}, {"Fe", 2.44},
     {"Co", 2.40}, {"Po", 1.97}, {"At", 2.02}, {"Rn", 2.20}, {"Fr", 3.48}, {"Ra", 2.83},
     {"Sc", 2.58}, {"Ti", 2.46}, {"Y", 2.75},  {"Zr", 2.52}, {"Nb", 2.56}, {"Mo", 2.45},
     {"Tc", 2.44}, {"Ru", 2.46}, {"Rh", 2.44}, {"La", 2.98}, {"Ce", 2.88}, {"Pr", 2.92},
     {"Nd", 2.95}, {"Sm", 2.90}, {"Eu", 2.87}, {"Gd", 2.83}, {"Tb", 2.79}, {"Dy", 2.87},
     {"Ho", 2.81}, {"Er", 2.83}, {"Tm", 2.79}, {"Yb", 2.80}, {"Lu", 2.74}, {"Hf", 2.63},
     {"Ta", 2.53}, {"W", 2.57},  {"Re", 2.49}, {"Os", 2.48}, {"Ir", 2.41}, {"Ac", 2.80},
     {"Th", 2.93}});

/// Those without a radius: who names one must not be given that of its first letter.
constexpr auto without_radius = std::to_array<std::string_view>(
    {"Pm", "Pa", "Np", "Pu", "Am", "Cm", "Bk", "Cf", "Es", "Fm", "Md", "No", "Lr", "Rf",
     "Db", "Sg", "Bh", "Hs", "Mt", "Ds", "Rg", "Cn", "Nh", "Fl", "Mc", "Lv", "Ts", "Og"});

char capital(char c) noexcept {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

bool is_same_symbol(std::string_view a, std::string_view b) noexcept {
    return std::ranges::equal(a, b, {}, capital, capital);
}

}  // namespace

std::optional<double> van_der_waals_radius(std::string_view element) noexcept {
    for (const auto& [symbol, radius] : known_radii)
        if (is_same_symbol(symbol, element)) return radius;
    return std::nullopt;
}

bool is_element(std::string_view symbol) noexcept {
    return van_der_waals_radius(symbol) ||
           std::ranges::any_of(without_radius,
                               [&](std::string_view each) { return is_same_symbol(each, symbol); });
}

}  // namespace signum
