#pragma once
/// The readers of sites, one a format. Each reads all sites of an open file and throws InputError.
///
/// Laws: as of read_sites().

#include <array>
#include <cstddef>

#include "input_file.hpp"
#include "line_words.hpp"
#include "read_sites.hpp"

namespace signum {

/// Lines x y [r], in space x y z [r]: of 2 or 3 dimensions, or of those that a header or the
/// columns tell.
[[nodiscard]] SitesFile read_text_sites(InputFile& file, const ReadOptions& options);

/// JSON [[x, y, r], [x, y], ...], in space [[x, y, z, r], [x, y, z], ...]: of 2 or 3 dimensions or
/// of those that the first site tells: it lies in space where it has four numbers.
[[nodiscard]] SitesFile read_json_sites(InputFile& file, const ReadOptions& options);

/// The points of GeoJSON, in the plane unless the dimension is 3; properties are attributes, but
/// for r, radius or weight, which is that.
[[nodiscard]] SitesFile read_geojson_sites(InputFile& file, const ReadOptions& options);

/// The number of atoms, a comment, and a line each: element x y z [radius]; a radius that is
/// missing is 0, and the note says so. Where the comment has Properties (extended XYZ, such as the
/// frames of signum simulate), these say where pos and radius stand. Of several frames the last one
/// is read, and the note says so.
[[nodiscard]] SitesFile read_xyz_sites(InputFile& file);

/// The loop _atom_site of mmCIF, each atom with the radius of its element. Models and alternate
/// places as of PDB. gemmi reads the file; a build without it refuses the format.
[[nodiscard]] SitesFile read_cif_sites(InputFile& file, const ReadOptions& options);

/// The last frame of a GRO file, lengths in nanometres: radii of elements, which names of atom and
/// residue tell, too.
[[nodiscard]] SitesFile read_gro_sites(InputFile& file, const ReadOptions& options);

/// The last frame of a dump of LAMMPS, in the order of its lines: x y z, xu yu zu, or the same
/// scaled to the box, which are rounded; radius, else that of the element, else 0.
[[nodiscard]] SitesFile read_lammpstrj_sites(InputFile& file, const ReadOptions& options);

/// The records ATOM and HETATM of the Protein Data Bank, each with the radius that the options give
/// its element, else with its van der Waals radius (io/elements.hpp); an element without one is an
/// error, too. Where columns 77 and 78 name no element, the names of atom and residue tell it, and
/// the note says so. Of a residue with alternate places those with the letter that comes first are
/// read, of several models, which ENDMDL, MODEL or END end, the first one; the note says so.
[[nodiscard]] SitesFile read_pdb_sites(InputFile& file, const ReadOptions& options);

/// The same records, whose last five words, or columns 31 to 70 where words have grown together,
/// are x y z charge radius; of several models the first one, and the note says so.
[[nodiscard]] SitesFile read_pqr_sites(InputFile& file);

/// The vertices of an OFF file: x y z, whatever stands behind them.
[[nodiscard]] SitesFile read_off_sites(InputFile& file);

/// The vertices of a PLY file, in ASCII or binary: their properties x, y, z and, where there is
/// one, radius or weight; others, and other elements, are left out.
[[nodiscard]] SitesFile read_ply_sites(InputFile& file);

/// The .node files of Triangle, whose points lie in the plane, and of TetGen, in space: the number
/// of points, their dimension, the numbers of attributes and of boundary markers, then a line each:
/// number x y [z] attributes marker. Numbers count from 0 or from 1, as the first one says. What is
/// an attribute and what a radius the file does not say: attributes and markers are left out, and
/// the note says so, unless options.columns choose one of the columns, numbered from 1, for the
/// radius, or options.attributes asks for all.
[[nodiscard]] SitesFile read_node_sites(InputFile& file, const ReadOptions& options);

/// An array of NumPy's, of floats or integers, of two axes: rows x, y [r], in space x, y, z [r], of
/// 2 or 3 dimensions; where nothing says how many, in space where rows have four numbers.
/// options.columns choose others, numbered from 1.
[[nodiscard]] SitesFile read_npy_sites(InputFile& file, const ReadOptions& options);

/// Doubles as the machine has them, without a head: rows x, y, r, in space x, y, z, r.
[[nodiscard]] SitesFile read_f64_sites(InputFile& file, const ReadOptions& options);

inline constexpr std::size_t no_word = static_cast<std::size_t>(-1);

/// A further site from the words of a line: x, y, in space z, and r. What stands at no word is 0.
void add_site(SitesFile& file, const LineWords& line, const std::array<std::size_t, 4>& words);

}  // namespace signum
