#pragma once
/// The targets that read: whatever the bytes are, there is a result, or the error that is
/// documented, with its place; and what is read is written so that it reads back to the same.

#include "target.hpp"

namespace signum::fuzz {

/// Sites of the plane and of space from columns or from JSON, with each choice of columns.
void read_sites_target(Bytes bytes);
/// Atoms and vertices.
void read_xyz_target(Bytes bytes);
void read_pdb_target(Bytes bytes);
void read_pqr_target(Bytes bytes);
void read_cif_target(Bytes bytes);
void read_gro_target(Bytes bytes);
void read_lammpstrj_target(Bytes bytes);
void read_off_target(Bytes bytes);
void read_ply_target(Bytes bytes);
void read_node_target(Bytes bytes);
/// NumPy's, and doubles without a head.
void read_array_target(Bytes bytes);
/// Balls from lines, and from frames.
void read_balls_target(Bytes bytes);
void read_frames_target(Bytes bytes);
/// A tessellation, and what validate() says of its arrays, which may hold any numbers.
void read_tessellation_target(Bytes bytes);
/// The state of a simulation.
void read_state_target(Bytes bytes);
/// Numbers, units and words that were mistyped.
void read_words_target(Bytes bytes);
/// A scene, up to the places of its balls where these are few; and what the command line says in
/// place of its keys.
void read_scene_target(Bytes bytes);
void read_override_target(Bytes bytes);

}  // namespace signum::fuzz
