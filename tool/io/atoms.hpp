#pragma once
/// Sites of space from files of atoms.
///
/// Laws: as of read_sites().

#include "input_file.hpp"
#include "read_sites.hpp"

namespace signum {

/// The number of atoms, a comment, and a line each: element x y z [radius]; a radius that is
/// missing is 0, and the note says so. Where the comment has Properties (extended XYZ, such as the
/// frames of signum simulate), these say where pos and radius stand. Of several frames the last one
/// is read, and the note says so. Throws InputError.
[[nodiscard]] SitesFile read_xyz_sites(InputFile& file);

/// The records ATOM and HETATM of the Protein Data Bank, each with the van der Waals radius of its
/// element (io/elements.hpp). Of a residue with alternate places those with the letter that comes
/// first are read, of several models, which ENDMDL, MODEL or END end, the first one; the note says
/// so. Throws InputError, also for an element without a radius.
[[nodiscard]] SitesFile read_pdb_sites(InputFile& file);

/// The same records, whose last five words are x y z charge radius; of several models the first
/// one, and the note says so. Throws InputError.
[[nodiscard]] SitesFile read_pqr_sites(InputFile& file);

}  // namespace signum
