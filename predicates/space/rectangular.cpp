#include "rectangular.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#include "../../exact/floating_environment.hpp"
#include "../../filters/environment.hpp"
#include "../formulas/facets.hpp"
#include "rectangular_forms.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::rectangular {
namespace {

/// Takes the first facet out of a set.
[[nodiscard]] inline std::size_t take_first(FacetSet& set) noexcept {
    const auto first = static_cast<std::size_t>(std::countl_zero(set));
    set = static_cast<FacetSet>(set & ~facet_bit(first));
    return first;
}
[[nodiscard]] inline FacetSet with(FacetSet set, std::size_t facet) noexcept {
    return static_cast<FacetSet>(set | facet_bit(facet));
}

template <class Shape>
[[nodiscard]] const Basis& basis_of_contacts(const Contacts& sphere) noexcept {
    FacetSet set = 0;
    for (const std::size_t facet : sphere.facets) set = with(set, facet);
    return basis_of<Shape>(set);
}

using Four = std::array<Site3, 4>;

// ---- the filters -------------------------------------------------------------------------------

/// What the doubles say of a sphere in four facets.
enum class Answer { no, yes, open };

/// The forms M of four sites, each pinned by one of them alone.
template <class Shape>
struct Pinned {
    Forms3<Shape> greatest;
    std::array<std::uint8_t, Shape::facets> by;
    double bound;

    /// Whether the sphere in these facets, one of each site, is there and touches in no other.
    [[nodiscard]] Answer holds(const Basis& basis) const noexcept {
        if (basis.determinant == 0) return Answer::no;
        std::array<double, 4> of_basis;
        for (std::size_t t = 0; t < 4; ++t) of_basis[t] = greatest[basis.facets[t]];
        Answer answer = Answer::yes;
        for (std::size_t f = 0; f < Shape::facets; ++f) {
            if (rectangular::holds(basis.set, f)) continue;
            const double rest = excess<double>(basis, f, greatest[f], of_basis);
            if (rest > bound) return Answer::no;
            if (!(rest < -bound)) answer = Answer::open;
        }
        return answer;
    }
};

/// Adds a sphere in its place; `sets` are those of the spheres before.
template <class Shape>
void insert(Spheres& spheres, std::array<FacetSet, Shape::most_spheres>& sets, FacetSet set,
            const Contacts& sphere) noexcept {
    SIGNUM_EXPECTS(spheres.count < Shape::most_spheres);
    std::size_t place = spheres.count++;
    for (; place > 0 && sets[place - 1] < set; --place) {
        sets[place] = sets[place - 1];
        spheres.spheres[place] = spheres.spheres[place - 1];
    }
    sets[place] = set;
    spheres.spheres[place] = sphere;
}

/// Where each facet is pinned by one site alone and no sphere touches in five facets: then a sphere
/// touches each site in one facet, and they are not infinitely many. False where a sign is open.
///
/// Nothing is missed by looking at independent facets alone. A sphere that all four sites touch in
/// facets of one plane touches in another facet, too, for it is a corner. Let this take the place
/// of the one that its site has in the plane: these four are independent, theirs is the same
/// sphere, no facet exceeds it, and so the sign of the one replaced, 0, is open.
template <class Shape>
[[nodiscard]] bool filter_spheres(const Four& sites, Spheres& result) noexcept {
    std::array<Forms3<Shape>, 4> of;
    double size = 0.0;
    for (std::size_t m = 0; m < 4; ++m) {
        const Site3 site = filters::pinned(sites[m]);
        of[m] = rounded_forms<Shape>(site);
        size = std::max(size, size_of(site));
    }
    Pinned<Shape> pinned;
    pinned.bound = bound_of<Shape>(size);
    std::array<FacetSet, 4> pins = {};
    bool open = !filters::environment_is_default();
    for (std::size_t f = 0; f < Shape::facets; ++f) {
        double first = of[0][f];
        double second = -std::numeric_limits<double>::infinity();
        std::size_t by = 0;
        for (std::size_t m = 1; m < 4; ++m) {
            const double form = of[m][f];
            const bool greater = form > first;
            second = std::max(second, greater ? first : form);
            by = greater ? m : by;
            first = greater ? form : first;
        }
        open |= !(first - second > pinned.bound);
        pinned.greatest[f] = first;
        pinned.by[f] = static_cast<std::uint8_t>(by);
        pins[by] = with(pins[by], f);
    }
    if (open) [[unlikely]]
        return false;

    std::array<FacetSet, Shape::most_spheres> sets;
    for (FacetSet a = pins[0]; a != 0;) {
        const FacetSet with_a = with(0, take_first(a));
        for (FacetSet b = pins[1]; b != 0;) {
            const FacetSet with_b = with(with_a, take_first(b));
            for (FacetSet c = pins[2]; c != 0;) {
                const FacetSet with_c = with(with_b, take_first(c));
                for (FacetSet d = pins[3]; d != 0;) {
                    const Basis& basis = basis_of<Shape>(with(with_c, take_first(d)));
                    const Answer answer = pinned.holds(basis);
                    if (answer == Answer::open) return false;
                    if (answer == Answer::no) continue;
                    Contacts sphere{basis.facets, {}};
                    for (std::size_t t = 0; t < 4; ++t)
                        sphere.sites[t] = pinned.by[basis.facets[t]];
                    insert<Shape>(result, sets, basis.set, sphere);
                }
            }
        }
    }
    return true;
}

template <class Shape>
[[nodiscard]] filters::Verdict filter_in_sphere(const Four& sites, const Contacts& sphere,
                                                const Site3& q) noexcept {
    const Basis& basis = basis_of_contacts<Shape>(sphere);
    const Site3 query = filters::pinned(q);
    double size = size_of(query);
    std::array<double, 4> of_basis;
    for (std::size_t t = 0; t < 4; ++t) {
        const Site3 site = filters::pinned(sites[sphere.sites[t]]);
        size = std::max(size, size_of(site));
        of_basis[t] = rounded_forms<Shape>(site)[basis.facets[t]];
    }
    const double bound = bound_of<Shape>(size);
    if (!filters::environment_is_default()) [[unlikely]]
        return filters::Verdict::uncertain();
    const Forms3<Shape> of_query = rounded_forms<Shape>(query);
    bool inside = true;
    for (std::size_t f = 0; f < Shape::facets; ++f) {
        const double rest = excess<double>(basis, f, of_query[f], of_basis);
        if (rest > bound) return filters::Verdict::certain(-1);
        inside &= rest < -bound;
    }
    return inside ? filters::Verdict::certain(1) : filters::Verdict::uncertain();
}

template <class Shape>
[[nodiscard]] filters::Verdict filter_hides(const Site3& i, const Site3& q) noexcept {
    const Site3 one = filters::pinned(i);
    const Site3 query = filters::pinned(q);
    const double bound = bound_of<Shape>(std::max(size_of(one), size_of(query)));
    if (!filters::environment_is_default()) [[unlikely]]
        return filters::Verdict::uncertain();
    const Forms3<Shape> of_one = rounded_forms<Shape>(one);
    const Forms3<Shape> of_query = rounded_forms<Shape>(query);
    bool hides = true;
    for (std::size_t f = 0; f < Shape::facets; ++f) {
        const double rest = of_query[f] - of_one[f];
        if (rest < -bound) return filters::Verdict::certain(-1);
        hides &= rest > bound;
    }
    return hides ? filters::Verdict::certain(1) : filters::Verdict::uncertain();
}

// ---- exact, in the default environment ---------------------------------------------------------

/// Signs of sums of forms of n sites, each behind the filter, and the last stage that was needed.
template <class Shape, std::size_t n>
class Exact {
 public:
    explicit Exact(const std::array<Site3, n>& sites) noexcept : sites_(sites) {
        double size = 0.0;
        for (std::size_t m = 0; m < n; ++m) {
            forms_[m] = rounded_forms<Shape>(sites[m]);
            size = std::max(size, size_of(sites[m]));
        }
        bound_ = bound_of<Shape>(size);
    }

    /// The sign of g_facet(a) - g_facet(b).
    [[nodiscard]] Sign compare(std::size_t facet, std::size_t a, std::size_t b) noexcept {
        const double rest = forms_[a][facet] - forms_[b][facet];
        if (filters::magnitude(rest) > bound_) return filters::sign_of_nonzero(rest);
        return exactly(std::array<Addend3, 2>{{{&sites_[a], facet, 1}, {&sites_[b], facet, -1}}});
    }

    /// The sign of the excess of g_facet(site) over the basis, whose facets are pinned by `by`.
    [[nodiscard]] Sign excess(const Basis& basis, const std::array<std::uint8_t, 4>& by,
                              std::size_t facet, std::size_t site) noexcept {
        std::array<double, 4> of_basis;
        for (std::size_t t = 0; t < 4; ++t) of_basis[t] = forms_[by[t]][basis.facets[t]];
        const double rest =
            rectangular::excess<double>(basis, facet, forms_[site][facet], of_basis);
        if (filters::magnitude(rest) > bound_) return filters::sign_of_nonzero(rest);
        std::array<Addend3, 5> addends;
        addends[4] = {&sites_[site], facet, basis.times[facet]};
        for (std::size_t t = 0; t < 4; ++t)
            addends[t] = {&sites_[by[t]], basis.facets[t], -basis.weights[facet][t]};
        return exactly(addends);
    }

    [[nodiscard]] Stage stage() const noexcept { return stage_; }

 private:
    template <std::size_t count>
    [[nodiscard]] Sign exactly(const std::array<Addend3, count>& addends) noexcept {
        const Decision decision = sign_of_forms<Shape>(addends);
        stage_ = std::max(stage_, decision.stage);
        return decision.sign;
    }

    std::array<Site3, n> sites_;
    std::array<Forms3<Shape>, n> forms_;
    double bound_;
    Stage stage_ = Stage::filter;
};

/// The subdivision of law 4, cell by cell.
template <class Shape>
class Subdivision {
 public:
    explicit Subdivision(const Four& sites) noexcept : exact_(sites) {
        known_.fill(unknown);
        for (std::size_t f = 0; f < Shape::facets; ++f) {
            by_[f] = 0;
            pinned_[f] = 1;
            for (std::uint8_t m = 1; m < 4; ++m) {
                const Sign sign = exact_.compare(f, m, by_[f]);
                if (sign < 0) continue;
                if (sign > 0) by_[f] = m;
                pinned_[f] = (sign > 0 ? 0U : pinned_[f]) | 1U << m;
            }
        }
    }

    [[nodiscard]] Spheres spheres() noexcept {
        Spheres result;
        FacetSet all = 0;
        for (std::size_t f = 0; f < Shape::facets; ++f) all = with(all, f);
        if (!touches_all(all)) {
            result.stage = exact_.stage();
            return result;
        }
        std::array<FacetSet, Shape::most_spheres> sets;
        for (const Basis& basis : bases<Shape>) {
            if (basis.determinant == 0 || is_known(basis.set)) continue;
            const FacetSet cell = cell_of(basis);
            if (cell == 0) continue;
            cells_[count_++] = cell;
            if (!touches_all(cell)) continue;
            if (has_side_that_touches_all(cell)) {
                result = {};
                result.infinitely_many = true;
                break;
            }
            insert<Shape>(result, sets, cell, {basis.facets, sites_of(basis)});
        }
        result.stage = exact_.stage();
        return result;
    }

 private:
    /// Whether the facets are those of a cell that was found before, or some of them.
    [[nodiscard]] bool is_known(FacetSet set) const noexcept {
        return std::any_of(cells_.begin(), cells_.begin() + static_cast<std::ptrdiff_t>(count_),
                           [&](FacetSet cell) { return (set & ~cell) == 0; });
    }
    [[nodiscard]] std::array<std::uint8_t, 4> sites_of(const Basis& basis) const noexcept {
        std::array<std::uint8_t, 4> by;
        for (std::size_t t = 0; t < 4; ++t) by[t] = by_[basis.facets[t]];
        return by;
    }
    /// All facets that the sphere in these four has, or none if it has another too far inside.
    [[nodiscard]] FacetSet cell_of(const Basis& basis) noexcept {
        const std::array<std::uint8_t, 4> by = sites_of(basis);
        FacetSet cell = basis.set;
        for (std::size_t f = 0; f < Shape::facets; ++f) {
            if (holds(basis.set, f)) continue;
            const Sign sign = excess(basis, by, f);
            if (sign > 0) return 0;
            if (sign == 0) cell = with(cell, f);
        }
        return cell;
    }
    /// Of M_f over the basis. The 58 bases of the octahedron have 20 relations, 12 of them of four
    /// facets.
    [[nodiscard]] Sign excess(const Basis& basis, const std::array<std::uint8_t, 4>& by,
                              std::size_t f) noexcept {
        std::int8_t& known = known_[basis.related[f]];
        if (known == unknown)
            known = static_cast<std::int8_t>(basis.sense[f] * exact_.excess(basis, by, f, by_[f]));
        return basis.sense[f] * known;
    }
    [[nodiscard]] bool touches_all(FacetSet set) const noexcept {
        unsigned touched = 0;
        for (std::size_t f = 0; f < Shape::facets; ++f)
            if (holds(set, f)) touched |= pinned_[f];
        return touched == 0b1111U;
    }
    /// A side of a cell is what a plane through three of its points has of them, if all others lie
    /// on one side of it.
    [[nodiscard]] bool has_side_that_touches_all(FacetSet cell) const noexcept {
        for (FacetSet a = cell; a != 0;) {
            const std::size_t first = take_first(a);
            for (FacetSet b = a; b != 0;) {
                const std::size_t second = take_first(b);
                for (FacetSet c = b; c != 0;) {
                    const std::size_t third = take_first(c);
                    FacetSet side = 0;
                    bool above = false, below = false;
                    for (FacetSet rest = cell; rest != 0;) {
                        const std::size_t f = take_first(rest);
                        const int turn = facets::determinant(
                            {facets::row_of<Shape>(first), facets::row_of<Shape>(second),
                             facets::row_of<Shape>(third), facets::row_of<Shape>(f)});
                        above |= turn > 0;
                        below |= turn < 0;
                        if (turn == 0) side = with(side, f);
                    }
                    if (above != below && touches_all(side)) return true;
                }
            }
        }
        return false;
    }

    static constexpr std::int8_t unknown = 2;

    Exact<Shape, 4> exact_;
    std::array<std::int8_t, 256> known_;          // by the facets of a relation
    std::array<std::uint8_t, Shape::facets> by_;  // a site that pins the facet
    std::array<unsigned, Shape::facets> pinned_;  // and the set of all
    std::array<FacetSet, Shape::most_cells> cells_;
    std::size_t count_ = 0;
};

template <class Shape>
[[nodiscard, gnu::cold, gnu::noinline]] Spheres decide_spheres(const Four& sites) noexcept {
    return exact::in_ieee_environment(
        [](const Four& given) { return Subdivision<Shape>(given).spheres(); }, sites);
}

/// The stages behind the filter, which is asked again, for it may have declined.
template <class Shape>
[[nodiscard, gnu::cold, gnu::noinline]] Decision decide_in_sphere(const Four& sites,
                                                                  const Contacts& sphere,
                                                                  const Site3& q) noexcept {
    return exact::in_ieee_environment(
        [](const Four& given, const Contacts& contacts, const Site3& query) -> Decision {
            const Basis& basis = basis_of_contacts<Shape>(contacts);
            Exact<Shape, 5> exact({given[0], given[1], given[2], given[3], query});
            Sign greatest = -1;
            for (std::size_t f = 0; f < Shape::facets && greatest <= 0; ++f)
                greatest = std::max(greatest, exact.excess(basis, contacts.sites, f, 4));
            return {-greatest, exact.stage()};
        },
        sites, sphere, q);
}
template <class Shape>
[[nodiscard, gnu::cold, gnu::noinline]] Decision decide_hides(const Site3& i,
                                                              const Site3& q) noexcept {
    return exact::in_ieee_environment(
        [](const Site3& one, const Site3& query) -> Decision {
            Exact<Shape, 2> exact({one, query});
            bool hides = true;
            for (std::size_t f = 0; f < Shape::facets && hides; ++f)
                hides = exact.compare(f, 1, 0) >= 0;
            return {hides ? 1 : -1, exact.stage()};
        },
        i, q);
}

}  // namespace

template <class Shape>
Spheres spheres(const Site3& i, const Site3& j, const Site3& k, const Site3& l) noexcept {
    SIGNUM_EXPECTS(are_finite(i, j, k, l));
    const Four sites = {i, j, k, l};
    Spheres result;
    if (filter_spheres<Shape>(sites, result)) [[likely]]
        return result;
    return decide_spheres<Shape>(sites);
}
template <class Shape>
Decision in_sphere_decision(const Site3& i, const Site3& j, const Site3& k, const Site3& l,
                            const Contacts& sphere, const Site3& q) noexcept {
    const Four sites = {i, j, k, l};
    const filters::Verdict verdict = filter_in_sphere<Shape>(sites, sphere, q);
    if (verdict.is_certain()) [[likely]]
        return {verdict.sign(), Stage::filter};
    return decide_in_sphere<Shape>(sites, sphere, q);
}
template <class Shape>
Decision hides_decision(const Site3& i, const Site3& q) noexcept {
    const filters::Verdict verdict = filter_hides<Shape>(i, q);
    if (verdict.is_certain()) [[likely]]
        return {verdict.sign(), Stage::filter};
    return decide_hides<Shape>(i, q);
}

#define SIGNUM_INSTANTIATE(Shape)                                                         \
    template Spheres spheres<Shape>(const Site3&, const Site3&, const Site3&,             \
                                    const Site3&) noexcept;                               \
    template Decision in_sphere_decision<Shape>(const Site3&, const Site3&, const Site3&, \
                                                const Site3&, const Contacts&,            \
                                                const Site3&) noexcept;                   \
    template Decision hides_decision<Shape>(const Site3&, const Site3&) noexcept;
SIGNUM_INSTANTIATE(Cube)
SIGNUM_INSTANTIATE(Octahedron)
#undef SIGNUM_INSTANTIATE

}  // namespace signum::rectangular

SIGNUM_IEEE_END
