/// Atoms of LAMMPS' dumps of text: ITEM lines, and columns that ITEM: ATOMS names.

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

class DumpSites {
 public:
    DumpSites(InputFile& file, const ReadOptions& options)
        : lines_(file,
                 "a dump of LAMMPS is ITEM: TIMESTEP, ITEM: NUMBER OF ATOMS, ITEM: BOX BOUNDS and "
                 "ITEM: ATOMS, one after the other"),
          options_(options) {
        result_.dimension = 3;
    }

    SitesFile read() {
        std::int64_t frames = 0;
        while (lines_.next_with_words()) {
            if (!is_item()) lines_.fail_at(0, "a line ITEM: ... is to stand here");
            const std::string what(lines_.line().substr(item.size()));
            if (what.starts_with("NUMBER OF ATOMS")) {
                next();
                atoms_ = lines_.size() == 1 ? parse_whole_number(lines_[0]) : std::nullopt;
                if (!atoms_) lines_.fail_at(0, "a number of atoms is to stand here");
            } else if (what.starts_with("BOX BOUNDS")) {
                read_box();
            } else if (what.starts_with("ATOMS")) {
                read_atoms();
                ++frames;
            } else {
                next();  // the value of TIMESTEP, UNITS or TIME
            }
        }
        if (result_.in_space.empty()) lines_.fail_at_end("no atom in this file");
        std::vector<std::string> notes;
        if (frames > 1) notes.push_back(fmt::format("of {} frames the last one is read", frames));
        if (places_[3] == no_word && element_ == no_word)
            notes.emplace_back("no atom has a radius, and all radii are 0");
        if (is_scaled_) notes.emplace_back("scaled coordinates are placed in the box, and rounded");
        notes.emplace_back("the box is left out, and the atoms are in all of space");
        result_.note = joined_note(lines_.path(), notes);
        return std::move(result_);
    }

 private:
    static constexpr std::string_view item = "ITEM: ";
    [[nodiscard]] bool is_item() const { return lines_.line().starts_with(item); }
    void next() {
        if (!lines_.next()) lines_.fail_at_end("the file ends within a frame");
    }

    /// Three lines lo hi [tilt]; with tilts, xy, xz and yz, the bounds are of the box about the
    /// cell.
    void read_box() {
        const bool is_tilted = lines_.line().find("xy xz yz") != std::string_view::npos;
        if (lines_.line().find("abc origin") != std::string_view::npos)
            lines_.fail_at(0,
                           "boxes of general vectors are not read; write the dump with those of "
                           "LAMMPS");
        std::array<std::array<double, 3>, 3> rows = {};
        for (auto& row : rows) {
            next();
            const std::size_t numbers = is_tilted ? 3 : 2;
            if (lines_.size() < numbers)
                lines_.fail_at(lines_.size(), fmt::format("{} numbers are to stand here", numbers));
            for (std::size_t k = 0; k < numbers; ++k) row[k] = lines_.number(k);
        }
        xy_ = rows[0][2];
        xz_ = rows[1][2];
        yz_ = rows[2][2];
        low_ = {rows[0][0] - std::min({0.0, xy_, xz_, xy_ + xz_}), rows[1][0] - std::min(0.0, yz_),
                rows[2][0]};
        const std::array<double, 3> high = {rows[0][1] - std::max({0.0, xy_, xz_, xy_ + xz_}),
                                            rows[1][1] - std::max(0.0, yz_), rows[2][1]};
        for (std::size_t k = 0; k < 3; ++k) length_[k] = high[k] - low_[k];
    }

    /// Where the columns x y z stand, or scaled or unwrapped ones, and radius and element.
    void read_header_of_atoms() {
        struct Names {
            std::array<std::string_view, 3> of;
            bool is_scaled;
        };
        constexpr std::array<Names, 4> families = {{{{"x", "y", "z"}, false},
                                                    {{"xu", "yu", "zu"}, false},
                                                    {{"xs", "ys", "zs"}, true},
                                                    {{"xsu", "ysu", "zsu"}, true}}};
        columns_ = lines_.size() - 2;  // behind ITEM: ATOMS
        const auto column = [&](std::string_view name) {
            for (std::size_t k = 0; k < columns_; ++k)
                if (lines_[k + 2] == name) return k;
            return no_word;
        };
        places_.fill(no_word);
        for (const Names& names : families) {
            std::array<std::size_t, 3> found = {};
            std::ranges::transform(names.of, found.begin(), column);
            if (std::ranges::count(found, no_word) > 0) continue;
            std::ranges::copy(found, places_.begin());
            is_scaled_ = names.is_scaled;
            break;
        }
        if (places_[0] == no_word)
            lines_.fail_at(std::min<std::size_t>(2, lines_.size()),
                           "the atoms have no columns x y z, xu yu zu, xs ys zs or xsu ysu zsu");
        places_[3] = column("radius");
        element_ = places_[3] == no_word ? column("element") : no_word;
        if (places_[3] != no_word) result_.third = WeightIs::radius;
    }

    void read_atoms() {
        read_header_of_atoms();
        if (!atoms_) lines_.fail_at(0, "ITEM: NUMBER OF ATOMS is to stand before ITEM: ATOMS");
        if (is_scaled_ && length_[0] == 0.0)
            lines_.fail_at(0, "ITEM: BOX BOUNDS is to stand before scaled coordinates");
        result_.in_space.clear();
        result_.first_negative.reset();
        for (std::uint64_t i = 0; i < *atoms_; ++i) {
            if (!lines_.next())
                lines_.fail_at_end(fmt::format("the file ends after {} of {} atoms", i, *atoms_));
            if (lines_.size() != columns_)
                lines_.fail_at(
                    std::min(lines_.size(), columns_),
                    fmt::format("{} columns, but ITEM: ATOMS names {}", lines_.size(), columns_));
            add_site(result_, lines_, places_);
            Site3& site = result_.in_space.back();
            if (element_ != no_word) site.r = radius_of(element_);
            if (is_scaled_)
                site = {low_[0] + site.x * length_[0] + site.y * xy_ + site.z * xz_,
                        low_[1] + site.y * length_[1] + site.z * yz_, low_[2] + site.z * length_[2],
                        site.r};
        }
        atoms_.reset();
    }

    [[nodiscard]] double radius_of(std::size_t column) const {
        if (const auto known = radius_of_element(options_, lines_[column])) return *known;
        lines_.fail_at(column, no_radius_of(lines_[column], lines_[column]));
    }

    LineWords lines_;
    const ReadOptions& options_;
    std::optional<std::uint64_t> atoms_;
    std::array<double, 3> low_ = {};
    std::array<double, 3> length_ = {};
    double xy_ = 0.0;
    double xz_ = 0.0;
    double yz_ = 0.0;
    std::size_t columns_ = 0;
    std::array<std::size_t, 4> places_ = {};  ///< of x, y, z and radius among them
    std::size_t element_ = no_word;           ///< where there is no radius
    bool is_scaled_ = false;
    SitesFile result_;
};

}  // namespace

SitesFile read_lammpstrj_sites(InputFile& file, const ReadOptions& options) {
    return DumpSites(file, options).read();
}

}  // namespace signum
