#include "rectangular_space.hpp"

#include "linear_system.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace signum::oracle {
namespace {

/// A vector of 0, 1 and -1.
template <int D>
using Signs = std::array<int, static_cast<std::size_t>(D)>;

/// All axes' directions: the facets of the cube, the corners of the cross-polytope.
template <int D>
std::vector<Signs<D>> axes() {
    std::vector<Signs<D>> all;
    for (std::size_t x = 0; x < static_cast<std::size_t>(D); ++x)
        for (const int sign : {1, -1}) all.emplace_back()[x] = sign;
    return all;
}

/// All diagonals' directions: the corners of the cube, the facets of the cross-polytope.
template <int D>
std::vector<Signs<D>> diagonals() {
    std::vector<Signs<D>> all;
    for (unsigned mask = 0; mask < 1U << D; ++mask) {
        Signs<D>& signs = all.emplace_back();
        for (std::size_t x = 0; x < signs.size(); ++x) signs[x] = (mask >> x & 1U) != 0 ? -1 : 1;
    }
    return all;
}

template <int D>
Rational product(const Signs<D>& n, const std::array<Rational, static_cast<std::size_t>(D)>& v) {
    Rational sum = 0;
    for (std::size_t x = 0; x < v.size(); ++x) {
        if (n[x] > 0) sum += v[x];
        if (n[x] < 0) sum -= v[x];
    }
    return sum;
}

/// The unit ball of a metric: the points v with n·v <= 1 for all its facets n.
template <int D>
struct UnitBall {
    std::vector<Signs<D>> facets;
    std::vector<Signs<D>> corners;

    explicit UnitBall(RectangularMetric metric)
        : facets(metric == RectangularMetric::supremum ? axes<D>() : diagonals<D>()),
          corners(metric == RectangularMetric::supremum ? diagonals<D>() : axes<D>()) {}

    using Point = std::array<Rational, static_cast<std::size_t>(D)>;
    Rational distance(const Point& a, const Point& b) const {
        Point difference = a;
        for (std::size_t x = 0; x < a.size(); ++x) difference[x] -= b[x];
        Rational largest = 0;
        for (const Signs<D>& facet : facets)
            largest = std::max(largest, product<D>(facet, difference));
        return largest;
    }

    static bool is_on(const Signs<D>& corner, const Signs<D>& facet) {
        int sum = 0;
        for (std::size_t x = 0; x < corner.size(); ++x) sum += corner[x] * facet[x];
        return sum == 1;
    }
};

/// What touches D + 1 sites.
template <int D>
class RectangularTangency {
 public:
    RectangularTangency(RectangularMetric metric, const BallTuple<D>& sites)
        : ball_(metric), sites_(sites) {
        // n·(c - c_i) = rho + r_i
        for (const SpaceBall<D>& site : sites)
            for (const Signs<D>& facet : ball_.facets) {
                RationalVector& row = equations_.emplace_back(facet.begin(), facet.end());
                row.push_back(-1);
                row.push_back(site.r + product<D>(facet, site.c));
            }
    }

    RectangularSpheres<D> spheres() {
        choose(0);
        if (infinitely_many_) return {true, {}};
        return {false, {found_.begin(), found_.end()}};
    }

 private:
    static constexpr std::size_t unknowns = D + 1;  // c and rho

    /// Chooses the facets in which the sites from number `site` on are touched.
    void choose(std::size_t site) {
        if (site == sites_.size()) return touched_in_chosen();
        for (std::size_t facet = 0; facet < ball_.facets.size() && !infinitely_many_; ++facet) {
            chosen_.push_back(site * ball_.facets.size() + facet);
            choose(site + 1);
            chosen_.pop_back();
        }
    }

    /// The spheres that touch in the chosen facets are a polyhedron. It holds no line, for rho is
    /// not below -r_0, and where rho stays as it is c stays within a ball. So it is empty or has
    /// corners, which are found as the points where inequalities are equations, too. Where it has
    /// one corner alone, it is this point or goes to infinity.
    void touched_in_chosen() {
        std::set<RectangularSphere<D>> corners;
        add_corners(chosen_, 0, corners);
        if (corners.empty()) return;
        if (corners.size() > 1 || goes_to_infinity()) infinitely_many_ = true;
        found_.insert(corners.begin(), corners.end());
    }

    void add_corners(const std::vector<std::size_t>& equations, std::size_t next,
                     std::set<RectangularSphere<D>>& corners) const {
        std::vector<RationalVector> rows;
        for (const std::size_t equation : equations) rows.push_back(equations_[equation]);
        const std::optional<Flat> flat = solutions(std::move(rows), unknowns);
        if (!flat) return;
        if (flat->directions.empty()) {
            RectangularSphere<D> sphere;
            std::copy_n(flat->point.begin(), D, sphere.c.begin());
            sphere.rho = flat->point.back();
            if (touches_all(sphere)) corners.insert(sphere);
            return;
        }
        for (std::size_t more = next; more < equations_.size(); ++more) {
            if (!cuts(equations_[more], *flat)) continue;
            std::vector<std::size_t> with_more = equations;
            with_more.push_back(more);
            add_corners(with_more, more + 1, corners);
        }
    }

    /// Whether an equation holds in some points of a flat and not in others.
    static bool cuts(const RationalVector& equation, const Flat& flat) {
        return std::any_of(flat.directions.begin(), flat.directions.end(), [&](const auto& d) {
            Rational sum = 0;
            for (std::size_t x = 0; x < unknowns; ++x) sum += equation[x] * d[x];
            return !sum.is_zero();
        });
    }

    bool touches_all(const RectangularSphere<D>& sphere) const {
        return std::all_of(sites_.begin(), sites_.end(), [&](const SpaceBall<D>& site) {
            return ball_.distance(sphere.c, site.c) == sphere.rho + site.r;
        });
    }

    /// A ray in the direction (v, 1) touches in the chosen facets for ever where n·v = 1 for them,
    /// that is where v is a point of these facets of the unit ball. They share a corner then.
    bool goes_to_infinity() const {
        return std::any_of(ball_.corners.begin(), ball_.corners.end(), [&](const Signs<D>& corner) {
            return std::all_of(chosen_.begin(), chosen_.end(), [&](std::size_t equation) {
                return UnitBall<D>::is_on(corner, ball_.facets[equation % ball_.facets.size()]);
            });
        });
    }

    UnitBall<D> ball_;
    BallTuple<D> sites_;
    std::vector<RationalVector> equations_;  // of all sites and facets, one site after another
    std::vector<std::size_t> chosen_;        // a number of an equation for each site
    std::set<RectangularSphere<D>> found_;
    bool infinitely_many_ = false;
};

}  // namespace

template <int D>
RectangularSpheres<D> touching_spheres(RectangularMetric metric, const BallTuple<D>& sites) {
    return RectangularTangency<D>(metric, sites).spheres();
}

template <int D>
int side(RectangularMetric metric, const RectangularSphere<D>& sphere, const SpaceBall<D>& q) {
    return Rational(UnitBall<D>(metric).distance(sphere.c, q.c) - q.r - sphere.rho).sign();
}

template <int D>
std::vector<bool> hidden_sites(RectangularMetric metric, std::span<const SpaceBall<D>> sites) {
    const UnitBall<D> ball(metric);
    std::vector<bool> hidden(sites.size(), false);
    for (std::size_t i = 0; i < sites.size(); ++i)
        for (std::size_t j = 0; j < sites.size(); ++j)
            if (j != i && ball.distance(sites[i].c, sites[j].c) <= sites[j].r - sites[i].r &&
                (j < i || sites[j] != sites[i]))
                hidden[i] = true;
    return hidden;
}

template RectangularSpheres<2> touching_spheres<2>(RectangularMetric, const BallTuple<2>&);
template RectangularSpheres<3> touching_spheres<3>(RectangularMetric, const BallTuple<3>&);
template int side<2>(RectangularMetric, const RectangularSphere<2>&, const SpaceBall<2>&);
template int side<3>(RectangularMetric, const RectangularSphere<3>&, const SpaceBall<3>&);
template std::vector<bool> hidden_sites<2>(RectangularMetric, std::span<const SpaceBall<2>>);
template std::vector<bool> hidden_sites<3>(RectangularMetric, std::span<const SpaceBall<3>>);

}  // namespace signum::oracle
