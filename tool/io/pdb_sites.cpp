/// Atoms of proteins. In PDB files everything has its columns; in PQR files words are separated by
/// blanks.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "molecules.hpp"
#include "number.hpp"
#include "sites_readers.hpp"

namespace signum {
namespace {

/// What both formats call an atom.
bool is_atom(std::string_view record) {
    return record.starts_with("ATOM") || record.starts_with("HETATM");
}

bool is_letter(char c) noexcept {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

/// Of several models the first one is read.
class FirstModel {
 public:
    /// Whether the line, which begins with `record`, is an atom of it. `has_begun`: one was.
    bool takes(const LineWords& lines, std::string_view record, bool has_begun) {
        if (ends_model(lines)) {
            is_over_ = has_begun;
            return false;
        }
        if (!is_atom(record)) return false;
        if (is_over_) ++others_;
        return !is_over_;
    }

    [[nodiscard]] std::int64_t others() const noexcept { return others_; }
    [[nodiscard]] std::string note() const {
        return fmt::format("{} atom{} of models after the first one", others_,
                           others_ == 1 ? "" : "s");
    }

 private:
    /// A record of its own, the next model's, or, where frames were written one after the other,
    /// the end of a file.
    static bool ends_model(const LineWords& lines) {
        return lines.size() > 0 &&
               (lines[0] == "ENDMDL" || lines[0] == "MODEL" || lines[0] == "END");
    }

    bool is_over_ = false;
    std::int64_t others_ = 0;  ///< atoms of later ones
};

bool has_letters_alone(std::string_view text) {
    return !text.empty() && std::ranges::all_of(text, is_letter);
}

class PdbSites {
 public:
    PdbSites(InputFile& file, const ReadOptions& options)
        : lines_(file,
                 "an atom of a PDB file is a line ATOM or HETATM with x, y and z in columns 31 to "
                 "54"),
          options_(options) {
        result_.dimension = 3;
        result_.third = WeightIs::radius;
    }

    SitesFile read() {
        while (lines_.next())
            if (model_.takes(lines_, lines_.line(), !result_.in_space.empty())) read_atom();
        if (result_.in_space.empty()) lines_.fail_at_end("no atom in this file");
        std::vector<std::string> notes;
        if (model_.others() + alternates_.left_out() > 0) notes.push_back(what_is_left_out());
        if (std::string guessed = guessed_.note(); !guessed.empty()) notes.push_back(guessed);
        result_.note = joined_note(lines_.path(), notes);
        return std::move(result_);
    }

 private:
    void read_atom() {
        // Places have a letter in column 17; chain, number and insertion code tell a residue.
        if (!alternates_.takes(std::string(lines_.columns(22, 27)), lines_.columns(17, 17))) return;
        check_columns();
        result_.in_space.push_back({lines_.number_in_columns(31, 38),
                                    lines_.number_in_columns(39, 46),
                                    lines_.number_in_columns(47, 54), radius()});
    }

    /// In a line whose columns are shifted a number may be cut, and its digits be another's.
    void check_columns() const {
        const auto is_cut = [&](std::size_t first) {
            return lines_.columns(first, first + 7).find(' ') != std::string_view::npos;
        };
        if (!is_cut(31) && !is_cut(39) && !is_cut(47)) return;
        lines_.fail_at_column(
            31,
            fmt::format("x, y and z are to stand in columns 31 to 38, 39 to 46 and 47 to 54, and "
                        "there stands {}; where a long number before them has moved them, move "
                        "them back",
                        in_quotes(lines_.line().substr(30, 24))));
    }

    /// Of the element in columns 77 and 78, where old files have digits; where none is, of the
    /// one that the names say.
    [[nodiscard]] double radius() {
        const std::string_view element = lines_.columns(77, 78);
        if (has_letters_alone(element)) return radius_of(element, 77, element);
        const std::string_view name = lines_.line().substr(12, 4);
        const bool begins_late = name[0] == ' ' || is_digit(name[0]);
        // Names of hydrogens that take four columns begin in the first one.
        const bool is_hydrogen = name[0] == 'H' && name.find(' ') == std::string_view::npos;
        const std::string guessed =
            element_by_name(lines_.columns(18, 21), name, !begins_late && !is_hydrogen);
        guessed_.add(guessed);
        return radius_of(guessed, 13, lines_.columns(13, 16));
    }

    [[nodiscard]] double radius_of(std::string_view element, std::size_t column,
                                   std::string_view shown) const {
        if (const auto known = radius_of_element(options_, element)) return *known;
        lines_.fail_at_column(column, no_radius_of(shown, element));
    }

    [[nodiscard]] std::string what_is_left_out() const {
        const std::int64_t places = alternates_.left_out();
        std::string note;
        if (places > 0)
            note = fmt::format("{} alternate place{} of atoms", places, places == 1 ? "" : "s");
        if (model_.others() > 0) note += (places > 0 ? " and " : "") + model_.note();
        return note + (places + model_.others() == 1 ? " is left out" : " are left out");
    }

    LineWords lines_;
    const ReadOptions& options_;
    FirstModel model_;
    AlternatePlaces alternates_;
    GuessedElements guessed_;
    SitesFile result_;
};

/// With a sign, a chain before it or an insertion code behind it, or in base 36; but no fraction.
bool is_number_of_residue(std::string_view word) {
    return std::ranges::any_of(word, is_digit) && std::ranges::all_of(word, [](char c) {
               return is_letter(c) || is_digit(c) || c == '-' || c == '+';
           });
}

/// The columns of numbers where words have grown together: x, y, z, charge and radius, eight
/// columns each from the 31st. Nothing where one of them is none.
std::optional<std::array<double, 5>> numbers_in_columns(const LineWords& lines) {
    std::array<double, 5> numbers = {};
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        const Number number = parse_number(lines.columns(31 + 8 * k, 38 + 8 * k));
        if (number.fault != NumberFault::none) return std::nullopt;
        numbers[k] = number.value;
    }
    return numbers;
}

void read_pqr_atom(const LineWords& lines, SitesFile& result) {
    constexpr std::size_t least = 10;  // record, number, name, residue, its number, 5 numbers
    constexpr std::size_t most = 11;   // and a chain
    const std::size_t size = lines.size();
    const bool are_words = size >= least && is_number_of_residue(lines[size - 6]);
    if (const auto numbers = are_words ? std::nullopt : numbers_in_columns(lines)) {
        const auto& [x, y, z, charge, radius] = *numbers;
        if (radius < 0.0) lines.fail_at_column(63, "a negative radius; write 0 or more");
        result.in_space.push_back({x, y, z, radius});
        return;
    }
    if (size < least) {
        lines.fail_at(size, fmt::format("{} words; an atom is record, number, name, residue, "
                                        "[chain,] number, x, y, z, charge, radius",
                                        size));
    }
    if (size > most) {
        lines.fail_at(most, fmt::format("{} words; an atom has no more than {}: record, number, "
                                        "name, residue, chain, number, x, y, z, charge, radius",
                                        size, most));
    }
    // A line that was cut off after the charge may still have ten words.
    if (!is_number_of_residue(lines[size - 6])) {
        lines.fail_at(size - 6, fmt::format("{} is no residue's number, which stands before the "
                                            "last five words: x, y, z, charge, radius",
                                            in_quotes(lines[size - 6])));
    }
    static_cast<void>(lines.number(size - 2));  // the charge
    add_site(result, lines, {size - 5, size - 4, size - 3, size - 1});
    if (result.first_negative) lines.fail_at(size - 1, "a negative radius; write 0 or more");
}

}  // namespace

SitesFile read_pdb_sites(InputFile& file, const ReadOptions& options) {
    return PdbSites(file, options).read();
}

SitesFile read_pqr_sites(InputFile& file) {
    LineWords lines(
        file, "an atom of a PQR file is a line ATOM or HETATM that ends in x y z charge radius");
    SitesFile result;
    result.dimension = 3;
    result.third = WeightIs::radius;
    FirstModel model;
    while (lines.next_with_words())
        if (model.takes(lines, lines[0], !result.in_space.empty())) read_pqr_atom(lines, result);
    if (result.in_space.empty()) lines.fail_at_end("no atom in this file");
    if (model.others() > 0)
        result.note = fmt::format("{}: {} {} left out", lines.path(), model.note(),
                                  model.others() == 1 ? "is" : "are");
    return result;
}

}  // namespace signum
