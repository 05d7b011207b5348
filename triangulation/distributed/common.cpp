#include "common.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "../../exact/floating_environment.hpp"
#include "../triangulate.hpp"
#include "few.hpp"
#include "part.hpp"

namespace signum::distributed {
namespace {

/// So small that sums of a few of them do not overflow.
constexpr double scale = 0x1p-3;

/// Those whose cells have no end, of some that are all such of the whole.
std::vector<Placed> endless_of(std::vector<Placed> candidates, Metric metric, WeightIs weight_is) {
    std::ranges::sort(candidates, {}, &Placed::id);
    std::vector<Site> sites;
    sites.reserve(candidates.size());
    for (const Placed& each : candidates) sites.push_back(each.site);
    const Tessellation built =
        triangulate({sites, weight_is == WeightIs::weight}, metric, {.threads = 1});
    std::vector<char> is_endless(sites.size());
    bool is_flat = true;
    for (const Face& face : built.faces()) {
        if (face[0] != infinite) is_flat = false;
        if (face[0] == infinite)
            for (const Index v : {face[1], face[2]}) is_endless[static_cast<std::size_t>(v)] = 1;
    }
    if (built.faces().empty() || (is_flat && traits_of(metric).edges_are_straight))
        throw NoStructure("the sites lie on one line, or are hidden by one of them");
    std::vector<Placed> result;
    for (std::size_t i = 0; i < sites.size(); ++i)
        if (is_endless[i] != 0) result.push_back(candidates[i]);
    return result;
}

}  // namespace

Farthest::Farthest(Metric metric, const Extent& whole)
    : has_radii_(!traits_of(metric).edges_are_straight) {
    // Where a step along a diagonal is as long as one along an axis, or as two, the ball of the
    // norm is a square, and that of the dual norm has its corners on the axes, or on the diagonals.
    const double diagonal = with_metric(metric, []<class M>(M) {
        if constexpr (M::traits.edges_are_straight)
            return std::numbers::sqrt2;
        else
            return PredicatesOf<M>::norm(filters::Interval(1.0), filters::Interval(1.0)).high;
    });
    if (diagonal < 1.25) {
        vectors_ = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    } else if (diagonal > 1.75) {
        vectors_ = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
    } else {
        constexpr int directions = 8;
        for (int k = 0; k < directions; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / directions;
            vectors_.push_back({std::cos(angle), std::sin(angle)});
        }
    }
    far_.resize(vectors_.size() * strips);
    for (std::size_t k = 0; k < vectors_.size(); ++k) {
        const std::size_t half = vectors_.size() / 2;
        // -g is one of the vectors, too.
        across_.push_back({-most_along(k + 1 + half, whole) - most_along(k, whole),
                           most_along(k + 1, whole) + most_along(k + half, whole)});
    }
}

double Farthest::most_along(std::size_t k, const Extent& extent) const noexcept {
    const Point& g = vectors_[k % vectors_.size()];
    return scale * (g.x > 0 ? extent.high[0] : extent.low[0]) * g.x +
           scale * (g.y > 0 ? extent.high[1] : extent.low[1]) * g.y;
}

double Farthest::along(std::size_t k, const Site& site) const noexcept {
    const Point& g = vectors_[k % vectors_.size()];
    return scale * site.x * g.x + scale * site.y * g.y;
}

std::size_t Farthest::strip(std::size_t k, double across) const noexcept {
    const auto [low, high] = across_[k];
    if (!(high > low)) return k * strips;
    const double place = (across - low) / (high - low) * static_cast<double>(strips);
    return k * strips + static_cast<std::size_t>(std::clamp(place, 0.0, strips - 1.0));
}

void Farthest::include(std::span<const Placed> sites) {
    const exact::IeeeEnvironment environment;
    for (std::size_t k = 0; k < vectors_.size(); ++k) {
        for (const Placed& each : sites) {
            const double g = along(k, each.site);
            const double next = along(k + 1, each.site);
            Far& far = far_[strip(k, next - g)];
            const double out = g + next + (has_radii_ ? 2.0 * scale * each.site.r : 0.0);
            if (out > far.out) far = {each.site, out};
        }
        // Where a strip has none, one of another does.
        const auto begin = far_.begin() + static_cast<std::ptrdiff_t>(k * strips);
        for (std::size_t s = 1; s < strips; ++s)
            if (begin[s].out == -HUGE_VAL) begin[s] = begin[s - 1];
        for (std::size_t s = strips - 1; s-- > 0;)
            if (begin[s].out == -HUGE_VAL) begin[s] = begin[s + 1];
    }
}

bool Farthest::have_an_end(const Extent& extent) const noexcept {
    for (std::size_t k = 0; k < vectors_.size(); ++k) {
        const double g = most_along(k, extent);
        const double next = most_along(k + 1, extent);
        const auto& [u, out] = far_[strip(k, next - g)];
        if (out == -HUGE_VAL) return false;
        const double most = extent.high[2];
        const double radii = has_radii_ ? std::max(scale * most - scale * u.r, 0.0) : 0.0;
        // A few roundings each, and some for a unit vector that is none.
        const double slack =
            0x1p-44 * (std::fabs(g) + std::fabs(next) + radii +
                       scale * (std::fabs(u.x) + std::fabs(u.y) + std::fabs(extent.low[0]) +
                                std::fabs(extent.high[0]) + std::fabs(extent.low[1]) +
                                std::fabs(extent.high[1]))) +
            0x1p-1000;
        if (!(along(k, u) - g > radii + slack && along(k + 1, u) - next > radii + slack))
            return false;
    }
    return true;
}

std::vector<Placed> endless_among(const SiteStore& store, const Farthest& farthest) {
    const exact::IeeeEnvironment environment;
    const auto may_be_endless = [](const Farthest& by) {
        return [&by](const Extent& extent) { return !by.have_an_end(extent); };
    };
    const std::vector<Placed> first = store.sites_where(may_be_endless(farthest));
    Farthest better = farthest;
    better.include(first);
    const SiteStore again = store.of(first);
    return again.sites_where(may_be_endless(better));
}

std::vector<Placed> greatest_of(std::span<const Placed> sites, Metric metric, WeightIs weight_is) {
    return with_kernel(metric, weight_is, [&]<class M, WeightIs w>() {
        const auto third = [](const Placed& each) { return third_of<M, w>(each.site); };
        std::vector<Placed> result;
        // All that are no less than the least kept, thinned out now and then.
        double least = -HUGE_VAL;
        const auto thin_out = [&] {
            if (result.size() <= most_greatest) return;
            std::ranges::nth_element(result,
                                     result.begin() + static_cast<std::ptrdiff_t>(most_greatest),
                                     std::greater(), third);
            least = third(result[most_greatest]);
            std::erase_if(result, [&](const Placed& each) { return third(each) <= least; });
        };
        for (const Placed& each : sites) {
            if (!(third(each) > least)) continue;
            result.push_back(each);
            if (result.size() > 2 * most_greatest) thin_out();
        }
        thin_out();
        return result;
    });
}

std::vector<Placed> common_of(std::vector<Placed> endless, std::span<const Placed> greatest,
                              Metric metric, WeightIs weight_is) {
    std::vector<Placed> common = endless_of(std::move(endless), metric, weight_is);
    const std::vector<Placed> more = greatest_of(greatest, metric, weight_is);
    common.insert(common.end(), more.begin(), more.end());
    std::ranges::sort(common, {}, &Placed::id);
    const auto same = std::ranges::unique(common, {}, &Placed::id);
    common.erase(same.begin(), same.end());
    return common;
}

}  // namespace signum::distributed
