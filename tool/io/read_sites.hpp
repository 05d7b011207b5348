#pragma once
/// Sites from a file: text or JSON, described in README.md under "Input", and in space atoms and
/// vertices of meshes as well, described in docs/space.md.
///
/// Laws:
///  1. Every number is read to the nearest double.
///  2. Whatever is not exactly a list of sites is an InputError that names file, line and column
///     (of an array row and column); a file is read whole or not at all.
///  3. Memory beyond the sites themselves, and the attributes that were asked for, is bounded,
///     whatever the file holds; of mmCIF, which a library reads, it is a multiple of the file's.

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "../../core/site.hpp"
#include "../../core/strided_sites.hpp"
#include "../../triangulation/tessellation.hpp"
#include "attributes.hpp"
#include "errors.hpp"
#include "input_file.hpp"
#include "number.hpp"

namespace signum {

/// The columns that are x, y and, where there are three, r; in space x, y, z and, where there are
/// four, r. Each is the name that a header gives it, in any case, or its number from 1. Empty: what
/// the header says, else the first ones.
using Columns = std::vector<std::string>;

/// What a file of sites may be.
enum class SitesInput : std::uint8_t {
    text,       ///< lines of columns, JSON, or points of GeoJSON
    xyz,        ///< atoms: their number, a comment, then a line each: element x y z [radius]
    cif,        ///< atoms of an mmCIF file, with the radii of their elements
    gro,        ///< atoms of GROMACS
    lammpstrj,  ///< a dump of LAMMPS
    pdb,        ///< atoms of the Protein Data Bank, with the radii of their elements
    pqr,        ///< the same with charges and radii
    off,        ///< the same, of Geomview's format
    ply,        ///< vertices of a mesh
    npy,        ///< an array of NumPy's
    f64,        ///< doubles without a head
    node        ///< points of Triangle (in the plane) or TetGen (in space)
};
struct ReadOptions;
struct SitesFile;

/// One of them, as the one table in read_sites.cpp describes it.
struct SitesInputKind {
    SitesInput input;
    std::string_view name;    ///< and, but for text, the ending of its files, in small letters
    std::string_view ending;  ///< another one; empty where there is none
    std::string_view holds;   ///< for the help; lines are parted by \n
    bool is_of_space;         ///< whether all that is read so lies in space
    Contents contents;
    SitesFile (*read)(InputFile&, const ReadOptions&);
};
[[nodiscard]] std::span<const SitesInputKind> sites_input_kinds() noexcept;
[[nodiscard]] bool is_of_space(SitesInput input) noexcept;
/// Whether it is an array of numbers, of which shares can be read.
[[nodiscard]] bool is_array(SitesInput input) noexcept;
/// Text where the ending is none of theirs.
[[nodiscard]] SitesInput input_by_ending(std::string_view ending) noexcept;

/// How a file is read, where it leaves that open.
struct ReadOptions {
    Columns columns = {};
    /// 2 or 3; nothing: what the file says. Sites of text lie in space where a header names x, y
    /// and z, or where four columns are chosen; those of JSON where the first one has four numbers.
    std::optional<int> dimension = std::nullopt;
    /// Atoms and vertices of meshes lie in space.
    SitesInput input = SitesInput::text;
    /// Whether the attributes of text and nodes are read, too.
    bool attributes = false;
    /// Of text: the point of numbers, or the comma, which then separates no columns.
    char decimal = '.';
    /// Of text: how many lines before the header or the first site are passed over.
    std::int64_t skipped_lines = 0;
    /// Of text: whether lines are passed over where a number is empty, NA, NaN, null or none; the
    /// note says how many.
    bool skips_missing = false;
    /// Of molecules: radii of elements in Å, by their symbols in small letters, before those that
    /// are known.
    std::map<std::string, double> radii = {};
    /// Of the rows of an array one share of so many, the shares in order; all else is read whole.
    /// The file has to have a size.
    struct Share {
        std::uint64_t number = 0;
        std::uint64_t of = 1;
    } share = {};
};

/// At least one site, unless a share of many was asked for; all numbers finite; r is a radius or a
/// weight, as the user of the file says.
struct SitesFile {
    int dimension = 2;
    std::vector<Site> sites;      ///< in the plane
    std::vector<Site3> in_space;  ///< in space; the other one of the two is empty
    /// What a header calls the last column, where there is a header that says radius or weight.
    std::optional<WeightIs> third;
    /// Whether a site of text has a third number, and nobody has said what that is, or that sites
    /// lie in the plane.
    bool third_may_be_z = false;
    /// Whether a header calls them longitude and latitude: x and y are degrees.
    bool are_degrees = false;
    /// Where the first radius or weight below 0 stands.
    std::optional<Position> first_negative;
    /// Where the first number stands that no float reaches.
    std::optional<Position> first_beyond_single;
    /// Those that were asked for.
    std::vector<Attribute> attributes;
    /// By its row, the first of a share.
    std::uint64_t first_row = 0;
    /// By what a file of nodes numbers the first one: 0 or 1.
    int first_number = 0;
    /// What was left out, in a sentence, where a file has what may have been meant, such as a third
    /// column of another name, and nobody had said so; else empty.
    std::string note;

    /// A further site: x, y, in space z, and r. `place_of` says where the one of a number stands.
    template <class Place>
    void add(const std::array<double, 4>& numbers, const Place& place_of) {
        note_of(numbers, place_of);
        const auto& [x, y, third, fourth] = numbers;
        if (dimension == 3)
            in_space.push_back({x, y, third, fourth});
        else
            sites.push_back({x, y, third});
    }
    /// Whether one of them is the first below 0, or the first that no float reaches.
    template <class Place>
    void note_of(const std::array<double, 4>& numbers, const Place& place_of) {
        const std::size_t last = dimension == 3 ? 3 : 2;
        for (std::size_t which = 0; which <= last; ++which)
            if (is_beyond_single(numbers[which]) && !first_beyond_single)
                first_beyond_single = place_of(which);
        if (numbers[last] < 0.0 && !first_negative) first_negative = place_of(last);
    }
};

/// Reads the file `path`, or standard input for "-". Throws InputError, and MachineError where it
/// is the machine that fails. O(bytes).
[[nodiscard]] SitesFile read_sites(const std::string& path, const ReadOptions& options);

/// A view of sites whose third number is a radius or a weight, as triangulate() and validate() want
/// it.
[[nodiscard]] StridedSites strided_view(std::span<const Site> sites, WeightIs third) noexcept;

}  // namespace signum
