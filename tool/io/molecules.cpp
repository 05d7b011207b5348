#include "molecules.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/format.h>

#include "elements.hpp"
#include "nearest_word.hpp"

namespace signum {
namespace {

bool is_ascii_letter(char c) noexcept {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

/// The letters of a name, in small ones, without digits and signs: na of Na+, zn of ZN2.
std::string letters_of(std::string_view name) {
    std::string letters;
    for (const char c : name)
        if (is_ascii_letter(c)) letters += c;
    return in_small_letters(letters);
}

/// Ions as force fields call them, whose names say less than a symbol: those of CHARMM, then of
/// Amber.
struct Ion {
    std::string_view name;
    std::string_view element;
};
constexpr auto ions = std::to_array<Ion>({{"sod", "Na"},
                                          {"pot", "K"},
                                          {"cla", "Cl"},
                                          {"cal", "Ca"},
                                          {"ces", "Cs"},
                                          {"lit", "Li"},
                                          {"rub", "Rb"},
                                          {"bar", "Ba"},
                                          {"cad", "Cd"},
                                          {"cio", "Na"},
                                          {"ip", "Na"},
                                          {"im", "Cl"}});

/// Residues of amino acids, nucleotides and water, whose atoms are of H, C, N, O, P, S and Se
/// alone: the first letter tells.
bool has_light_atoms_alone(std::string_view residue) {
    constexpr auto residues = std::to_array<std::string_view>(
        {"ala", "arg", "asn", "asp", "asx", "cys", "gln", "glu", "glx", "gly", "his", "ile", "leu",
         "lys", "met", "phe", "pro", "ser", "thr", "trp", "tyr", "val", "mse", "sec", "pyl", "unk",
         // by their protons and bridges
         "hid", "hie", "hip", "hsd", "hse", "hsp", "cyx", "cym", "ash", "glh", "lyn",
         // ends of chains
         "ace", "nme", "nma", "nh", "pca",
         // nucleotides
         "a", "c", "g", "u", "t", "i", "da", "dc", "dg", "dt", "di", "ra", "rc", "rg", "ru", "ade",
         "cyt", "gua", "thy", "ura",
         // water
         "hoh", "wat", "dod", "ho", "tip", "tipp", "sol", "spc", "spce"});
    return std::ranges::count(residues, letters_of(residue)) > 0;
}

/// With a capital first letter.
std::string symbol(std::string_view letters) {
    std::string result = in_small_letters(letters);
    if (!result.empty())
        result[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(result[0])));
    return result;
}

}  // namespace

bool AlternatePlaces::takes(const std::string& residue, std::string_view letter) {
    if (letter.empty()) return true;
    if (letters_.try_emplace(residue, letter).first->second == letter) return true;
    ++left_out_;
    return false;
}

std::string element_by_name(std::string_view residue, std::string_view name, bool may_have_two) {
    const std::string letters = letters_of(name);
    if (letters == letters_of(residue)) {
        const auto ion = std::ranges::find(ions, letters, &Ion::name);
        if (ion != ions.end()) return std::string(ion->element);
        if (is_element(letters)) return symbol(letters);
    }
    // Up to the first digit behind them: C of C210, and of 1HB the H.
    const auto begin = std::ranges::find_if(name, is_ascii_letter);
    const auto end = std::find_if_not(begin, name.end(), is_ascii_letter);
    const std::string_view word(begin, end);
    if (has_light_atoms_alone(residue)) {
        const bool is_selenium = in_small_letters(word.substr(0, 2)) == "se" &&
                                 (letters_of(residue) == "mse" || letters_of(residue) == "sec");
        return symbol(word.substr(0, is_selenium ? 2 : 1));
    }
    const bool has_two = may_have_two && word.size() >= 2 && is_element(word.substr(0, 2));
    return symbol(word.substr(0, has_two ? 2 : 1));
}

std::string GuessedElements::note() const {
    if (counts_.empty()) return {};
    std::int64_t atoms = 0;
    std::vector<std::string> parts;
    for (const auto& [element, count] : counts_) {
        atoms += count;
        parts.push_back(fmt::format("{} {}", count, element));
    }
    return fmt::format("{} atom{} no element, and {} taken by name and residue for one: {}", atoms,
                       atoms == 1 ? " names" : "s name", atoms == 1 ? "is" : "are",
                       fmt::join(parts, ", "));
}

std::optional<double> radius_of_element(const ReadOptions& options, std::string_view element) {
    const auto chosen = options.radii.find(in_small_letters(element));
    if (chosen != options.radii.end()) return chosen->second;
    return van_der_waals_radius(element);
}

std::string no_radius_of(std::string_view shown, std::string_view element) {
    return fmt::format(
        "no van der Waals radius is known of {}; give one, as in --radius {}=2.1, or "
        "radii of all atoms in a PQR file",
        in_quotes(shown), element.empty() ? "X" : symbol(element));
}

std::string joined_note(const std::string& path, const std::vector<std::string>& notes) {
    return notes.empty() ? std::string() : fmt::format("{}: {}", path, fmt::join(notes, "; "));
}

}  // namespace signum
