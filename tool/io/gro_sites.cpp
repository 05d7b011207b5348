/// Atoms of GROMACS' .gro files: columns whose width the first atom's points tell.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "molecules.hpp"
#include "number.hpp"
#include "sites_readers.hpp"

namespace signum {
namespace {

constexpr double angstrom_in_nanometres = 0.1;

class GroSites {
 public:
    GroSites(InputFile& file, const ReadOptions& options)
        : lines_(file,
                 "a GRO file is a title, the number of atoms, a line each with x, y and z from "
                 "column 21 on, and the box"),
          options_(options) {
        result_.dimension = 3;
        result_.third = WeightIs::radius;
    }

    SitesFile read() {
        std::int64_t frames = 0;
        for (; lines_.next() && !(frames > 0 && lines_.size() == 0); ++frames) read_frame();
        if (result_.in_space.empty()) lines_.fail_at_end("no atom in this file");
        std::vector<std::string> notes;
        if (frames > 1) notes.push_back(fmt::format("of {} frames the last one is read", frames));
        notes.push_back(guessed_.note());
        notes.emplace_back("lengths, radii among them, are nanometres");
        notes.emplace_back("the periodic box is left out, and the atoms are in all of space");
        result_.note = joined_note(lines_.path(), notes);
        return std::move(result_);
    }

 private:
    /// Stands at the title.
    void read_frame() {
        if (!lines_.next()) lines_.fail_at_end("the file ends within a frame");
        const auto atoms =
            lines_.size() == 1 ? parse_whole_number(lines_[0]) : std::optional<std::uint64_t>();
        if (!atoms) lines_.fail_at(0, "the number of atoms stands alone in the second line");
        result_.in_space.clear();
        guessed_ = {};
        for (std::uint64_t i = 0; i < *atoms; ++i) {
            if (!lines_.next())
                lines_.fail_at_end(fmt::format("the file ends after {} of {} atoms", i, *atoms));
            read_atom();
        }
        if (!lines_.next()) lines_.fail_at_end("the file ends before the box");
    }

    /// Residue's number, its name, the atom's name and number, five columns each; then numbers with
    /// as many digits as the file has.
    void read_atom() {
        constexpr std::size_t start = 21;
        const std::string_view line = lines_.line();
        const std::size_t first = line.find('.', start - 1);
        const std::size_t second =
            first == std::string_view::npos ? first : line.find('.', first + 1);
        if (second == std::string_view::npos)
            lines_.fail_at_column(
                std::min(start, line.size() + 1),
                "an atom without x, y and z from column 21 on, which have points");
        const std::size_t width = second - first;
        std::array<double, 3> x = {};
        for (std::size_t k = 0; k < x.size(); ++k)
            x[k] = lines_.number_in_columns(start + k * width, start + (k + 1) * width - 1);
        const std::string element =
            element_by_name(lines_.columns(6, 10), lines_.columns(11, 15), false);
        const auto radius = radius_of_element(options_, element);
        if (!radius) lines_.fail_at_column(11, no_radius_of(lines_.columns(11, 15), element));
        guessed_.add(element);
        result_.in_space.push_back({x[0], x[1], x[2], *radius * angstrom_in_nanometres});
    }

    LineWords lines_;
    const ReadOptions& options_;
    GuessedElements guessed_;
    SitesFile result_;
};

}  // namespace

SitesFile read_gro_sites(InputFile& file, const ReadOptions& options) {
    return GroSites(file, options).read();
}

}  // namespace signum
