#pragma once
/// The judge of a tessellation that lies on many ranks, whoever made it, of which no rank holds
/// all.

#include <vector>

#include "../triangulation/validate.hpp"
#include "triangulate.hpp"

namespace signum::mpi {

/// What validate() of triangulation/validate.hpp and of space checks, by the same argument: every
/// rank judges its stretch. Collective; the same on all ranks, whatever their number.
///
/// `slice`: of all sites, numbered 0 …, rank after rank. `stretch`: as in_order() makes it. Files
/// of faces alone have no neighbours, and do not say who is hidden (`tells_hidden`): then each edge
/// has to be the only one between its sites, and who is at no face has to be hidden.
///
/// Takes the stretch. Throws std::invalid_argument for sites that are not finite, kinds that there
/// are none of, edges that only neighbours can tell apart, and where there is no finite face.
/// Expected O(n) a rank, and O(n log n) for hidden sites. Signs are the judge's own numbers', but
/// those that find the site nearest to a hidden one.
[[nodiscard]] Validation validate(const std::vector<distributed::Placed>& slice, Stretch stretch,
                                  bool tells_hidden, MPI_Comm comm, const distributed::Kind& kind);

}  // namespace signum::mpi
