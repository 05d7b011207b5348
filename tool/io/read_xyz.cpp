/// Atoms and balls from files in XYZ, plain or extended.

#include "read_xyz.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "input_file.hpp"
#include "nearest_word.hpp"
#include "number.hpp"
#include "sites_readers.hpp"

namespace signum {
namespace {

/// What stands in quotes from `begin` on, or else up to a blank or to the = behind a key. A quote
/// that nothing closes is a letter. `begin` goes behind it.
std::string_view next_word(std::string_view text, std::size_t& begin, std::string_view ends) {
    const char first = text[begin];
    const std::size_t closing =
        first == '"' || first == '\'' ? text.find(first, begin + 1) : std::string_view::npos;
    if (closing != std::string_view::npos) {
        const std::string_view word = text.substr(begin + 1, closing - begin - 1);
        begin = closing + 1;
        return word;
    }
    const std::string_view word =
        text.substr(begin, std::min(text.find_first_of(ends, begin), text.size()) - begin);
    begin += word.size();
    return word;
}

struct XyzValue {
    std::string_view value;  ///< without quotes around it
    std::size_t column = 0;  ///< of the key, from 1
};

/// The first value of a key, which is in small letters; nothing where the comment, the second line
/// of a frame in extended XYZ, does not have it. A key is a word of its own, in any case; blanks
/// may stand around the =. A value ends at a blank, or at the quote that it begins with. What
/// stands in quotes is no key. Without `properties`, which say what the columns are, the frame is
/// plain.
std::optional<XyzValue> value_in_comment(std::string_view comment, std::string_view key) {
    constexpr std::string_view blanks = " \t";
    std::size_t at = 0;
    const auto skip_blanks = [&] {
        at = std::min(comment.find_first_not_of(blanks, at), comment.size());
    };
    for (skip_blanks(); at < comment.size(); skip_blanks()) {
        const std::size_t begin = at;
        const std::string_view word = next_word(comment, at, " \t=");
        skip_blanks();
        if (at == comment.size() || comment[at] != '=') continue;
        ++at;
        skip_blanks();
        const std::string_view value =
            at < comment.size() ? next_word(comment, at, blanks) : std::string_view();
        if (comment[begin] != '"' && comment[begin] != '\'' && in_small_letters(word) == key)
            return XyzValue{value, begin + 1};
    }
    return std::nullopt;
}

// ---- atoms as sites ----------------------------------------------------------------------------

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
        if (with_fifth_ > 0)
            notes.push_back(fmt::format(
                "a fifth word is no radius, for nothing says so, and is left out ({} of {} atoms); "
                "say it in the comment, as in Properties=species:S:1:pos:R:3:radius:R:1, or with "
                "--read-as text --skip-lines 2 --columns 2,3,4,5",
                with_fifth_, result_.in_space.size()));
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
        std::size_t radius = no_word;
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
        with_fifth_ = 0;
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
        if (layout.radius >= lines_.size()) ++without_radius_;
        if (!is_extended_ && lines_.size() > layout.least) ++with_fifth_;
        const std::size_t x = layout.x;
        add_site(result_, lines_, {x, x + 1, x + 2, layout.radius});
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

    static constexpr std::uint64_t most_columns = 1000;

    LineWords lines_;
    bool is_extended_ = false;
    bool is_periodic_ = false;
    std::size_t without_radius_ = 0;  ///< atoms of this frame
    std::size_t with_fifth_ = 0;      ///< of them, with a word behind x y z
    SitesFile result_;
};

// ---- frames of balls ---------------------------------------------------------------------------

constexpr std::string_view columns = "species:S:1:pos:R:3:velo:R:3:radius:R:1:id:I:1";
constexpr std::string_view advice = "give frames as signum writes them";

class Frames {
 public:
    explicit Frames(const std::string& path) : file_(path, "frames in extended XYZ") {}

    BallsFile last() {
        BallsFile frame;
        while (next_line()) {
            const auto balls = parse_whole_number(line_);
            if (!balls) fail(1, fmt::format("no number of balls; {}", advice));
            next_line_of_frame();
            const std::optional<XyzValue> properties = value_in_comment(line_, "properties");
            if (!properties || properties->value != columns)
                fail(properties ? properties->column : 1,
                     fmt::format("no Properties={}; {}", columns, advice));
            frame.balls.clear();
            for (std::uint64_t i = 0; i < *balls; ++i) {
                next_line_of_frame();
                frame.balls.push_back(ball());
            }
        }
        if (frame.balls.empty()) fail(1, fmt::format("no ball in the last frame; {}", advice));
        const bool is_flat = std::ranges::all_of(
            frame.balls, [](const BallLine& each) { return each.x[2] == 0.0 && each.v[2] == 0.0; });
        frame.dimension = is_flat ? 2 : 3;
        return frame;
    }

 private:
    [[noreturn]] void fail(std::size_t column, std::string_view message) const {
        file_.fail(
            {std::max<std::int64_t>(file_.line_number(), 1), static_cast<std::int64_t>(column)},
            message);
    }
    bool next_line() { return file_.next_line(line_, advice); }
    void next_line_of_frame() {
        if (!next_line()) fail(1, fmt::format("the file ends within a frame; {}", advice));
    }
    /// A species, eight numbers and nothing more.
    BallLine ball() {
        BallLine ball;
        ball.position.line = file_.line_number();
        std::size_t at = line_.find(' ');
        const auto number = [&] {
            const std::size_t begin = line_.find_first_not_of(' ', at);
            if (begin == std::string_view::npos)
                fail(line_.size() + 1,
                     fmt::format("a ball without all of its numbers; {}", advice));
            at = std::min(line_.find(' ', begin), line_.size());
            const std::string_view text = line_.substr(begin, at - begin);
            const Number number = parse_number(text);
            if (number.fault != NumberFault::none) fail(begin + 1, explain(number.fault, text));
            return number.value;
        };
        for (double& x : ball.x) x = number();
        for (double& v : ball.v) v = number();
        ball.radius = number();
        static_cast<void>(number());
        if (at != line_.size())
            fail(at + 1, fmt::format("more behind a ball than its numbers; {}", advice));
        return ball;
    }

    InputFile file_;
    std::string_view line_;
};

}  // namespace

SitesFile read_xyz_sites(InputFile& file) {
    return XyzSites(file).read();
}

bool looks_like_frames(std::string_view text) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return false;
    std::string_view number = text.substr(0, end);
    if (number.ends_with('\r')) number.remove_suffix(1);
    const std::string_view second = text.substr(end + 1, text.find('\n', end + 1) - end - 1);
    return parse_whole_number(number) && value_in_comment(second, "properties");
}

BallsFile read_last_frame(const std::string& path) {
    return Frames(path).last();
}

}  // namespace signum
