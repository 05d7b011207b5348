#pragma once
/// The check of power triangulations of the plane: that of any dimension, which takes their faces
/// for cells. Here is what the plane's arrays say otherwise: neighbours may be missing, one visible
/// site has no face, and sites on a line have infinite faces on either side.

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "../any_dimension/check.hpp"
#include "arrays_check.hpp"

namespace signum::triangulation {

/// Asked: see any_dimension/check.hpp.
template <power::PowerSite S, class Asked = any_dimension::Questions<S, exact::Dyadic>>
class PowerCheck : private ArraysCheck {
 public:
    PowerCheck(const TessellationArrays& arrays, const StridedSites& sites,
               const ValidationOptions& options)
        : ArraysCheck(arrays, sites.size(), options), site_(load<S>(sites)), options_(options) {}

    [[nodiscard]] Validation run() {
        Validation counted;
        Validation result = judgement([&] {
            check_sites();
            counted = judged_cells();
            if (!counted.valid) throw Invalid{counted.message};
            if (!counted.canonical) note(counted.message);
            check_canonical_order(view_of(std::span(site_)));
        });
        result.filtered = counted.filtered;
        result.multiprecision = counted.multiprecision;
        return result;
    }

 private:
    using Faces = std::vector<Face>;

    template <class CellName>
    [[nodiscard]] Validation judged(int dimension, const Faces& cells, const Faces& neighbours,
                                    const CellName& cell_name) const {
        const any_dimension::ArraysOf<2> arrays{dimension, arrays_.sites, cells, neighbours,
                                                arrays_.hidden};
        return any_dimension::Check<S, CellName, Asked>(arrays, site_, cell_name, options_).run();
    }

    [[nodiscard]] Validation judged_cells() {
        const bool is_line = std::ranges::all_of(
            arrays_.faces, [](const Face& v) { return std::ranges::count(v, infinite) == 1; });
        const bool must_find = must_find_neighbours();
        if (!must_find) check_neighbour_count();
        if (!is_line && !must_find) return judged(2, arrays_.faces, arrays_.neighbours, face_name);
        if (!is_line) return judged(2, arrays_.faces, found_neighbours(), face_name);
        if (!must_find) connect();
        if (visible_ >= 2) return judged_line(must_find);
        // The cell of one visible site, and that of infinity.
        if (visible_ == 0) return judged(-1, {}, {}, face_name);
        return judged(
            0, {{infinite, no_vertex, no_vertex}, {visible_sites()[0], no_vertex, no_vertex}},
            {{1, no_vertex, no_vertex}, {0, no_vertex, no_vertex}}, face_name);
    }

    /// An edge between two sites is unique.
    [[nodiscard]] Faces found_neighbours() {
        connect_unique();
        Faces result(arrays_.faces.size());
        for (Index f = 0; f < faces(); ++f)
            for (unsigned k = 0; k < 3; ++k)
                result[at(f)][k] =
                    Topology::face(topology_.twin(Topology::first_edge(f) + (k + 1) % 3));
        return result;
    }

    /// Sites on a line, one beside the other: between two there is an infinite face on either side,
    /// and all of these are one cycle. Of their cells each has the one before it across from its
    /// second vertex.
    [[nodiscard]] Validation judged_line(bool must_find) {
        std::vector<Index> line = visible_sites();
        std::ranges::sort(line, {},
                          [this](Index i) { return std::pair(site_[at(i)].x, site_[at(i)].y); });
        Faces expected;
        for (std::size_t i = 1; i < line.size(); ++i) {
            expected.push_back({infinite, line[i - 1], line[i]});
            expected.push_back({infinite, line[i], line[i - 1]});
        }
        Faces given = arrays_.faces;
        for (Face& v : given) std::rotate(v.begin(), std::ranges::find(v, infinite), v.end());
        std::ranges::sort(expected);
        std::ranges::sort(given);
        if (given != expected) throw Invalid{"the sites on a line are not one chain"};
        if (!must_find) check_infinity();

        line.insert(line.begin(), infinite);
        line.push_back(infinite);
        const auto cells = static_cast<Index>(line.size()) - 1;
        Faces chain;
        Faces neighbours;
        for (Index c = 0; c < cells; ++c) {
            chain.push_back({line[at(c)], line[at(c) + 1], no_vertex});
            neighbours.push_back({(c + 1) % cells, (c + cells - 1) % cells, no_vertex});
        }
        return judged(1, chain, neighbours, [&](Index c) {
            return "the edge from " + name(line[at(c)]) + " to " + name(line[at(c) + 1]);
        });
    }

    std::vector<S> site_;
    const ValidationOptions& options_;
};

}  // namespace signum::triangulation
