/// Atoms of CIF, the syntax of which gemmi reads; the numbers are read here, to the nearest double.

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#ifdef SIGNUM_WITH_GEMMI
#include <gemmi/cif.hpp>
#endif

#include "molecules.hpp"
#include "number.hpp"
#include "sites_readers.hpp"

namespace signum {

#ifdef SIGNUM_WITH_GEMMI

namespace {

namespace cif = gemmi::cif;

/// The words of CIF for "unknown" and "none" are none.
std::string text_of(const std::string& value) {
    return cif::is_null(value) ? std::string() : cif::as_string(value);
}

class CifSites {
 public:
    CifSites(InputFile& file, const ReadOptions& options) : file_(file), options_(options) {
        result_.dimension = 3;
        result_.third = WeightIs::radius;
    }

    SitesFile read() {
        cif::Document document = parsed();
        std::vector<std::string> notes;
        for (cif::Block& block : document.blocks) {
            if (block.has_tag("_atom_site_fract_x"))
                throw InputError(file_.path(),
                                 "this CIF places the atoms that symmetry leaves in fractions of a "
                                 "crystal's cell, which is not read; give all atoms of the cell as "
                                 "PDB, XYZ or mmCIF");
            if (!block.has_tag("_atom_site.Cartn_x")) continue;
            read_atoms(block, notes);
            break;
        }
        if (result_.in_space.empty())
            throw InputError(
                file_.path(),
                "no atom in this file: no loop with _atom_site.Cartn_x, as mmCIF has it");
        if (std::string guessed = guessed_.note(); !guessed.empty()) notes.push_back(guessed);
        result_.note = joined_note(file_.path(), notes);
        return std::move(result_);
    }

 private:
    cif::Document parsed() {
        std::string text;
        for (std::string_view block = file_.next_block(); !block.empty();
             block = file_.next_block())
            text += block;
        try {
            return cif::read_memory(text.data(), text.size(), file_.path().c_str());
        } catch (const std::exception& error) {
            // It begins with the place.
            throw placed(error.what(), file_.path());
        }
    }

    /// gemmi's message, which begins with file, line and column.
    static InputError placed(std::string_view message, const std::string& path) {
        if (message.starts_with(path + ":")) message.remove_prefix(path.size() + 1);
        Position place = {1, 1};
        const auto number = [&](std::int64_t& into) {
            const std::size_t end = message.find_first_not_of("0123456789");
            const auto value = parse_whole_number(message.substr(0, end));
            if (!value || end == std::string_view::npos) return;
            into = static_cast<std::int64_t>(*value);
            message.remove_prefix(end + 1);
        };
        number(place.line);
        number(place.column);
        message.remove_prefix(
            std::min(message.find_first_not_of("0123456789():, "), message.size()));
        return {path, place, fmt::format("{}; this is no CIF", message)};
    }

    [[nodiscard]] double coordinate(std::string_view tag, std::string value,
                                    const std::string& atom) const {
        // Behind a number its uncertainty may stand: 1.234(5).
        if (value.ends_with(')')) value.resize(value.find('('));
        const Number number = parse_number(value);
        if (number.fault == NumberFault::none) return number.value;
        throw InputError(file_.path(), fmt::format("atom {}: {}: {}", atom, tag,
                                                   value.empty() ? std::string("no number")
                                                                 : explain(number.fault, value)));
    }

    [[nodiscard]] double radius(std::string_view element, const std::string& atom) const {
        if (const auto known = radius_of_element(options_, element)) return *known;
        throw InputError(file_.path(),
                         fmt::format("atom {}: {}", atom, no_radius_of(element, element)));
    }

    void read_atoms(cif::Block& block, std::vector<std::string>& notes) {
        enum : std::size_t {
            id,
            x,
            y,
            z,
            symbol,
            name,
            residue,
            letter,
            model,
            chain,
            number,
            code
        };
        cif::Table table = block.find(
            "_atom_site.", {"id", "Cartn_x", "Cartn_y", "Cartn_z", "?type_symbol", "?label_atom_id",
                            "?label_comp_id", "?label_alt_id", "?pdbx_PDB_model_num",
                            "?auth_asym_id", "?auth_seq_id", "?pdbx_PDB_ins_code"});
        AlternatePlaces alternates;
        std::int64_t of_other_models = 0;
        std::string first_model;
        bool has_begun = false;
        for (cif::Table::Row row : table) {
            const auto text = [&](std::size_t column) {
                return row.has(column) ? text_of(row[column]) : std::string();
            };
            if (!std::exchange(has_begun, true)) first_model = text(model);
            if (text(model) != first_model) {
                ++of_other_models;
                continue;
            }
            if (!alternates.takes(text(chain) + ' ' + text(number) + text(code), text(letter)))
                continue;
            const std::string atom = text(id);
            std::string element = text(symbol);
            if (element.empty() || element == "X") {
                element = element_by_name(text(residue), text(name), false);
                guessed_.add(element);
            }
            result_.in_space.push_back(
                {coordinate("Cartn_x", text(x), atom), coordinate("Cartn_y", text(y), atom),
                 coordinate("Cartn_z", text(z), atom), radius(element, atom)});
        }
        if (alternates.left_out() > 0)
            notes.push_back(fmt::format("{} alternate place{} of atoms left out",
                                        alternates.left_out(),
                                        alternates.left_out() == 1 ? "" : "s"));
        if (of_other_models > 0)
            notes.push_back(fmt::format("{} atom{} of models after the first one left out",
                                        of_other_models, of_other_models == 1 ? "" : "s"));
    }

    InputFile& file_;
    const ReadOptions& options_;
    GuessedElements guessed_;
    SitesFile result_;
};

}  // namespace

SitesFile read_cif_sites(InputFile& file, const ReadOptions& options) {
    return CifSites(file, options).read();
}

#else

SitesFile read_cif_sites(InputFile& file, const ReadOptions& /*options*/) {
    throw InputError(
        file.path(),
        "this build reads no CIF, for it was made without gemmi; build it with "
        "gemmi's headers (Debian: gemmi-dev, tao-pegtl-dev), or give the atoms as PDB, PQR "
        "or XYZ");
}

#endif

}  // namespace signum
