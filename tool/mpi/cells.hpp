#pragma once
/// What ranks know of cells, as tables and grids: of the sites that each of them owns.

#include <string>
#include <vector>

#include "../../mpi/communicator.hpp"
#include "../../mpi/triangulate.hpp"
#include "../io/vtk_grid.hpp"

namespace signum::mpi {

/// The finite faces, in space cells, whose least site is an own one.
[[nodiscard]] VtkGrid grid_of_faces(const distributed::Known& known, const distributed::Kind& kind);

/// The cells of the diagram, cut to a box around all centres, as signum voronoi cuts them: a table
/// with the bytes that signum writes, and pieces.
class RankCells {
 public:
    /// Collective. Throws std::invalid_argument where doubles cannot compute with the box.
    RankCells(Communicator& ranks, const RankTessellation& tessellation,
              const distributed::Kind& kind, bool wants_table, bool wants_grid);
    [[nodiscard]] const VtkGrid& grid() const noexcept { return grid_; }
    /// Collective.
    void write_table(Communicator& ranks, const std::string& name) const;

 private:
    std::int64_t sites_;
    std::string table_;  ///< head and rows
    VtkGrid grid_;
};

/// A file of each rank's beside unfinished(name), which names all. Collective.
void write_pieces(Communicator& ranks, const std::string& name, const VtkGrid& own);

}  // namespace signum::mpi
