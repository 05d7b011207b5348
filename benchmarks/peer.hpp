#pragma once
/// A contestant of the peers' benchmark: a program that builds a tessellation, whoever wrote it.

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "../core/site.hpp"
#include "../triangulation/tessellation.hpp"

namespace signum::benchmarks {

/// One construction. Made from the sites, which it takes over in types of its own; that is not
/// timed.
class Attempt {
 public:
    Attempt() = default;
    Attempt(const Attempt&) = delete;
    Attempt& operator=(const Attempt&) = delete;
    virtual ~Attempt() = default;
    /// From scratch; this is timed.
    virtual void build() = 0;
    /// The faces that were built, in any order: counterclockwise, those at infinity included; or
    /// the finite ones alone, in any orientation. Neighbours where two sites can share several
    /// edges.
    virtual void write(std::vector<Face>& faces, std::vector<Face>& neighbours) const = 0;
};

/// One that makes a Tessellation.
class Triangulation : public Attempt {
 public:
    using Triangulate = std::function<Tessellation(const std::vector<Site>&)>;
    Triangulation(std::vector<Site> sites, Triangulate triangulate)
        : sites_(std::move(sites)), triangulate_(std::move(triangulate)) {}
    void build() override { tessellation_ = triangulate_(sites_); }
    void write(std::vector<Face>& faces, std::vector<Face>& neighbours) const override {
        faces.assign(tessellation_.faces().begin(), tessellation_.faces().end());
        neighbours.assign(tessellation_.neighbours().begin(), tessellation_.neighbours().end());
    }

 private:
    std::vector<Site> sites_;
    Triangulate triangulate_;
    Tessellation tessellation_;
};

using Prepare = std::function<std::unique_ptr<Attempt>(const std::vector<Site>&)>;

/// signum's insertion on Shewchuk's predicates, as TetGen's library has them: Delaunay.
[[nodiscard]] std::unique_ptr<Attempt> prepare_shewchuk(const std::vector<Site>& sites);
/// Qhull's library with the options of SciPy's Delaunay.
[[nodiscard]] std::unique_ptr<Attempt> prepare_qhull(const std::vector<Site>& sites);

namespace cgal {
/// The constructions of cgal_constructions.hpp.
[[nodiscard]] std::unique_ptr<Attempt> prepare_delaunay(const std::vector<Site>& sites);
[[nodiscard]] std::unique_ptr<Attempt> prepare_regular(const std::vector<Site>& sites);
[[nodiscard]] std::unique_ptr<Attempt> prepare_apollonius(const std::vector<Site>& sites);
[[nodiscard]] std::unique_ptr<Attempt> prepare_linf(const std::vector<Site>& sites);

/// CGAL's exact predicates on the faces of a Delaunay triangulation or, where `weighted`, a regular
/// one with weights r² rounded: every finite face counterclockwise, every edge locally regular, no
/// hull edge reflex. Not whether a site is missing.
[[nodiscard]] bool are_regular(const std::vector<Face>& faces, const std::vector<Site>& sites,
                               bool weighted);
}  // namespace cgal

}  // namespace signum::benchmarks
