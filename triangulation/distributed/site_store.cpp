#include "site_store.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>
#include <stdexcept>
#include <string>

#include "../../exact/floating_environment.hpp"
#include "../insertion/edge_interior.hpp"
#include "../structure/spatial_order.hpp"
#include "few.hpp"

namespace signum::distributed {
namespace {

/// So many sites that follow one another have a box together, a block: a leaf of the tree.
constexpr std::size_t together = 64;
/// So many sites at most are told of one face: it goes with the first of them, and what comes in
/// its place is asked about anew.
constexpr std::size_t most = 4;

std::size_t blocks_of(std::span<const Placed> sites) noexcept {
    return (sites.size() + together - 1) / together;
}
std::span<const Placed> block_of(std::span<const Placed> sites, std::size_t block) noexcept {
    const std::size_t begin = block * together;
    return sites.subspan(begin, std::min(together, sites.size() - begin));
}

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
                if (!take(*entry.site)) return;
                continue;
            }
            const auto& node = *entry.node;
            if (node.second != 0) {
                look_at(*(entry.node + 1));
                look_at(tree_.nodes()[node.second]);
                continue;
            }
            for (const Placed& site : block_of(sites_, node.first))
                put(extent_of(site.site), {0.0, nullptr, &site});
        }
    }

 private:
    struct Entry {
        double key;
        const BoxTree<3>::Node* node;
        const Placed* site;
        [[nodiscard]] bool operator<(const Entry& other) const noexcept { return key > other.key; }
    };
    void look_at(const BoxTree<3>::Node& node) { put(node, {0.0, &node, nullptr}); }
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
        const std::size_t before = found.size();
        nearest.visit(extent_of<M, weight_is>, [&](const Placed& site) {
            if (std::ranges::find(face, site.id, &Placed::id) != face.end()) return true;
            Few<M, weight_is, 4> few({&face[0], &face[1], &face[2], &site});
            bool conflicts;
            if constexpr (M::traits.edges_are_straight)
                conflicts = few.kernel().conflicts(0, 1, 2, 3);
            else
                conflicts = few.kernel().conflicts_if_visible(0, 1, 2, 3);
            if (!conflicts) return true;
            found.push_back(site);
            return found.size() < before + most;
        });
    }

    void in_the_middle(const EdgeQuestion& edge, std::vector<Placed>& found) const {
        if constexpr (!M::traits.edges_are_straight) {
            const auto& [i, j, k, l] = edge;
            const Middle middle(i.site, j.site);
            const auto meets = [&](const Extent& extent) {
                return middle.may_be_taken_from(extent);
            };
            const std::size_t before = found.size();
            const auto never = [](const auto&, const auto&) { return false; };
            tree_.visit(meets, never, [&](const auto& node) {
                for (const Placed& site : block_of(sites_, node.first)) {
                    if (!meets(extent_of<M, weight_is>(site.site))) continue;
                    if (std::ranges::find(edge, site.id, &Placed::id) != edge.end()) continue;
                    Few<M, weight_is, 5> few({&i, &j, &k, &l, &site});
                    if (takes_middle(few.kernel(), k.id < 0 ? infinite : 2,
                                     l.id < 0 ? infinite : 3))
                        found.push_back(site);
                    if (found.size() == before + most) return false;
                }
                return true;
            });
        }
    }

    [[nodiscard]] Placed nearest_to(const Placed& hidden, Placed best) const {
        const Point p = {hidden.site.x, hidden.site.y};
        double high = nearness<M>(p, extent_of<M, weight_is>(best.site)).high;
        Nearest nearest(tree_, sites_, [&](const Extent& extent) -> std::optional<double> {
            const double low = nearness<M>(p, extent).low;
            if (low > high) return std::nullopt;
            return low;
        });
        nearest.visit(extent_of<M, weight_is>, [&](const Placed& site) {
            if (site.id == best.id || site.id == hidden.id) return true;
            Few<M, weight_is, 3> few({&hidden, &site, &best});
            if (few.kernel().is_nearer(0, 1, 2)) {
                best = site;
                high = nearness<M>(p, extent_of<M, weight_is>(best.site)).high;
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

void check(std::span<const Placed> sites, Metric metric, WeightIs weight_is) {
    if (weight_is == WeightIs::weight && !traits_of(metric).has_weights)
        throw std::invalid_argument(no_weights(metric));
    for (const auto& [site, id] : sites)
        if (!std::isfinite(site.x) || !std::isfinite(site.y) || !std::isfinite(site.r))
            throw std::invalid_argument("site " + std::to_string(id) + " is not finite");
}

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
        tree_ = {blocks_of(sites), 1, 0, [&](std::size_t block) {
                     Extent extent = no_extent();
                     for (const Placed& each : block_of(sites, block))
                         extent.include(extent_of<M, w>(each.site));
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
            for (const Placed& each : block_of(sites_, block))
                if (may_be(extent_of<M, w>(each.site))) result.push_back(each);
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
        const std::vector<Placed> in_box =
            sites_where([&](const Extent& extent) { return meet(extent, box); });
        answers.sites.insert(answers.sites.end(), in_box.begin(), in_box.end());
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
