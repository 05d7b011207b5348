/// Atoms from files in XYZ, plain or extended.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "atoms.hpp"
#include "line_words.hpp"
#include "nearest_word.hpp"
#include "number.hpp"
#include "xyz_comment.hpp"

namespace signum {
namespace {

class XyzSites {
 public:
    explicit XyzSites(InputFile& file)
        : lines_(file,
                 "an XYZ file is the number of atoms, a comment, and a line each: element x y z "
                 "[radius]") {
        result_.dimension = 3;
    }

    SitesFile read() {
        std::int64_t frames = 0;
        for (; lines_.next_with_words(); ++frames) read_frame();
        if (result_.in_space.empty()) {
            lines_.fail_at_end(frames > 1 ? fmt::format("no atom in the last of {} frames", frames)
                                          : "no atom in this file");
        }
        std::vector<std::string> notes;
        if (frames > 1) notes.push_back(fmt::format("of {} frames the last one is read", frames));
        if (without_radius_ == result_.in_space.size())
            notes.emplace_back("no atom has a radius, and all radii are 0");
        else if (without_radius_ > 0)
            notes.push_back(fmt::format("{} of {} atoms have no radius, and theirs are 0",
                                        without_radius_, result_.in_space.size()));
        if (is_periodic_)
            notes.emplace_back("the periodic box is left out, and the atoms are in all of space");
        if (!notes.empty())
            result_.note = fmt::format("{}: {}", lines_.path(), fmt::join(notes, "; "));
        return std::move(result_);
    }

 private:
    /// Where the words of an atom stand.
    struct AtomLayout {
        std::size_t x = 1;  ///< y and z follow
        std::size_t radius = 4;
        std::size_t least = 4;
        std::size_t most = 5;
    };

    void read_frame() {
        const auto atoms = parse_whole_number(lines_[0]);
        if (!atoms || lines_.size() > 1) {
            lines_.fail_at(lines_.size() > 1 && atoms ? 1 : 0,
                           "the number of atoms stands alone in the first line of an XYZ file; "
                           "where lines are x y z [r], say --read-as text --dimension 3");
        }
        if (!lines_.next()) lines_.fail_at_end("the file ends within a frame");
        const AtomLayout layout = layout_of_comment();
        is_periodic_ = says_periodic(lines_.line());
        result_.in_space.clear();
        result_.first_negative.reset();
        without_radius_ = 0;
        for (std::uint64_t i = 0; i < *atoms; ++i) {
            if (!lines_.next()) {
                lines_.fail_at_end(fmt::format("the file ends after {} of {} atoms", i, *atoms));
            }
            read_atom(layout);
        }
    }

    void read_atom(const AtomLayout& layout) {
        if (lines_.size() < layout.least) {
            lines_.fail_at(lines_.size(),
                           fmt::format("{} words; an atom is element x y z [radius]{}",
                                       lines_.size(), is_extended_ ? ", as Properties say" : ""));
        }
        if (lines_.size() > layout.most) {
            lines_.fail_at(layout.most,
                           is_extended_
                               ? fmt::format("{} words, but Properties name {}; write as many",
                                             lines_.size(), layout.most)
                               : "more than element x y z radius; write no more, or say in the "
                                 "comment what it is, as in Properties=species:S:1:pos:R:3:...");
        }
        const std::size_t x = layout.x;
        Site3 site = {lines_.number(x), lines_.number(x + 1), lines_.number(x + 2), 0.0};
        if (layout.radius < lines_.size()) {
            site.r = lines_.number(layout.radius);
            if (site.r < 0.0 && !result_.first_negative)
                result_.first_negative = lines_.position_of(layout.radius);
        } else {
            ++without_radius_;
        }
        result_.in_space.push_back(site);
    }

    /// Whether a comment has a Lattice, along whose vectors the atoms come again unless pbc, a T or
    /// F for each, says otherwise. Only extended XYZ says so.
    [[nodiscard]] bool says_periodic(std::string_view comment) const {
        if (!is_extended_ || !value_in_comment(comment, "lattice")) return false;
        const std::optional<XyzValue> pbc = value_in_comment(comment, "pbc");
        return !pbc || pbc->value.find_first_of("Tt1") != std::string_view::npos;
    }

    /// Properties=NAME:TYPE:COLUMNS:NAME:... say what stands where; names in any case.
    AtomLayout layout_of_comment() {
        const std::optional<XyzValue> properties = value_in_comment(lines_.line(), "properties");
        is_extended_ = properties.has_value();
        if (!is_extended_) return {};
        std::string_view rest = properties->value;
        const auto next_part = [&] {
            const std::string_view part = rest.substr(0, rest.find(':'));
            rest.remove_prefix(std::min(rest.size(), part.size() + 1));
            return part;
        };
        const auto fail = [&](std::string_view message) {
            lines_.fail_at_column(properties->column, message);
        };
        std::size_t column = 0;
        std::optional<std::size_t> position;
        AtomLayout layout = {0, no_word, 0, 0};
        while (!rest.empty()) {
            const std::string name = in_small_letters(next_part());
            const std::string_view type = next_part();
            const auto count = parse_whole_number(next_part());
            if (!count || *count > most_columns || type.size() != 1)
                fail("Properties are NAME:TYPE:COLUMNS, one after the other with : between");
            if (name == "pos" && *count == 3) position = column;
            if (name == "radius" && *count == 1) layout.radius = column;
            column += *count;
        }
        if (!position) fail("Properties without pos:R:3, the places of the atoms");
        layout.x = *position;
        layout.least = layout.most = column;
        return layout;
    }

    static constexpr std::size_t no_word = static_cast<std::size_t>(-1);
    static constexpr std::uint64_t most_columns = 1000;

    LineWords lines_;
    bool is_extended_ = false;
    bool is_periodic_ = false;
    std::size_t without_radius_ = 0;  ///< atoms of this frame
    SitesFile result_;
};

}  // namespace

SitesFile read_xyz_sites(InputFile& file) {
    return XyzSites(file).read();
}

}  // namespace signum
