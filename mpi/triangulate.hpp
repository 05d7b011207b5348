#pragma once
/// Tessellations whose sites lie on many ranks: each rank gets those faces, in space cells, that
/// begin in its own sites, and no rank holds all of anything. The result is that of triangulate(),
/// and the same for every number of ranks.

#include <mpi.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "../triangulation/distributed/part.hpp"

namespace signum::mpi {

/// What it took.
struct Cost {
    std::uint64_t bytes_sent = 0;    ///< by this rank, to others
    std::size_t sites_told = 0;      ///< of others, that this rank had to know
    std::size_t rounds = 0;          ///< of questions
    double processor_seconds = 0.0;  ///< of this rank, without what MPI took, waiting most of it
};

/// The part of the whole that a rank has.
struct RankTessellation {
    std::int64_t whole = 0;                   ///< sites of all ranks
    std::vector<distributed::Placed> sites;   ///< those that this rank owns now
    std::unique_ptr<distributed::Part> part;  ///< their neighbours, faces, and who is hidden
    Cost cost;
};

/// Of the sites of all ranks, wherever they lie, each with a number of its own, 0 or more, by which
/// ties are decided and faces told. Sites go to ranks by place. Collective.
///
/// Throws on all ranks where it does on one: std::invalid_argument for numbers that are not finite,
/// weights in a metric without them and another metric of space than that of power,
/// distributed::NoStructure where no site is visible but one or, in the power metric, all lie on
/// one line, of space in one plane. Lack of memory on a rank ends all ranks (MPI_Abort). Expected
/// time: that of triangulate() for a rank's share, and some for the sites near its border. Where
/// most cells reach far (all sites on one circle, a giant that all others touch) ranks are told of
/// each other's sites until they know most of them.
[[nodiscard]] RankTessellation triangulate(std::vector<distributed::Placed> sites, MPI_Comm comm,
                                           const distributed::Kind& kind);

/// The whole as its arrays say it (arrays.hpp; space/triangulate.hpp), by stretches: rank after
/// rank has the faces from `first_face` on, the neighbours of each, and hidden sites in order.
struct Stretch {
    std::size_t corners = 3;  ///< of a face; of a cell 4
    std::int64_t faces_of_all = 0;
    std::int64_t first_face = 0;
    std::vector<std::int64_t> faces;       ///< so many numbers each
    std::vector<std::int64_t> neighbours;  ///< of each as many
    std::int64_t hidden_of_all = 0;
    std::int64_t first_hidden = 0;
    std::vector<distributed::WholeHidden> hidden;
};
/// Takes the part. Collective. Precondition: sites are numbered 0 …
/// whole - 1.
[[nodiscard]] Stretch in_order(RankTessellation& tessellation, MPI_Comm comm,
                               const distributed::Kind& kind);

}  // namespace signum::mpi
