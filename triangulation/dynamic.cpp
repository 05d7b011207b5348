#include "dynamic.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "../core/contract.hpp"
#include "../exact/floating_environment.hpp"
#include "../predicates/euclidean.hpp"
#include "../predicates/manhattan.hpp"
#include "../predicates/supremum.hpp"
#include "insertion/delete.hpp"
#include "insertion/hiders.hpp"
#include "insertion/insert.hpp"
#include "kernels/additive_kernel.hpp"
#include "kernels/power_kernel.hpp"
#include "kernels/predicates_of.hpp"
#include "structure/assemble.hpp"
#include "triangulate.hpp"

namespace signum {
namespace triangulation {
namespace {

std::size_t at(Index i) noexcept {
    return static_cast<std::size_t>(i);
}

/// Places in the tie rule's order that leave room between them: only their order counts.
class Ranks {
 public:
    explicit Ranks(std::vector<RankedSite>& sites) : sites_(sites), order_(Before{&sites}) {}

    void insert(Index site) {
        const auto place = order_.insert(site).first;
        const std::int64_t below =
            place == order_.begin() ? -1 : sites_[at(*std::prev(place))].rank;
        const std::int64_t above = std::next(place) == order_.end()
                                       ? std::numeric_limits<Index>::max()
                                       : sites_[at(*std::next(place))].rank;
        if (above - below < 2) {
            spread();
        } else {
            sites_[at(site)].rank = static_cast<Index>(below + (above - below) / 2);
        }
    }
    void erase(Index site) { order_.erase(site); }
    [[nodiscard]] Index first() const { return *order_.begin(); }

 private:
    struct Before {
        const std::vector<RankedSite>* sites;
        bool operator()(Index a, Index b) const {
            return additive::precedes((*sites)[at(a)], a, (*sites)[at(b)], b);
        }
    };
    void spread() {
        const std::int64_t step =
            std::numeric_limits<Index>::max() / static_cast<std::int64_t>(order_.size() + 1);
        std::int64_t rank = 0;
        for (const Index site : order_) sites_[at(site)].rank = static_cast<Index>(rank += step);
    }

    std::vector<RankedSite>& sites_;
    std::set<Index, Before> order_;
};

/// The sites of one metric and their tessellation.
///
/// Laws:
///  1. While it is built, topology_ is the tessellation of the live sites that are visible, and
///     hidden_by_ is -1 for these alone; kept_[u] has the hidden sites with hidden_by_ = u.
///     face_of_ is a face at a visible site, and -1 for every other handle.
///  2. Additive metrics: u hides what it keeps, whether it is visible itself or not. Power metric:
///     u is visible, and a corner of a face that contains the centres of what it keeps. So a hidden
///     site can reappear only where one goes that keeps it, or, in the power metric, where its face
///     goes.
template <class Kernel>
class Live {
 public:
    using S = typename Kernel::SiteType;
    static constexpr bool is_straight = Kernel::is_straight;

    explicit Live(Metric metric) : metric_(metric), ranks_(sites_) { grow(16); }
    Live(const Live&) = delete;
    Live& operator=(const Live&) = delete;

    [[nodiscard]] bool contains(Index h) const noexcept {
        return h >= 0 && at(h) < live_.size() && live_[at(h)];
    }
    [[nodiscard]] std::size_t size() const noexcept { return count_; }
    [[nodiscard]] std::size_t rebuilds() const noexcept { return rebuilds_; }
    [[nodiscard]] Site site(Index h) const noexcept {
        const S& s = sites_[at(h)];
        if constexpr (requires { s.w; })
            return {s.x, s.y, s.w};
        else
            return {s.x, s.y, s.r};
    }

    Index insert(const Site& site) {
        Index h = 0;
        if (free_.empty()) {
            h = static_cast<Index>(count_);
        } else {
            h = *free_.begin();
            free_.erase(free_.begin());
        }
        const bool is_full = at(h) == live_.size();
        if (is_full) grow(2 * live_.size());
        put(h, site);
        if (is_full || !is_built_)
            build();
        else
            add(h);
        return h;
    }

    void erase(Index h) {
        take(h);
        free_.insert(h);
    }

    void change(Index h, double third) {
        Site site = this->site(h);
        site.r = third;
        take(h);
        put(h, site);
        if (is_built_)
            add(h);
        else
            build();
    }

    [[nodiscard]] Tessellation tessellation() const {
        std::vector<Site> live;
        std::vector<Index> number(live_.size(), -1);
        for (Index h = 0; at(h) < live_.size(); ++h)
            if (live_[at(h)]) {
                number[at(h)] = static_cast<Index>(live.size());
                live.push_back(site(h));
            }
        constexpr bool weighted = requires(S s) {
            s.w;
        };
        const WeightIs weight_is = weighted ? WeightIs::weight : WeightIs::radius;
        if (live.empty()) return triangulate(StridedSites{}, metric_);
        if (!is_built_) {
            const Site* first = live.data();
            return triangulate(
                StridedSites(live.size(), sizeof(Site), &first->x, &first->y, &first->r, weighted),
                metric_);
        }
        std::vector<Index> hidden_by = hidden_by_;
        settle_hiders(*topology_, *kernel_, hidden_by);
        TessellationArrays arrays;
        arrays.metric = metric_;
        arrays.weight_is = weight_is;
        arrays.sites = static_cast<std::int64_t>(live.size());
        for (Index h = 0; at(h) < live_.size(); ++h)
            if (live_[at(h)] && hidden_by[at(h)] >= 0)
                arrays.hidden.push_back({number[at(h)], number[at(hidden_by[at(h)])]});
        assemble(Topology(*topology_), number, arrays);
        return {std::move(arrays), std::move(live), {}};
    }

 private:
    void put(Index h, const Site& site) {
        if constexpr (is_straight) {
            sites_[at(h)] = S{site.x, site.y, site.r};
        } else {
            sites_[at(h)] = {site, 0};
            ranks_.insert(h);
        }
        live_[at(h)] = true;
        hidden_by_[at(h)] = -1;
        face_of_[at(h)] = -1;
        ++count_;
    }

    void grow(std::size_t capacity) {
        is_built_ = false;
        sites_.resize(capacity);
        live_.resize(capacity, false);
        hidden_by_.resize(capacity, -1);
        none_hidden_.resize(capacity, -1);
        face_of_.resize(capacity, -1);
        kept_.resize(capacity);
        numbers_.resize(capacity);
        std::iota(numbers_.begin(), numbers_.end(), 0);
        insertion_.reset();
        if constexpr (is_straight)
            kernel_ = std::make_unique<Kernel>(sites_.data(), numbers_.data());
        else
            kernel_ = std::make_unique<Kernel>(sites_.data());
    }

    /// From scratch; leaves is_built_ false where there is no structure.
    void build() {
        is_built_ = false;
        ++rebuilds_;
        std::fill(hidden_by_.begin(), hidden_by_.end(), -1);
        std::fill(face_of_.begin(), face_of_.end(), -1);
        for (auto& kept : kept_) kept.clear();
        insertion_.reset();
        topology_ = std::make_unique<Topology>(live_.size());
        std::vector<Index> rest;
        for (Index h = 0; at(h) < live_.size(); ++h)
            if (live_[at(h)]) rest.push_back(h);
        if (!lead(rest)) return;
        is_built_ = true;
        for (Index f = 0; f < topology_->faces(); ++f) note_face(f);
        for (const Index h : rest) add(h);
    }

    /// Starts with the first sites and takes them out of the list.
    bool lead(std::vector<Index>& rest) {
        if constexpr (is_straight) {
            for (std::size_t b = 1; b < rest.size(); ++b) {
                if (kernel_->centre(rest[0]) == kernel_->centre(rest[b])) continue;
                for (std::size_t c = 1; c < rest.size(); ++c) {
                    const Sign side = kernel_->ccw(rest[0], rest[b], rest[c]);
                    if (side == 0) continue;
                    const Index first = rest[0];
                    const Index second = rest[side > 0 ? b : c];
                    const Index third = rest[side > 0 ? c : b];
                    insertion_ = std::make_unique<Insertion<Kernel>>(
                        *topology_, *kernel_, hidden_by_, first, second, third);
                    std::erase_if(rest,
                                  [&](Index h) { return h == first || h == second || h == third; });
                    return true;
                }
                return false;
            }
            return false;
        } else {
            if (rest.empty()) return false;
            const Index first = ranks_.first();
            const auto second = std::find_if(rest.begin(), rest.end(), [&](Index h) {
                return h != first && !kernel_->hides(first, h);
            });
            if (second == rest.end()) return false;
            const Index other = *second;
            insertion_ =
                std::make_unique<Insertion<Kernel>>(*topology_, *kernel_, hidden_by_, first, other);
            std::erase_if(rest, [&](Index h) { return h == first || h == other; });
            return true;
        }
    }

    void note_face(Index f) {
        for (const Index v : topology_->vertices(f))
            if (v >= 0) face_of_[at(v)] = f;
    }

    [[nodiscard]] HalfEdge spoke_of(Index v) const { return topology_->spoke(face_of_[at(v)], v); }

    void keep(Index by, Index hidden) {
        hidden_by_[at(hidden)] = by;
        face_of_[at(hidden)] = -1;
        kept_[at(by)].push_back(hidden);
    }

    /// A face from which it is not far to a new site: that of the nearest of some 2n^(1/3) sites,
    /// or of the site changed last. From there a walk takes O(n^(1/3)) steps on uniform sites
    /// (Mücke, Saias and Zhu 1999), from a face anywhere O(n^(1/2)), and O(n) where sites lie on
    /// curves.
    [[nodiscard]] Index face_near(const S& site) const noexcept {
        const auto distance = [&](Index v) {
            const double x = sites_[at(v)].x - site.x;
            const double y = sites_[at(v)].y - site.y;
            return x * x + y * y;
        };
        Index best = insertion_->recent();
        double least = std::numeric_limits<double>::infinity();
        for (int k = 0; k < 3; ++k)
            if (const Index v = topology_->vertices(best)[k]; v != infinite)
                least = std::min(least, distance(v));
        const std::uint64_t handles = count_ + free_.size();
        const auto samples =
            static_cast<std::uint64_t>(2.0 * std::cbrt(static_cast<double>(handles)));
        for (std::uint64_t i = 0; i < samples; ++i) {
            // Multiples of the golden section are spread evenly.
            const std::uint64_t fraction = i * 0x9E37'79B9'7F4A'7C15U >> 32;
            const auto v = static_cast<Index>(fraction * handles >> 32);
            if (face_of_[at(v)] < 0) continue;
            const double d = distance(v);
            if (d < least) {
                least = d;
                best = face_of_[at(v)];
            }
        }
        return best;
    }

    /// Inserts a live site into what is built; false where all was built anew instead, with every
    /// live site.
    bool add(Index h) {
        hidden_by_[at(h)] = -1;
        insertion_->start_from(face_near(sites_[at(h)]));
        if (!insertion_->insert(h)) {
            build();
            return false;
        }
        if (const Index by = hidden_by_[at(h)]; by >= 0) {
            kept_[at(by)].push_back(h);
            return true;
        }
        for (const Index v : insertion_->enclosed()) {
            keep(h, v);
            if constexpr (is_straight)
                for (const Index of_v : std::exchange(kept_[at(v)], {})) keep(h, of_v);
        }
        face_of_[at(h)] = insertion_->recent();
        for (const HalfEdge of : topology_->fan(spoke_of(h))) note_face(Topology::face(of));
        if constexpr (is_straight)
            for (const Index hidden : taken_from_star(h)) keep(h, hidden);
        return true;
    }

    /// The hidden sites whose centres lie in the star of h, out of those that its neighbours keep.
    [[nodiscard]] std::vector<Index> taken_from_star(Index h) {
        std::vector<Index> taken;
        const HalfEdge spoke = spoke_of(h);
        for (const HalfEdge of : topology_->fan(spoke)) {
            const Index u = topology_->target(of);
            if (u == infinite || kept_[at(u)].empty()) continue;
            std::erase_if(kept_[at(u)], [&](Index hidden) {
                bool inside = false;
                for (const HalfEdge face : topology_->fan(spoke)) {
                    const Index a = topology_->target(face);
                    const Index b = topology_->apex(face);
                    inside = inside ||
                             (a != infinite && b != infinite && kernel_->ccw(h, a, hidden) >= 0 &&
                              kernel_->ccw(a, b, hidden) >= 0 && kernel_->ccw(b, h, hidden) >= 0);
                }
                if (inside) taken.push_back(hidden);
                return inside;
            });
        }
        return taken;
    }

    /// Out of the sites and out of what is built.
    void take(Index h) {
        std::vector<Index> freed;
        bool is_whole = is_built_;
        if (is_built_) {
            freed = std::exchange(kept_[at(h)], {});
            if (const Index by = hidden_by_[at(h)]; by >= 0) {
                std::erase(kept_[at(by)], h);
            } else {
                if constexpr (is_straight)
                    for (const Index hidden : taken_from_star(h)) freed.push_back(hidden);
                std::vector<Index> ring;
                const HalfEdge spoke = spoke_of(h);
                for (const HalfEdge of : topology_->fan(spoke))
                    ring.push_back(topology_->target(of));
                is_whole = Deletion<Kernel>(*insertion_, none_hidden_).erase(spoke);
                if (is_whole) note_faces_at(ring);
            }
        }
        live_[at(h)] = false;
        hidden_by_[at(h)] = -1;
        face_of_[at(h)] = -1;
        if constexpr (!is_straight) ranks_.erase(h);
        --count_;
        if (!is_whole) {
            if (is_built_) build();
            return;
        }
        // The earlier in the rule's order, the less often a site is hidden again.
        std::sort(freed.begin(), freed.end(), [&](Index a, Index b) { return precedes(a, b); });
        for (const Index site : freed)
            if (!add(site)) return;
    }

    [[nodiscard]] bool precedes(Index a, Index b) const {
        if constexpr (is_straight)
            return a != b && kernel_->precedes(a, b);
        else
            return sites_[at(a)].rank < sites_[at(b)].rank;
    }

    /// The faces of a patch are walked from a face that was outside of it.
    void note_faces_at(const std::vector<Index>& ring) {
        note_face(insertion_->recent());
        // From one vertex of the ring whose face is known to the next ones.
        std::vector<Index> pending(topology_->vertices(insertion_->recent()),
                                   topology_->vertices(insertion_->recent()) + 3);
        std::vector<Index> open = ring;
        while (!pending.empty() && !open.empty()) {
            const Index v = pending.back();
            pending.pop_back();
            if (v == infinite || std::erase(open, v) == 0) continue;
            for (const HalfEdge of : topology_->fan(spoke_of(v))) {
                note_face(Topology::face(of));
                const Index u = topology_->target(of);
                if (std::find(open.begin(), open.end(), u) != open.end()) pending.push_back(u);
            }
        }
    }

    Metric metric_;
    std::vector<S> sites_;
    std::vector<bool> live_;
    std::vector<Index> hidden_by_;
    std::vector<Index> none_hidden_;
    std::vector<Index> face_of_;
    std::vector<std::vector<Index>> kept_;
    std::vector<Index> numbers_;
    std::set<Index> free_;
    std::size_t count_ = 0;
    std::size_t rebuilds_ = 0;
    bool is_built_ = false;
    struct NoRanks {
        explicit NoRanks(std::vector<S>&) {}
    };
    [[no_unique_address]] std::conditional_t<is_straight, NoRanks, Ranks> ranks_;
    std::unique_ptr<Kernel> kernel_;
    std::unique_ptr<Topology> topology_;
    std::unique_ptr<Insertion<Kernel>> insertion_;
};

template <template <additive::Stages> class Predicates>
using LiveAdditive =
    Live<AdditiveKernel<Predicates<additive::Stages::exact>, Arithmetic::exact, filters::NoTally>>;
template <class S>
using LivePower = Live<PowerKernel<S, Arithmetic::exact, filters::NoTally>>;

}  // namespace
}  // namespace triangulation

class DynamicTessellation::State {
 public:
    State(Metric metric, WeightIs weight_is) {
        using namespace triangulation;
        with_metric(metric, [&]<class M>(M) {
            if constexpr (!M::traits.edges_are_straight)
                live_ = std::make_unique<LiveAdditive<PredicatesOf<M>::template Perturbed>>(metric);
            else if (weight_is == WeightIs::weight)
                live_ = std::make_unique<LivePower<power::Site>>(metric);
            else
                live_ = std::make_unique<LivePower<signum::Site>>(metric);
        });
    }

    template <class Visit>
    decltype(auto) visit(const Visit& visit) {
        return std::visit([&](auto& live) -> decltype(auto) { return visit(*live); }, live_);
    }

 private:
    template <class One>
    using Pointer = std::unique_ptr<One>;
    std::variant<Pointer<triangulation::LivePower<signum::Site>>,
                 Pointer<triangulation::LivePower<power::Site>>,
                 Pointer<triangulation::LiveAdditive<euclidean::Perturbed>>,
                 Pointer<triangulation::LiveAdditive<manhattan::Perturbed>>,
                 Pointer<triangulation::LiveAdditive<supremum::Perturbed>>>
        live_;
};

namespace {

void check(double value) {
    if (!std::isfinite(value)) throw std::invalid_argument("a number of the site is not finite");
}

}  // namespace

DynamicTessellation::DynamicTessellation(Metric metric, WeightIs weight_is) {
    if (weight_is == WeightIs::weight && !traits_of(metric).has_weights)
        throw std::invalid_argument(no_weights(metric));
    state_ = std::make_unique<State>(metric, weight_is);
}
DynamicTessellation::DynamicTessellation(DynamicTessellation&&) noexcept = default;
DynamicTessellation& DynamicTessellation::operator=(DynamicTessellation&&) noexcept = default;
DynamicTessellation::~DynamicTessellation() = default;

Index DynamicTessellation::insert(const Site& site) {
    for (const double value : {site.x, site.y, site.r}) check(value);
    const exact::IeeeEnvironment environment;
    return state_->visit([&](auto& live) { return live.insert(site); });
}

void DynamicTessellation::erase(Index handle) {
    SIGNUM_EXPECTS(contains(handle));
    const exact::IeeeEnvironment environment;
    state_->visit([&](auto& live) { live.erase(handle); });
}

void DynamicTessellation::change(Index handle, double third) {
    SIGNUM_EXPECTS(contains(handle));
    check(third);
    const exact::IeeeEnvironment environment;
    state_->visit([&](auto& live) { live.change(handle, third); });
}

bool DynamicTessellation::contains(Index handle) const noexcept {
    return state_->visit([&](auto& live) { return live.contains(handle); });
}

std::size_t DynamicTessellation::size() const noexcept {
    return state_->visit([](auto& live) { return live.size(); });
}

Site DynamicTessellation::site(Index handle) const noexcept {
    return state_->visit([&](auto& live) { return live.site(handle); });
}

Tessellation DynamicTessellation::tessellation() const {
    const exact::IeeeEnvironment environment;
    return state_->visit([](auto& live) { return live.tessellation(); });
}

std::size_t DynamicTessellation::rebuilds() const noexcept {
    return state_->visit([](auto& live) { return live.rebuilds(); });
}

}  // namespace signum
