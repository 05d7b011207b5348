#include "common.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "../../exact/floating_environment.hpp"
#include "../space/triangulate.hpp"
#include "../triangulate.hpp"
#include "few.hpp"
#include "part.hpp"

namespace signum::distributed {
namespace {

/// So small that sums of a few of them do not overflow.
constexpr double scale = 0x1p-3;

/// Those whose cells have no end, of some among which are all such; nothing where they have no
/// structure.
std::optional<std::vector<Placed>> endless_of(std::vector<Placed> candidates, const Kind& kind) {
    std::ranges::sort(candidates, {}, &Placed::id);
    std::vector<char> is_endless(candidates.size());
    bool has_structure = false;
    const auto look_at = [&](const auto& cells) {
        for (const auto& cell : cells) {
            const bool is_infinite = cell[0] == infinite;
            // Of sites on a line, in the power metric, all faces are at infinity.
            has_structure = has_structure || !is_infinite;
            for (std::size_t k = 1; is_infinite && k < cell.size(); ++k)
                is_endless[static_cast<std::size_t>(cell[k])] = 1;
        }
    };
    const auto built_of = [&]<class S>(const auto& site_of) {
        std::vector<S> sites;
        sites.reserve(candidates.size());
        for (const Placed& each : candidates) sites.push_back(site_of(each));
        return sites;
    };
    if (kind.dimension == 3) {
        with_kind(kind, [&]<class K>() {
            if constexpr (K::dimension == 3) {
                using S = typename K::S;
                const std::vector<S> sites = built_of.template operator()<S>(straight<K>);
                const SpaceTessellation built =
                    triangulate(std::span<const S>(sites), Power(), {.threads = 1});
                if (built.dimension == 3) look_at(built.cells);
            }
        });
    } else {
        const std::vector<Site> sites = built_of.template operator()<Site>(in_plane);
        const Tessellation built =
            triangulate({sites, kind.weight_is == WeightIs::weight}, kind.metric, {.threads = 1});
        look_at(built.faces());
        // Elsewhere two sites have a structure.
        if (!traits_of(kind.metric).edges_are_straight) has_structure = !built.faces().empty();
    }
    if (!has_structure) return std::nullopt;
    std::vector<Placed> result;
    for (std::size_t i = 0; i < candidates.size(); ++i)
        if (is_endless[i] != 0) result.push_back(candidates[i]);
    return result;
}

using Vector = std::array<double, axes>;

/// The faces of an octahedron, each cut into four at the middles of its edges.
std::vector<std::vector<Vector>> cones_of_space() {
    const auto middle = [](const Vector& a, const Vector& b) {
        return Vector{a[0] + b[0], a[1] + b[1], a[2] + b[2]};
    };
    std::vector<std::vector<Vector>> cones;
    for (int octant = 0; octant < 8; ++octant) {
        std::array<Vector, 3> g{};
        for (std::size_t axis = 0; axis < axes; ++axis)
            g[axis][axis] = (octant >> axis & 1) != 0 ? -1.0 : 1.0;
        const auto& [x, y, z] = g;
        const Vector xy = middle(x, y);
        const Vector yz = middle(y, z);
        const Vector zx = middle(z, x);
        cones.insert(cones.end(), {{x, xy, zx}, {y, yz, xy}, {z, zx, yz}, {xy, yz, zx}});
    }
    return cones;
}

/// Two vectors that follow one another around are a cone.
std::vector<std::vector<Vector>> cones_of_plane(Metric metric) {
    // Where a step along a diagonal is as long as one along an axis, or as two, the ball of the
    // norm is a square, and that of the dual norm has its corners on the axes, or on the diagonals.
    const double diagonal = with_metric(metric, []<class M>(M) {
        if constexpr (M::traits.edges_are_straight)
            return std::numbers::sqrt2;
        else
            return PredicatesOf<M>::norm(filters::Interval(1.0), filters::Interval(1.0)).high;
    });
    std::vector<Vector> around;
    if (diagonal < 1.25) {
        around = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
    } else if (diagonal > 1.75) {
        around = {{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}};
    } else {
        constexpr int directions = 8;
        for (int k = 0; k < directions; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / directions;
            around.push_back({std::cos(angle), std::sin(angle), 0.0});
        }
    }
    std::vector<std::vector<Vector>> cones;
    for (std::size_t k = 0; k < around.size(); ++k)
        cones.push_back({around[k], around[(k + 1) % around.size()]});
    return cones;
}

Extent point(const Site3& site) noexcept {
    return Extent::point({site.x, site.y, site.z, 0.0});
}

}  // namespace

Farthest::Farthest(const Kind& kind, const Extent& whole)
    : has_radii_(!traits_of(kind.metric).edges_are_straight),
      strips_(kind.dimension == 3 ? 12 : 512) {
    for (std::vector<Vector>& vectors :
         kind.dimension == 3 ? cones_of_space() : cones_of_plane(kind.metric))
        cones_.push_back({std::move(vectors), {}});
    for (Cone& cone : cones_)
        for (std::size_t k = 1; k < dimension(); ++k) {
            // Across is along the difference of a vector and the first one.
            Vector across;
            for (std::size_t axis = 0; axis < axes; ++axis)
                across[axis] = cone.vectors[k][axis] - cone.vectors[0][axis];
            const Vector back = {-across[0], -across[1], -across[2]};
            cone.range.push_back({-along({{back}, {}}, whole)[0], along({{across}, {}}, whole)[0]});
        }
    for (std::size_t k = 1; k < dimension(); ++k) strips_of_cone_ *= strips_;
    far_.resize(cones_.size() * strips_of_cone_);
}

std::array<double, axes> Farthest::along(const Cone& cone, const Extent& extent) noexcept {
    Vector out{};
    for (std::size_t k = 0; k < cone.vectors.size(); ++k)
        for (std::size_t axis = 0; axis < axes; ++axis) {
            const double g = cone.vectors[k][axis];
            out[k] += scale * (g > 0.0 ? extent.high[axis] : extent.low[axis]) * g;
        }
    return out;
}

std::size_t Farthest::strip(std::size_t cone, const Vector& out) const noexcept {
    std::size_t number = 0;
    for (std::size_t k = 1; k < dimension(); ++k) {
        const auto [low, high] = cones_[cone].range[k - 1];
        const auto count = static_cast<double>(strips_);
        const double place = high > low ? (out[k] - out[0] - low) / (high - low) * count : 0.0;
        number = number * strips_ + static_cast<std::size_t>(std::clamp(place, 0.0, count - 1.0));
    }
    return cone * strips_of_cone_ + number;
}

void Farthest::include(std::span<const Placed> sites) {
    const exact::IeeeEnvironment environment;
    const auto together = static_cast<double>(dimension());
    // A few for each strip suffice: more cost every part more than they spare it.
    const std::size_t step = std::max<std::size_t>(sites.size() / (4 * far_.size()), 1);
    for (std::size_t c = 0; c < cones_.size(); ++c) {
        for (std::size_t i = 0; i < sites.size(); i += step) {
            const Placed& each = sites[i];
            const Vector g = along(cones_[c], point(each.site));
            Far& far = far_[strip(c, g)];
            const double out =
                g[0] + g[1] + g[2] + (has_radii_ ? together * scale * each.site.r : 0.0);
            if (out > far.out) far = {each.site, out};
        }
        // Where a strip has none, one of another does.
        const auto begin = far_.begin() + static_cast<std::ptrdiff_t>(c * strips_of_cone_);
        for (std::size_t s = 1; s < strips_of_cone_; ++s)
            if (begin[s].out == -HUGE_VAL) begin[s] = begin[s - 1];
        for (std::size_t s = strips_of_cone_ - 1; s-- > 0;)
            if (begin[s].out == -HUGE_VAL) begin[s] = begin[s + 1];
    }
}

bool Farthest::is_beyond(std::size_t c, const Extent& extent) const noexcept {
    const Vector g = along(cones_[c], extent);
    const auto& [u, out] = far_[strip(c, g)];
    if (out == -HUGE_VAL) return false;
    const Vector of_u = along(cones_[c], point(u));
    const double radii =
        has_radii_ ? std::max(scale * extent.high[weight_place] - scale * u.r, 0.0) : 0.0;
    // A few roundings each, and some for a unit vector that is none.
    double magnitude = radii + scale * (std::fabs(u.x) + std::fabs(u.y) + std::fabs(u.z));
    for (std::size_t axis = 0; axis < axes; ++axis)
        magnitude += std::fabs(g[axis]) +
                     scale * (std::fabs(extent.low[axis]) + std::fabs(extent.high[axis]));
    const double slack = 0x1p-44 * magnitude + 0x1p-1000;
    for (std::size_t k = 0; k < dimension(); ++k)
        if (!(of_u[k] - g[k] > radii + slack)) return false;
    return true;
}

bool Farthest::have_an_end(const Extent& extent, std::size_t& first) const noexcept {
    for (std::size_t k = 0; k < cones_.size(); ++k) {
        const std::size_t c = (first + k) % cones_.size();
        if (is_beyond(c, extent)) continue;
        first = c;
        return false;
    }
    return true;
}

std::vector<Placed> endless_among(const SiteStore& store, const Farthest& farthest) {
    const exact::IeeeEnvironment environment;
    const auto may_be_endless = [](const Farthest& by) {
        // Extents that follow one another are near: mostly the same cone decides.
        return [&by, cone = std::size_t{0}](const Extent& extent) mutable {
            return !by.have_an_end(extent, cone);
        };
    };
    const std::vector<Placed> first = store.sites_where(may_be_endless(farthest));
    Farthest better = farthest;
    better.include(first);
    const SiteStore again = store.of(first);
    std::vector<Placed> candidates = again.sites_where(may_be_endless(better));
    return endless_of(candidates, store.kind()).value_or(candidates);
}

std::vector<Placed> greatest_of(std::span<const Placed> sites, const Kind& kind) {
    return with_kind(kind, [&]<class K>() {
        std::vector<Placed> result;
        // All that are no less than the least kept, thinned out now and then.
        double least = -HUGE_VAL;
        const auto thin_out = [&] {
            if (result.size() <= most_greatest) return;
            std::ranges::nth_element(result,
                                     result.begin() + static_cast<std::ptrdiff_t>(most_greatest),
                                     std::greater(), weight_of<K>);
            least = weight_of<K>(result[most_greatest]);
            std::erase_if(result, [&](const Placed& each) { return weight_of<K>(each) <= least; });
        };
        for (const Placed& each : sites) {
            if (!(weight_of<K>(each) > least)) continue;
            result.push_back(each);
            if (result.size() > 2 * most_greatest) thin_out();
        }
        thin_out();
        return result;
    });
}

std::vector<Placed> common_of(std::vector<Placed> endless, std::span<const Placed> greatest,
                              const Kind& kind) {
    std::optional<std::vector<Placed>> of_all = endless_of(std::move(endless), kind);
    if (!of_all)
        throw NoStructure(kind.dimension == 3
                              ? "the sites lie in one plane, or are hidden by one of them"
                              : "the sites lie on one line, or are hidden by one of them");
    std::vector<Placed> common = std::move(*of_all);
    const std::vector<Placed> more = greatest_of(greatest, kind);
    common.insert(common.end(), more.begin(), more.end());
    std::ranges::sort(common, {}, &Placed::id);
    const auto is_same = [](const Placed& a, const Placed& b) { return a.id == b.id; };
    common.erase(std::unique(common.begin(), common.end(), is_same), common.end());
    return common;
}

}  // namespace signum::distributed
