/// Atoms of proteins. In PDB files everything has its columns; in PQR files words are separated by
/// blanks.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "atoms.hpp"
#include "elements.hpp"
#include "line_words.hpp"

namespace signum {
namespace {

/// What both formats call an atom.
bool is_atom(const LineWords& lines) {
    return lines.line().starts_with("ATOM") || lines.line().starts_with("HETATM");
}

class PdbSites {
 public:
    explicit PdbSites(InputFile& file)
        : lines_(file,
                 "an atom of a PDB file is a line ATOM or HETATM with x, y and z in columns 31 to "
                 "54") {
        result_.dimension = 3;
        result_.third = WeightIs::radius;
    }

    SitesFile read() {
        while (lines_.next()) {
            if (lines_.line().starts_with("ENDMDL"))
                is_over_ = !result_.in_space.empty();
            else if (is_atom(lines_))
                read_atom();
        }
        if (result_.in_space.empty()) lines_.fail_at_end("no atom in this file");
        if (others_ + alternates_ > 0) note_what_is_left_out();
        return std::move(result_);
    }

 private:
    void read_atom() {
        if (is_over_) {
            ++others_;
            return;
        }
        if (is_alternate()) {
            ++alternates_;
            return;
        }
        result_.in_space.push_back({lines_.number_in_columns(31, 38),
                                    lines_.number_in_columns(39, 46),
                                    lines_.number_in_columns(47, 54), radius()});
    }

    /// Whether this is another place of the residue than the one that is read. Places have a letter
    /// in column 17. Atoms of one letter belong together: under another one the residue may even be
    /// of another type, with atoms of other names.
    bool is_alternate() {
        const std::string_view letter = lines_.columns(17, 17);
        if (letter.empty()) return false;
        const std::string residue(lines_.columns(22, 27));
        return letters_.try_emplace(residue, letter.front()).first->second != letter.front();
    }

    [[nodiscard]] double radius() const {
        if (const auto known = van_der_waals_radius(lines_.columns(77, 78))) return *known;
        const std::string_view name = lines_.line().substr(12, 4);
        const bool begins_late = name[0] == ' ' || (name[0] >= '0' && name[0] <= '9');
        // Names of hydrogens that take four columns begin in the first one.
        const bool is_hydrogen = name[0] == 'H' && name.find(' ') == std::string_view::npos;
        if (!begins_late && !is_hydrogen)
            if (const auto known = van_der_waals_radius(name.substr(0, 2))) return *known;
        if (const auto known = van_der_waals_radius(name.substr(begins_late ? 1 : 0, 1)))
            return *known;
        const std::string_view element = lines_.columns(77, 78);
        lines_.fail_at_column(
            element.empty() ? 13 : 77,
            fmt::format("no van der Waals radius is known of {}; name an element in columns 77 and "
                        "78, or give radii in a PQR file",
                        in_quotes(element.empty() ? lines_.columns(13, 16) : element)));
    }

    void note_what_is_left_out() {
        result_.note = fmt::format("{}: ", lines_.path());
        if (alternates_ > 0)
            result_.note += fmt::format("{} alternate place{} of atoms", alternates_,
                                        alternates_ == 1 ? "" : "s");
        if (others_ > 0)
            result_.note +=
                fmt::format("{}{} atom{} of models after the first one",
                            alternates_ > 0 ? " and " : "", others_, others_ == 1 ? "" : "s");
        result_.note += alternates_ + others_ == 1 ? " is left out" : " are left out";
    }

    LineWords lines_;
    bool is_over_ = false;         ///< the first model
    std::int64_t others_ = 0;      ///< atoms of later ones
    std::int64_t alternates_ = 0;  ///< places left out
    /// By chain, number and insertion code of a residue with alternate places: the letter of its
    /// first atom that has one.
    std::map<std::string, char> letters_;
    SitesFile result_;
};

class PqrSites {
 public:
    explicit PqrSites(InputFile& file)
        : lines_(
              file,
              "an atom of a PQR file is a line ATOM or HETATM that ends in x y z charge radius") {
        result_.dimension = 3;
        result_.third = WeightIs::radius;
    }

    SitesFile read() {
        while (lines_.next())
            if (is_atom(lines_)) read_atom();
        if (result_.in_space.empty()) lines_.fail_at_end("no atom in this file");
        return std::move(result_);
    }

 private:
    void read_atom() {
        constexpr std::size_t least = 10;  // record, number, name, residue, its number, 5 numbers
        const std::size_t size = lines_.size();
        if (size < least) {
            lines_.fail_at(size, fmt::format("{} words; an atom is record, number, name, residue, "
                                             "[chain,] number, x, y, z, charge, radius",
                                             size));
        }
        // A line that was cut off after the charge may still have ten words.
        if (lines_[size - 6].find_first_of("0123456789") == std::string_view::npos) {
            lines_.fail_at(size - 6,
                           fmt::format("{} is no residue's number, which stands before the "
                                       "last five words: x, y, z, charge, radius",
                                       in_quotes(lines_[size - 6])));
        }
        const Site3 site = {lines_.number(size - 5), lines_.number(size - 4),
                            lines_.number(size - 3), lines_.number(size - 1)};
        if (site.r < 0.0) lines_.fail_at(size - 1, "a negative radius; write 0 or more");
        result_.in_space.push_back(site);
    }

    LineWords lines_;
    SitesFile result_;
};

}  // namespace

SitesFile read_pdb_sites(InputFile& file) {
    return PdbSites(file).read();
}

SitesFile read_pqr_sites(InputFile& file) {
    return PqrSites(file).read();
}

}  // namespace signum
