#include "site_store.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>
#include <stdexcept>
#include <string>

#include "../../exact/floating_environment.hpp"
#include "../insertion/edge_interior.hpp"
#include "../structure/curve_order.hpp"
#include "few.hpp"

namespace signum::distributed {
namespace {

/// So many sites that follow one another have a box together, a block: a leaf of the tree.
constexpr std::size_t together = 16;
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
    Nearest(const BoxTree<4>& tree, std::span<const Placed> sites, const Near& near)
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
                put(extent_of(site), {0.0, nullptr, &site});
        }
    }

 private:
    struct Entry {
        double key;
        const BoxTree<4>::Node* node;
        const Placed* site;
        [[nodiscard]] bool operator<(const Entry& other) const noexcept { return key > other.key; }
    };
    void look_at(const BoxTree<4>::Node& node) { put(node, {0.0, &node, nullptr}); }
    void put(const Extent& extent, Entry entry) {
        const std::optional<double> key = near_(extent);
        if (!key) return;
        entry.key = std::isnan(*key) ? -HUGE_VAL : *key;
        queue_.push(entry);
    }

    const BoxTree<4>& tree_;
    std::span<const Placed> sites_;
    Near near_;
    std::priority_queue<Entry> queue_;
};

template <class K>
class Answering {
 public:
    Answering(const BoxTree<4>& tree, std::span<const Placed> sites) : tree_(tree), sites_(sites) {}

    void conflicting(const Corners& face, std::vector<Placed>& found) const {
        const Ball<K> ball(face);
        const std::size_t before = found.size();
        const auto take = [&](const Placed& site) {
            if (std::ranges::find(face, site.id, &Placed::id) != face.end()) return true;
            if (!conflicts<K>(face, site)) return true;
            found.push_back(site);
            return found.size() < before + most;
        };
        // Mostly none is near enough, though many boxes are: at the border of all sites balls are
        // large, and nearly empty. The first ones that are, as they come.
        constexpr std::size_t few = 64;
        std::array<std::pair<double, const Placed*>, few> near;
        std::size_t count = 0;
        const auto never = [](const auto&, const auto&) { return false; };
        const bool are_few =
            tree_.visit([&](const Extent& box) { return ball.may_be_reached_from(box); }, never,
                        [&](const auto& node) {
                            for (const Placed& site : block_of(sites_, node.first)) {
                                const double excess = ball.excess(extent_of<K>(site));
                                if (excess > 0.0) continue;
                                if (count == few) return false;
                                near[count++] = {std::isnan(excess) ? -HUGE_VAL : excess, &site};
                            }
                            return true;
                        });
        if (are_few) {
            std::ranges::sort(std::span(near).first(count), {},
                              [](const auto& each) { return each.first; });
            for (std::size_t k = 0; k < count && take(*near[k].second); ++k) continue;
            return;
        }
        Nearest nearest(tree_, sites_, [&](const Extent& extent) -> std::optional<double> {
            const double excess = ball.excess(extent);
            if (excess > 0.0) return std::nullopt;
            return excess;
        });
        nearest.visit(extent_of<K>, take);
    }

    void in_the_middle(const EdgeQuestion& edge, std::vector<Placed>& found) const {
        if constexpr (!K::is_straight) {
            const Placed& i = edge[0];
            const Placed& j = edge[1];
            const Placed& k = edge[2];
            const Placed& l = edge[3];
            const Middle middle = Middle::between_faces<K>(edge);
            const auto meets = [&](const Extent& extent) {
                return middle.may_be_taken_from(extent);
            };
            const std::size_t before = found.size();
            const auto never = [](const auto&, const auto&) { return false; };
            tree_.visit(meets, never, [&](const auto& node) {
                for (const Placed& site : block_of(sites_, node.first)) {
                    if (!meets(extent_of<K>(site))) continue;
                    if (std::ranges::find(edge, site.id, &Placed::id) != edge.end()) continue;
                    Few<K, 5> few({&i, &j, &k, &l, &site});
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
        const Point3 p = place_of(hidden);
        double high = nearness<K>(p, extent_of<K>(best)).high;
        Nearest nearest(tree_, sites_, [&](const Extent& extent) -> std::optional<double> {
            const double low = nearness<K>(p, extent).low;
            if (low > high) return std::nullopt;
            return low;
        });
        nearest.visit(extent_of<K>, [&](const Placed& site) {
            if (site.id == best.id || site.id == hidden.id) return true;
            if (is_nearer<K>(hidden, site, best)) {
                best = site;
                high = nearness<K>(p, extent_of<K>(best)).high;
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

    const BoxTree<4>& tree_;
    std::span<const Placed> sites_;
};

}  // namespace

void check(std::span<const Placed> sites, const Kind& kind) {
    if (kind.weight_is == WeightIs::weight && !traits_of(kind.metric).has_weights)
        throw std::invalid_argument(no_weights(kind.metric));
    if (kind.dimension == 3 && !traits_of(kind.metric).edges_are_straight)
        throw std::invalid_argument("of space the power metric alone is known");
    for (const auto& [site, id] : sites)
        if (!are_finite(site))
            throw std::invalid_argument("site " + std::to_string(id) + " is not finite");
}

void order_along_curve(std::span<Placed> sites, const Kind& kind) {
    const CurveKeys layout = kind.dimension == 3 ? CurveKeys{32, 10} : CurveKeys{32, 16};
    LargeArray<std::uint64_t> keys(sites.size());
    for (std::size_t i = 0; i < sites.size(); ++i) keys[i] = i;
    if (kind.dimension == 3)
        sort_along_curve<3>(
            std::span(keys), layout,
            [&](std::size_t i) {
                const auto& [x, y, z] = place_of(sites[i]);
                return std::array{x, y, z};
            },
            Workers(1));
    else
        sort_along_curve<2>(
            std::span(keys), layout,
            [&](std::size_t i) {
                return std::array{sites[i].site.x, sites[i].site.y};
            },
            Workers(1));
    LargeArray<Placed> sorted(sites.size());
    for (std::size_t i = 0; i < sites.size(); ++i) sorted[i] = sites[layout.item(keys[i])];
    std::ranges::copy(sorted, sites.begin());
}

SiteStore::SiteStore(std::span<const Placed> sites, const Kind& kind)
    : sites_(sites), kind_(kind), extent_(no_extent()) {
    with_kind(kind, [&]<class K>() {
        tree_ = {blocks_of(sites), 1, 0, [&](std::size_t block) {
                     Extent extent = no_extent();
                     for (const Placed& each : block_of(sites, block))
                         extent.include(extent_of<K>(each));
                     return extent;
                 }};
    });
    if (!tree_.nodes().empty()) extent_ = tree_.nodes().front();
}

Extent SiteStore::extent_but(std::span<const Placed> some) const {
    return with_kind(kind_, [&]<class K>() {
        Extent extent = no_extent();
        for (const Placed& each : sites_)
            if (!std::ranges::binary_search(some, each.id, {}, &Placed::id))
                extent.include(extent_of<K>(each));
        return extent;
    });
}

std::vector<Placed> SiteStore::sites_where(const std::function<bool(const Extent&)>& may_be) const {
    return with_kind(kind_, [&]<class K>() {
        std::vector<Placed> result;
        tree_.visit(may_be, [&](std::uint32_t block) {
            for (const Placed& each : block_of(sites_, block))
                if (may_be(extent_of<K>(each))) result.push_back(each);
        });
        return result;
    });
}

double SiteStore::spacing() const noexcept {
    if (sites_.empty()) return 0.0;
    const auto root = [&](double number) {
        return kind_.dimension == 3 ? std::cbrt(number) : std::sqrt(number);
    };
    const double share = 1.0 / root(static_cast<double>(sites_.size()));
    double spacing = 1.0;
    for (std::size_t axis = 0; axis < kind_.dimension; ++axis)
        spacing *= root(extent_.high[axis] * share - extent_.low[axis] * share);
    return spacing;
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
    with_kind(kind_, [&]<class K>() {
        const Answering<K> answering(tree_, sites_);
        for (const auto& face : questions.faces) answering.conflicting(face, answers.sites);
        for (const auto& edge : questions.edges) answering.in_the_middle(edge, answers.sites);
        for (const auto& [hidden, by] : questions.hidden)
            answers.nearest.push_back(answering.nearest_to(hidden, by));
    });
    return answers;
}

}  // namespace signum::distributed
