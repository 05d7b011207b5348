#pragma once
/// Which sites may share an edge, however ties are decided: those with a common nearest point (law
/// 1 of compare.hpp). Answered from the canonical tessellation, metric by metric.
///
/// Law: a site that no other hides or touches from inside has a cell with an inside. Where the
/// cells of two of them share no more than a point, that point is the vertex of a face at either;
/// so the faces around one of them tell. Squares in line with each other can share a strip, which
/// has no vertex; there the smallest squares between two sites are looked at.

#include <functional>
#include <vector>

#include "../core/handle.hpp"
#include "../core/index.hpp"
#include "../triangulation/structure/corners.hpp"
#include "../triangulation/tessellation.hpp"

namespace signum {

/// The canonical tessellation, ready for questions about one site. It must outlive this. A number
/// that names no site or face is std::out_of_range.
class Canonical {
 public:
    /// O(n).
    explicit Canonical(const Tessellation& tessellation);

    /// The canonical tessellation.
    [[nodiscard]] const Tessellation& tessellation() const noexcept { return tessellation_; }
    /// A site of it, by its number.
    [[nodiscard]] const Site& site(Index i) const {
        return tessellation_.sites()[checked("site", i, face_at_.size())];
    }
    /// A face of it, by its number.
    [[nodiscard]] const Face& face(Index f) const {
        return tessellation_.faces()[checked("face", f, tessellation_.faces().size())];
    }
    /// The site that hides i; -1 for a visible one.
    [[nodiscard]] Index hidden_by(Index i) const {
        return hidden_by_[checked("site", i, hidden_by_.size())];
    }
    /// i itself where it is visible, otherwise the site that hides it.
    [[nodiscard]] Index shown_for(Index i) const { return hidden_by(i) < 0 ? i : hidden_by(i); }
    /// Of two visible sites the one with fewer faces.
    [[nodiscard]] Index lesser(Index i, Index j) const {
        return degree_[checked("site", i, degree_.size())] <=
                       degree_[checked("site", j, degree_.size())]
                   ? i
                   : j;
    }

    /// Whether `holds` is true of a face at a visible site. O(degree).
    template <class Predicate>
    [[nodiscard]] bool any_face_at(Index i, Predicate holds) const {
        const Index first = face_at_[checked("site", i, face_at_.size())];
        if (first < 0) return false;
        for (const auto corner : triangulation::fan(tessellation_.arrays(), first, i))
            if (holds(face(corner.face))) return true;
        return false;
    }

 private:
    const Tessellation& tessellation_;
    std::vector<Index> face_at_;
    std::vector<Index> degree_;
    std::vector<Index> hidden_by_;
};

/// Whether two sites may share an edge. Exact, symmetric. Where one is visible the time is that of
/// a few exact predicates for every face at the one with fewer, and in the Manhattan and supremum
/// metrics of a short walk.
using Contacts = std::function<bool(Index, Index)>;

/// In the metric of the tessellation.
[[nodiscard]] Contacts contacts_of(const Canonical& canonical);

/// In a given one.
[[nodiscard]] Contacts contacts_in(Metric metric, const Canonical& canonical);

}  // namespace signum
