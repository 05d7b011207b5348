#include "site_store.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>

#include "../../exact/floating_environment.hpp"
#include "../insertion/edge_interior.hpp"
#include "../structure/spatial_order.hpp"
#include "few.hpp"

namespace signum::distributed {
namespace {

/// So many sites that follow one another have a box together.
constexpr std::size_t together = 64;
/// So many sites at most are told of one face: it goes with the first of them, and what comes in
/// its place is asked about anew.
constexpr std::size_t most = 4;

/// Sites and boxes of sites, what is nearest first.
template <class Near>
class Nearest {
 public:
    Nearest(const BoxTree<3>& tree, std::span<const Placed> sites, const Near& near)
        : tree_(tree), sites_(sites), near_(near) {
        if (!tree.nodes().empty()) look_at(tree.nodes().front());
    }

    /// Calls take(site) for one after the other that near() does not leave out, until it returns
    /// false. near(extent) gives a number, the less the nearer, or NaN where all may be.
    template <class ExtentOf, class Take>
    void visit(const ExtentOf& extent_of, const Take& take) {
        while (!queue_.empty()) {
            const Entry entry = queue_.top();
            queue_.pop();
            if (entry.node == nullptr) {
                if (!take(sites_[entry.site])) return;
                continue;
            }
            const auto& node = *entry.node;
            if (node.second != 0) {
                look_at(*(entry.node + 1));
                look_at(tree_.nodes()[node.second]);
                continue;
            }
            const std::size_t end = std::min(sites_.size(), node.last * together);
            for (std::size_t i = node.first * together; i < end; ++i)
                put(extent_of(sites_[i].site), {0.0, nullptr, i});
        }
    }

 private:
    struct Entry {
        double key;
        const BoxTree<3>::Node* node;
        std::size_t site;
        [[nodiscard]] bool operator<(const Entry& other) const noexcept { return key > other.key; }
    };
    void look_at(const BoxTree<3>::Node& node) { put(node, {0.0, &node, 0}); }
    void put(const Extent& extent, Entry entry) {
        const std::optional<double> key = near_(extent);
        if (!key) return;
        entry.key = std::isnan(*key) ? -HUGE_VAL : *key;
        queue_.push(entry);
    }

    const BoxTree<3>& tree_;
    std::span<const Placed> sites_;
    Near near_;
    std::priority_queue<Entry> queue_;
};

template <class M, WeightIs weight_is>
class Answering {
 public:
    Answering(const BoxTree<3>& tree, std::span<const Placed> sites) : tree_(tree), sites_(sites) {}

    void conflicting(const std::array<Placed, 3>& face, std::vector<Placed>& found) const {
        const Ball<M, weight_is> ball(face);
        Nearest nearest(tree_, sites_, [&](const Extent& extent) -> std::optional<double> {
            const double excess = ball.excess(extent);
            if (excess > 0.0) return std::nullopt;
            return excess;
        });
        std::size_t count = 0;
        nearest.visit(extent_of<M, weight_is>, [&](const Placed& site) {
            for (const Placed& corner : face)
                if (corner.id == site.id) return true;
            Few<M, weight_is, 4> few({&face[0], &face[1], &face[2], &site});
            bool conflicts;
            if constexpr (M::traits.edges_are_straight)
                conflicts = few.kernel().conflicts(0, 1, 2, 3);
            else
                conflicts = few.kernel().conflicts_if_visible(0, 1, 2, 3);
            if (!conflicts) return true;
            found.push_back(site);
            return ++count < most;
        });
    }

    void in_the_middle(const EdgeQuestion& edge, std::vector<Placed>& found) const {
        if constexpr (!M::traits.edges_are_straight) {
            const auto& [i, j, k, l] = edge;
            const Middle middle(i.site, j.site);
            const auto meets = [&](const Extent& extent) {
                return middle.may_be_taken_from(extent);
            };
            std::size_t count = 0;
            const auto never = [](const auto&, const auto&) { return false; };
            tree_.visit(meets, never, [&](const auto& node) {
                const std::size_t end = std::min(node.last * together, sites_.size());
                for (std::size_t s = node.first * together; s < end; ++s) {
                    const Placed& site = sites_[s];
                    if (!meets(extent_of<M, weight_is>(site.site))) continue;
                    if (std::ranges::find(edge, site.id, &Placed::id) != edge.end()) continue;
                    Few<M, weight_is, 5> few({&i, &j, &k, &l, &site});
                    if (takes_middle(few.kernel(), k.id < 0 ? infinite : 2,
                                     l.id < 0 ? infinite : 3))
                        found.push_back(site), ++count;
                    if (count == most) return false;
                }
                return true;
            });
        }
    }

    [[nodiscard]] Placed nearest_to(const Placed& hidden, Placed best) const {
        const Point p = {hidden.site.x, hidden.site.y};
        double high = nearness<M>(p, extent_of<M, weight_is>(best.site)).high();
        Nearest nearest(tree_, sites_, [&](const Extent& extent) -> std::optional<double> {
            const double low = nearness<M>(p, extent).low();
            if (low > high) return std::nullopt;
            return low;
        });
        nearest.visit(extent_of<M, weight_is>, [&](const Placed& site) {
            if (site.id == best.id || site.id == hidden.id) return true;
            Few<M, weight_is, 3> few({&hidden, &site, &best});
            if (few.kernel().is_nearer(0, 1, 2)) {
                best = site;
                high = nearness<M>(p, extent_of<M, weight_is>(best.site)).high();
            }
            return true;
        });
        return best;
    }

 private:
    /// Whether site 4 takes the middle of the edge of 0 and 1 with 2 on its left and 3 on its
    /// right.
    template <class Kernel>
    [[nodiscard]] static bool takes_middle(Kernel& kernel, Index k, Index l) {
        constexpr Index q = 4;
        if (kernel.hides(0, q) || kernel.hides(1, q)) return false;
        triangulation::ExtendedKernel<Kernel> extended(kernel);
        return !extended.conflicts(0, 1, k, q) && !extended.conflicts(1, 0, l, q) &&
               triangulation::ends_within<Kernel>({0, 1, k, l}, kernel, q, false);
    }

    const BoxTree<3>& tree_;
    std::span<const Placed> sites_;
};

}  // namespace

void order_along_curve(std::span<Placed> sites) {
    if (sites.empty()) return;
    const StridedSites view(sites.size(), sizeof(Placed), &sites.front().site.x,
                            &sites.front().site.y);
    const LargeArray<Index> ranks = triangulation::ranks_along_curve(view, Workers(1));
    LargeArray<Placed> sorted(sites.size());
    for (std::size_t i = 0; i < sites.size(); ++i)
        sorted[static_cast<std::size_t>(ranks[i])] = sites[i];
    std::ranges::copy(sorted, sites.begin());
}

SiteStore::SiteStore(std::span<const Placed> sites, Metric metric, WeightIs weight_is)
    : sites_(sites), metric_(metric), weight_is_(weight_is), extent_(no_extent()) {
    with_kernel(metric, weight_is, [&]<class M, WeightIs w>() {
        tree_ = {(sites.size() + together - 1) / together, 1, 0, [&](std::size_t block) {
                     const std::size_t begin = block * together;
                     const std::size_t end = std::min(begin + together, sites.size());
                     Extent extent = no_extent();
                     for (std::size_t i = begin; i < end; ++i)
                         extent.include(extent_of<M, w>(sites[i].site));
                     return extent;
                 }};
    });
    if (!tree_.nodes().empty()) extent_ = tree_.nodes().front();
}

Extent SiteStore::extent_but(std::span<const Placed> some) const {
    return with_kernel(metric_, weight_is_, [&]<class M, WeightIs w>() {
        Extent extent = no_extent();
        for (const Placed& each : sites_)
            if (!std::ranges::binary_search(some, each.id, {}, &Placed::id))
                extent.include(extent_of<M, w>(each.site));
        return extent;
    });
}

std::vector<Placed> SiteStore::sites_where(const std::function<bool(const Extent&)>& may_be) const {
    return with_kernel(metric_, weight_is_, [&]<class M, WeightIs w>() {
        std::vector<Placed> result;
        tree_.visit(may_be, [&](std::uint32_t block) {
            const std::size_t end = std::min((block + 1) * together, sites_.size());
            for (std::size_t i = block * together; i < end; ++i)
                if (may_be(extent_of<M, w>(sites_[i].site))) result.push_back(sites_[i]);
        });
        return result;
    });
}

double SiteStore::spacing() const noexcept {
    if (sites_.empty()) return 0.0;
    const double share = 1.0 / std::sqrt(static_cast<double>(sites_.size()));
    return std::sqrt((extent_.high[0] * share - extent_.low[0] * share)) *
           std::sqrt((extent_.high[1] * share - extent_.low[1] * share));
}

Answers SiteStore::answer(const Questions& questions) const {
    const exact::IeeeEnvironment environment;
    Answers answers;
    for (const Extent& box : questions.boxes) {
        const auto meets = [&](const Extent& extent) {
            for (std::size_t axis = 0; axis < 2; ++axis)
                if (extent.low[axis] > box.high[axis] || extent.high[axis] < box.low[axis])
                    return false;
            return true;
        };
        tree_.visit(meets, [&](std::uint32_t block) {
            const std::size_t end = std::min((block + 1) * together, sites_.size());
            for (std::size_t i = block * together; i < end; ++i)
                if (meets(Extent::point({sites_[i].site.x, sites_[i].site.y, 0.0})))
                    answers.sites.push_back(sites_[i]);
        });
    }
    if (questions.faces.empty() && questions.edges.empty() && questions.hidden.empty())
        return answers;
    with_kernel(metric_, weight_is_, [&]<class M, WeightIs w>() {
        const Answering<M, w> answering(tree_, sites_);
        for (const auto& face : questions.faces) answering.conflicting(face, answers.sites);
        for (const auto& edge : questions.edges) answering.in_the_middle(edge, answers.sites);
        for (const auto& [hidden, by] : questions.hidden)
            answers.nearest.push_back(answering.nearest_to(hidden, by));
    });
    return answers;
}

}  // namespace signum::distributed
