#include "part.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "../../core/large_array.hpp"
#include "../insertion/hiders.hpp"
#include "../insertion/insert_all.hpp"
#include "../structure/assemble.hpp"
#include "../structure/spatial_order.hpp"
#include "../structure/topology.hpp"
#include "part_of_space.hpp"
#include "settling.hpp"

namespace signum::distributed {
namespace {

using triangulation::HalfEdge;
using triangulation::Topology;

std::size_t at(Index i) noexcept {
    return static_cast<std::size_t>(i);
}

/// Of the plane. Sites have places: those of own ones come first.
template <class K>
class PartOf final : public Settling<K> {
    using Kernel = typename K::Kernel;
    using S = typename Kernel::SiteType;

 public:
    void each_face(const std::function<void(std::span<const std::int64_t>)>& put) const override {
        for (Index f = 0; f < topology_.faces(); ++f) {
            if (topology_.is_vacant(f)) continue;
            const auto [first, corner] = first_of(f);
            if (first < static_cast<Index>(own_)) put(whole_face(f));
        }
    }
    void each_adjacency(const std::function<void(const Adjacency&)>& put) const override {
        if constexpr (Kernel::is_straight) return;
        const std::vector<Index> face_of =
            triangulation::faces_of_vertices(topology_, sites_.size(), Workers(1));
        std::vector<std::pair<Index, HalfEdge>> spokes;
        for (Index v = 0; at(v) < own_; ++v) {
            if (face_of[at(v)] < 0) continue;
            spokes.clear();
            for (const HalfEdge h : topology_.fan(topology_.spoke(face_of[at(v)], v)))
                if (const Index u = topology_.target(h); lesser(v, u) == v)
                    spokes.push_back({u, h});
            std::ranges::sort(spokes);
            for (std::size_t k = 0; k < spokes.size(); ++k) {
                const auto is_to = [&](std::size_t other) {
                    return other < spokes.size() && spokes[other].first == spokes[k].first;
                };
                if (!is_to(k + 1) && !(k > 0 && is_to(k - 1))) continue;
                for (const HalfEdge h : {spokes[k].second, topology_.twin(spokes[k].second)})
                    put(adjacency(h));
            }
        }
    }
    void each_star(const std::function<void(std::int64_t, std::span<const std::int64_t>)>& put)
        const override {
        const std::vector<Index> face_of =
            triangulation::faces_of_vertices(topology_, sites_.size(), Workers(1));
        std::vector<std::int64_t> neighbours;
        for (Index v = 0; at(v) < own_; ++v) {
            if (face_of[at(v)] < 0) continue;
            neighbours.clear();
            for (const HalfEdge h : topology_.fan(topology_.spoke(face_of[at(v)], v)))
                neighbours.push_back(id(topology_.target(h)));
            put(id(v), neighbours);
        }
    }
    [[nodiscard]] Known known() const override {
        auto [known, place] = this->known_sites(
            numbers_, [&](Index v) { return placed(v); }, [&](Index v) { return is_own(v); });
        TessellationArrays& arrays = known.plane;
        arrays.metric = K::Metric::metric;
        arrays.weight_is = K::weight_is;
        arrays.sites = static_cast<std::int64_t>(known.ids.size());
        assemble(Topology(topology_), place, place, arrays, Workers(1));
        for (Index v = 0; at(v) < sites_.size(); ++v)
            if (hidden_by_[at(v)] >= 0)
                arrays.hidden.push_back({place[at(v)], place[at(hidden_by_[at(v)])]});
        std::ranges::sort(arrays.hidden, {}, &Hidden::site);
        return std::move(known);
    }

 private:
    [[nodiscard]] bool is_own(Index v) const noexcept { return v >= 0 && at(v) < own_; }

    // ---- the structure -----------------------------------------------------------------------

    [[nodiscard]] Kernel kernel() {
        if constexpr (Kernel::is_straight)
            return Kernel(sites_.data(), numbers_.all().data());
        else
            return Kernel(sites_.data());
    }
    /// Room costs nothing until it is used; to make more of it, all is copied.
    void make_room(std::size_t sites) {
        sites_.reserve(sites);
        numbers_.reserve(sites);
        hidden_by_.reserve(sites);
        topology_.make_room(sites);
    }
    void add(const Placed& placed) {
        if constexpr (Kernel::is_straight)
            sites_.push_back(straight<K>(placed));
        else
            sites_.push_back({in_plane(placed), 0});
        numbers_.push_back(placed.id);
        hidden_by_.push_back(-1);
    }
    [[nodiscard]] Placed placed(Index v) const noexcept {
        const S& s = sites_[at(v)];
        if constexpr (requires { s.w; })
            return {Site{s.x, s.y, s.w}, id(v)};
        else
            return {Site{s.x, s.y, s.r}, id(v)};
    }

    void build(std::span<const Placed> own, const std::vector<Placed>& others,
               const std::stop_token& stop) override {
        own_ = own.size();
        std::vector<Site> all;
        all.reserve(own.size() + others.size());
        for (const Placed& each : own) all.push_back(in_plane(each));
        for (const Placed& each : others) all.push_back(in_plane(each));
        LargeArray<Index> order = triangulation::spatial_order(StridedSites(all), 1);
        make_room(all.size() + all.size() / 16 + 1000);
        for (const Index i : order)
            if (at(i) < own_) add(own[at(i)]);
        for (const Index i : order)
            if (at(i) >= own_) add(others[at(i) - own_]);
        Index next_own = 0;
        auto next_other = static_cast<Index>(own_);
        for (Index& i : order) i = at(i) < own_ ? next_own++ : next_other++;
        all = {};
        number_all();

        Kernel kernel = this->kernel();
        const std::function<void(double)> nobody;
        const triangulation::Watch watch(stop, nobody, sites_.size());
        if (!insert_all(topology_, kernel, std::span(hidden_by_), std::span(order), watch))
            throw NoStructure("the sites lie on one line, or are hidden by one of them");
    }

    void insert(const std::vector<Placed>& others) override {
        const auto before = static_cast<Index>(sites_.size());
        if (sites_.size() + others.size() > sites_.capacity())
            make_room((sites_.size() + others.size()) * 3 / 2);
        for (const Placed& each : others) add(each);
        number_new(before);
        Kernel kernel = this->kernel();
        Index face = 0;
        while (topology_.is_vacant(face)) ++face;
        triangulation::Insertion<Kernel> insertion(topology_, kernel, std::span(hidden_by_), face);
        for (Index v = before; at(v) < sites_.size(); ++v)
            if (!insertion.insert(v)) throw std::logic_error("one site hides all that are known");
    }

    /// The places of the tie rule's order.
    void number_all() {
        numbers_.settle();
        if constexpr (!Kernel::is_straight) {
            triangulation::rank(std::span(sites_), numbers_.all(), Workers(1));
            by_rank_ = LargeArray<Index>(sites_.size());
            for (Index v = 0; at(v) < sites_.size(); ++v) by_rank_[at(sites_[at(v)].rank)] = v;
            spread_ranks();
        }
    }
    void number_new(Index before) {
        numbers_.settle();
        if constexpr (!Kernel::is_straight) {
            const std::span<const Index> numbers = numbers_.all();
            const auto precedes = [&](Index a, Index b) {
                return additive::precedes(sites_[at(a)], numbers[at(a)], sites_[at(b)],
                                          numbers[at(b)]);
            };
            std::vector<Index> later(sites_.size() - at(before));
            std::iota(later.begin(), later.end(), before);
            std::ranges::sort(later, precedes);
            // Few come among many, whose order is known: each is searched for.
            LargeArray<Index> merged;
            merged.reserve(sites_.size());
            auto from = by_rank_.begin();
            for (const Index v : later) {
                const auto to = std::lower_bound(from, by_rank_.end(), v, precedes);
                merged.insert(merged.end(), from, to);
                merged.push_back(v);
                from = to;
            }
            merged.insert(merged.end(), from, by_rank_.end());
            by_rank_ = std::move(merged);
            spread_ranks();
        }
    }
    void spread_ranks() {
        for (std::size_t place = 0; place < by_rank_.size(); ++place)
            sites_[at(by_rank_[place])].rank = static_cast<Index>(place);
    }
    // ---- what is not sure ----------------------------------------------------------------------

    void ask(std::vector<Questions>& questions) override {
        for (const Index f : asked_of_ == 0 ? faces_that_may_be_reached() : faces_that_came())
            this->ask_about_face(corners(f), questions);
        for (const HalfEdge h : edges_that_may_be_reached()) {
            const auto about = topology_.about(h);
            EdgeQuestion question;
            for (std::size_t k = 0; k < 4; ++k)
                question[k] = about[k] < 0 ? Placed() : placed(about[k]);
            this->ask_about_edge(question, questions);
        }
        asked_of_ = static_cast<Index>(sites_.size());
    }
    [[nodiscard]] Corners corners(Index f) const noexcept {
        const auto& v = topology_.vertices(f);
        return {placed(v[0]), placed(v[1]), placed(v[2])};
    }
    /// Whether sites that are not known may reach a finite face.
    [[nodiscard]] bool may_be_reached(Index f) const {
        return Settling<K>::may_be_reached(Ball<K>(corners(f)));
    }
    [[nodiscard]] std::vector<Index> faces_that_may_be_reached() const {
        std::vector<Index> result;
        if (this->unknown().empty()) return result;
        std::vector<char> is_seen(at(topology_.faces()));
        std::vector<char> is_taken(sites_.size());
        struct Reached {
            Index site;
            Index face;
        };
        std::vector<Reached> reached;
        const auto look_at = [&](Index f) {
            if (is_seen[at(f)] != 0) return;
            is_seen[at(f)] = 1;
            const bool is_infinite = topology_.is_infinite(f);
            bool is_reached = false;
            if (!is_infinite) {
                const Ball<K> ball(corners(f));
                is_reached = Settling<K>::may_be_reached(ball);
                bool leads_on = is_reached;
                if constexpr (!K::is_straight) leads_on = this->leads_on(ball);
                if (!leads_on) return;
            }
            bool has_own = false;
            for (const Index v : topology_.vertices(f)) {
                has_own = has_own || is_own(v);
                if (v < 0 || is_taken[at(v)] != 0) continue;
                is_taken[at(v)] = 1;
                reached.push_back({v, f});
            }
            if (has_own && is_reached) result.push_back(f);
        };
        for (Index f = 0; f < topology_.faces(); ++f) {
            const auto& v = topology_.vertices(f);
            if (!topology_.is_vacant(f) && !(is_own(v[0]) && is_own(v[1]) && is_own(v[2])))
                look_at(f);
        }
        for (std::size_t i = 0; i < reached.size(); ++i) {
            const auto [site, face] = reached[i];
            for (const HalfEdge h : topology_.fan(topology_.spoke(face, site)))
                look_at(Topology::face(h));
        }
        return result;
    }
    /// Whether a face came with the last sites. A vacant one did not.
    [[nodiscard]] bool came(Index f) const noexcept {
        const auto& v = topology_.vertices(f);
        return std::max({v[0], v[1], v[2]}) >= asked_of_;
    }
    /// Finite ones that came with the last sites, at own sites, that may be reached.
    [[nodiscard]] std::vector<Index> faces_that_came() const {
        std::vector<Index> faces;
        if (this->unknown().empty()) return faces;
        for (Index f = 0; f < topology_.faces(); ++f) {
            if (!came(f) || topology_.is_infinite(f)) continue;
            const auto& v = topology_.vertices(f);
            if ((is_own(v[0]) || is_own(v[1]) || is_own(v[2])) && may_be_reached(f))
                faces.push_back(f);
        }
        return faces;
    }
    /// The edges between sites, one of them own, of which sites that are not known may take the
    /// middle and leave both ends; of the faces that came with the last sites.
    [[nodiscard]] std::vector<HalfEdge> edges_that_may_be_reached() {
        std::vector<HalfEdge> edges;
        if constexpr (!Kernel::is_straight) {
            if (this->unknown().empty()) return edges;
            find_who_stays();
            for (Index f = 0; f < topology_.faces(); ++f) {
                if (!came(f)) continue;
                for (unsigned k = 0; k < 3; ++k) {
                    const HalfEdge h = Topology::first_edge(f) + k;
                    const HalfEdge twin = topology_.twin(h);
                    if (h > twin && came(Topology::face(twin))) continue;
                    const Index i = topology_.origin(h);
                    const Index j = topology_.target(h);
                    if (i < 0 || j < 0 || !(is_own(i) || is_own(j))) continue;
                    if (stays_[at(i)] != 0 && stays_[at(j)] != 0) continue;
                    const Middle middle(placed(i), placed(j));
                    if (std::ranges::any_of(this->unknown(), [&](const auto& each) {
                            return middle.may_be_taken_from(each.second);
                        }))
                        edges.push_back(h);
                }
            }
        }
        return edges;
    }
    /// Of sites that have come: who stays within what is known, and by more than what may reach in
    /// from beyond with a radius below 0. Of two such sites no edge is taken.
    void find_who_stays() {
        const Extent& known = this->searched();
        double least = 0.0;
        for (const auto& each : this->unknown())
            least = std::min(least, each.second.low[weight_place]);
        for (std::size_t v = stays_.size(); v < sites_.size(); ++v) {
            const double x = sites_[v].x;
            const double y = sites_[v].y;
            // Two roundings each.
            const double r =
                (sites_[v].r - least) +
                0x1p-50 * (std::fabs(sites_[v].r) + std::fabs(least) + std::fabs(x) + std::fabs(y));
            stays_.push_back(static_cast<char>(x - r > known.low[0] && x + r < known.high[0] &&
                                               y - r > known.low[1] && y + r < known.high[1]));
        }
    }

    [[nodiscard]] std::vector<HiddenBy> hidden_by_known() override {
        Kernel kernel = this->kernel();
        settle_hiders(topology_, kernel, std::span(hidden_by_), Workers(1));
        std::vector<HiddenBy> result;
        for (Index v = 0; at(v) < own_; ++v)
            if (hidden_by_[at(v)] >= 0) result.push_back({placed(v), placed(hidden_by_[at(v)])});
        return result;
    }

    // ---- by numbers in the whole ---------------------------------------------------------------

    [[nodiscard]] std::int64_t id(Index v) const noexcept { return numbers_.id(v); }
    /// Of two vertices, one of them a site.
    [[nodiscard]] Index lesser(Index a, Index b) const noexcept {
        return a < 0 ? b : b < 0 ? a : id(a) < id(b) ? a : b;
    }
    /// The site of a face with the least number, and where it stands.
    [[nodiscard]] std::pair<Index, unsigned> first_of(Index f) const noexcept {
        const auto& v = topology_.vertices(f);
        const Index first = lesser(lesser(v[0], v[1] < 0 ? v[2] : v[1]), v[2] < 0 ? v[1] : v[2]);
        return {first, v[0] == first ? 0U : v[1] == first ? 1U : 2U};
    }
    /// Which corner comes first in the whole.
    [[nodiscard]] unsigned rotation(Index f) const noexcept {
        const auto& v = topology_.vertices(f);
        for (unsigned k = 0; k < 3; ++k)
            if (v[k] < 0) return k;
        return first_of(f).second;
    }
    [[nodiscard]] WholeFace whole_face(Index f) const noexcept {
        const auto& v = topology_.vertices(f);
        const unsigned first = rotation(f);
        return {id(v[first]), id(v[(first + 1) % 3]), id(v[(first + 2) % 3])};
    }

    [[nodiscard]] Adjacency adjacency(HalfEdge h) const noexcept {
        const Index f = Topology::face(h);
        // The corner across is that before the edge's origin.
        const std::int64_t corner = ((h & 3) + 2 + 3 - rotation(f)) % 3;
        return {whole_face(f), corner, whole_face(Topology::face(topology_.twin(h)))};
    }

    std::size_t own_ = 0;
    Index asked_of_ = 0;  ///< sites that were there when faces were last asked about
    LargeArray<S> sites_;
    Numbers numbers_;
    LargeArray<Index> by_rank_;
    std::vector<char> stays_;  ///< edges_that_may_be_reached()
    LargeArray<Index> hidden_by_;
    Topology topology_{0};
};

}  // namespace

std::unique_ptr<Part> make_part(const Kind& kind) {
    if (kind.dimension == 3) return make_part_of_space(kind);
    return with_kind(kind, []<class K>() -> std::unique_ptr<Part> {
        if constexpr (K::dimension == 2)
            return std::make_unique<PartOf<K>>();
        else
            return nullptr;
    });
}

}  // namespace signum::distributed
