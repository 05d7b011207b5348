#include "part.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_set>
#include <vector>

#include "../../core/large_array.hpp"
#include "../../exact/floating_environment.hpp"
#include "../insertion/hiders.hpp"
#include "../insertion/insert_all.hpp"
#include "../structure/spatial_order.hpp"
#include "../structure/topology.hpp"
#include "few.hpp"

namespace signum::distributed {
namespace {

using triangulation::HalfEdge;
using triangulation::Topology;

std::size_t at(Index i) noexcept {
    return static_cast<std::size_t>(i);
}

/// So many of an own site's share of the plane, in length, are looked beyond the own box.
constexpr double looked_beyond = 3.0;

/// Sites have places: those of own ones come first.
template <class M, WeightIs weight_is>
class PartOf final : public Part {
    using Kernel = typename KernelOf<M, weight_is>::type;
    using S = typename Kernel::SiteType;

 public:
    void settle(const SiteStore& own, std::span<const Placed> common,
                std::span<const PartBounds> parts, std::size_t number, Exchange& exchange,
                const std::stop_token& stop) override {
        const exact::IeeeEnvironment environment;
        look_around(own, parts, number);
        std::vector<Questions> questions(parts.size());
        for (std::size_t q = 0; q < parts.size(); ++q)
            if (q != number && !own.sites().empty() && meet(parts[q].extent, known_))
                questions[q].boxes.push_back(known_);
        own_ = own.sites().size();
        guests_.clear();
        std::vector<Placed> others;
        take_new(common, others);
        for (const Answers& answers : exchange.ask(std::move(questions)))
            take_new(answers.sites, others);
        if (own_ > 0) build(own.sites(), others, stop);
        ++told_.rounds;
        told_.sites += others.size();

        std::vector<Index> faces;
        std::vector<HalfEdge> edges;
        if (own_ > 0) faces = faces_that_may_be_reached();
        if (own_ > 0) edges = edges_that_may_be_reached(-1);
        while (exchange.is_for_any(!faces.empty() || !edges.empty())) {
            questions.assign(parts.size(), {});
            for (const Index f : faces) ask_about_face(f, questions);
            for (const HalfEdge h : edges) ask_about_edge(h, questions);
            std::vector<Placed> found;
            for (const Answers& answers : exchange.ask(std::move(questions)))
                take_new(answers.sites, found);
            faces.clear();
            edges.clear();
            ++told_.rounds;
            told_.sites += found.size();
            if (found.empty()) continue;
            const auto before = static_cast<Index>(sites_.size());
            insert(found);
            faces = faces_that_came(before);
            edges = edges_that_may_be_reached(before);
        }
        settle_hidden(parts, number, exchange);
    }

    void each_face(const std::function<void(const WholeFace&)>& put) const override {
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
            put(ids_[at(v)], neighbours);
        }
    }
    [[nodiscard]] std::vector<WholeHidden> hidden() const override { return hidden_; }
    [[nodiscard]] Told told() const noexcept override { return told_; }

 private:
    [[nodiscard]] bool is_own(Index v) const noexcept { return v >= 0 && at(v) < own_; }

    // ---- who is known ----------------------------------------------------------------------

    /// What is known of others: all in a box, and nothing beyond its sides.
    void look_around(const SiteStore& own, std::span<const PartBounds> parts, std::size_t number) {
        const auto grown = [&](double by) {
            Extent box = own.extent();
            for (std::size_t axis = 0; axis < 2; ++axis) {
                box.low[axis] -= by;
                box.high[axis] += by;
            }
            return box;
        };
        constexpr double far = HUGE_VAL;
        const bool has_own = !own.sites().empty();
        double spacing = own.spacing();
        const Extent most = grown(looked_beyond * spacing);
        for (const PartBounds& other : parts)
            if (!is_empty(other.extent) && meet(other.extent, most))
                spacing = std::min(spacing, other.spacing);
        known_ = grown(looked_beyond * spacing);

        unknown_.clear();
        double greatest = -far;
        for (std::size_t q = 0; q < parts.size() && has_own; ++q) {
            if (q == number || is_empty(parts[q].extent)) continue;
            greatest = std::max(greatest, parts[q].extent.high[2]);
            for (const Extent& beyond : sides_of(known_, far)) {
                const Extent extent = overlap(parts[q].extent, beyond);
                if (meet(extent, extent)) unknown_.push_back({q, extent});
            }
        }
        beyond_.clear();
        if (!unknown_.empty())
            for (const Extent& side : sides_of(known_, greatest)) beyond_.push_back(side);
    }
    /// The half-planes beyond the sides of a box, as extents.
    [[nodiscard]] static std::array<Extent, 4> sides_of(const Extent& box, double greatest) {
        constexpr double far = HUGE_VAL;
        const Extent all = {{-far, -far, -far}, {far, far, greatest}};
        std::array<Extent, 4> sides = {all, all, all, all};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            sides[2 * axis].low[axis] = std::nextafter(box.high[axis], far);
            sides[2 * axis + 1].high[axis] = std::nextafter(box.low[axis], -far);
        }
        return sides;
    }
    [[nodiscard]] static Extent overlap(const Extent& a, const Extent& b) noexcept {
        Extent both = a;
        for (std::size_t axis = 0; axis < 2; ++axis) {
            both.low[axis] = std::max(a.low[axis], b.low[axis]);
            both.high[axis] = std::min(a.high[axis], b.high[axis]);
        }
        return both;
    }
    /// Of the sites that come those that are not known.
    void take_new(std::span<const Placed> sites, std::vector<Placed>& found) {
        for (const Placed& site : sites)
            if (guests_.insert(site.id).second) found.push_back(site);
    }

    // ---- the structure -----------------------------------------------------------------------

    [[nodiscard]] Kernel kernel() {
        if constexpr (Kernel::is_straight)
            return Kernel(sites_.data(), numbers_.data());
        else
            return Kernel(sites_.data());
    }
    /// Room costs nothing until it is used; to make more of it, all is copied.
    void make_room(std::size_t sites) {
        sites_.reserve(sites);
        ids_.reserve(sites);
        numbers_.reserve(sites);
        hidden_by_.reserve(sites);
        topology_.make_room(sites);
    }
    void add(const Placed& placed) {
        if constexpr (Kernel::is_straight)
            sites_.push_back(PredicatesOf<M, weight_is>::site(placed.site));
        else
            sites_.push_back({placed.site, 0});
        ids_.push_back(placed.id);
        hidden_by_.push_back(-1);
    }
    [[nodiscard]] Placed placed(Index v) const noexcept {
        const S& s = sites_[at(v)];
        if constexpr (requires { s.w; })
            return {{s.x, s.y, s.w}, ids_[at(v)]};
        else
            return {{s.x, s.y, s.r}, ids_[at(v)]};
    }

    void build(std::span<const Placed> own, const std::vector<Placed>& others,
               const std::stop_token& stop) {
        std::vector<Site> all;
        all.reserve(own.size() + others.size());
        for (const Placed& each : own) all.push_back(each.site);
        for (const Placed& each : others) all.push_back(each.site);
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

    void insert(const std::vector<Placed>& others) {
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

    /// The places of the tie rule's order: only their order counts.
    void number_all() {
        number_by_ids(0);
        if constexpr (!Kernel::is_straight) {
            triangulation::rank(std::span(sites_), std::span<const Index>(numbers_), Workers(1));
            by_rank_ = LargeArray<Index>(sites_.size());
            for (Index v = 0; at(v) < sites_.size(); ++v) by_rank_[at(sites_[at(v)].rank)] = v;
            spread_ranks();
        }
    }
    void number_new(Index before) {
        number_by_ids(at(before));
        if constexpr (!Kernel::is_straight) {
            const auto precedes = [&](Index a, Index b) {
                return additive::precedes(sites_[at(a)], numbers_[at(a)], sites_[at(b)],
                                          numbers_[at(b)]);
            };
            std::vector<Index> later(sites_.size() - at(before));
            std::iota(later.begin(), later.end(), before);
            std::ranges::sort(later, precedes);
            LargeArray<Index> merged(sites_.size());
            std::ranges::merge(by_rank_, later, merged.begin(), precedes);
            by_rank_ = std::move(merged);
            spread_ranks();
        }
    }
    void spread_ranks() {
        for (std::size_t place = 0; place < by_rank_.size(); ++place)
            sites_[at(by_rank_[place])].rank = static_cast<Index>(place);
    }
    /// numbers_ are in the order of ids_; those from `first` on are new.
    void number_by_ids(std::size_t first) {
        const std::size_t n = ids_.size();
        constexpr std::int64_t most = std::numeric_limits<Index>::max();
        numbers_.resize(n);
        are_far_ = are_far_ || std::any_of(ids_.begin() + static_cast<std::ptrdiff_t>(first),
                                           ids_.end(), [](std::int64_t id) { return id > most; });
        if (!are_far_) {
            for (std::size_t i = first; i < n; ++i) numbers_[i] = static_cast<Index>(ids_[i]);
            return;
        }
        std::vector<Index> by_id(n);
        std::iota(by_id.begin(), by_id.end(), 0);
        std::ranges::sort(by_id, {}, [&](Index v) { return ids_[at(v)]; });
        for (std::size_t k = 0; k < n; ++k) numbers_[at(by_id[k])] = static_cast<Index>(k);
    }

    // ---- what is not sure ----------------------------------------------------------------------

    [[nodiscard]] std::array<Placed, 3> corners(Index f) const noexcept {
        const auto& v = topology_.vertices(f);
        return {placed(v[0]), placed(v[1]), placed(v[2])};
    }
    /// Whether sites that are not known may reach a finite face.
    [[nodiscard]] bool may_be_reached(Index f) const {
        if (beyond_.empty()) return false;
        const Ball<M, weight_is> ball(corners(f));
        return std::ranges::any_of(
            beyond_, [&](const Extent& side) { return ball.may_be_reached_from(side); });
    }
    [[nodiscard]] std::vector<Index> faces_that_may_be_reached() const {
        std::vector<Index> result;
        if (beyond_.empty()) return result;
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
            if (!is_infinite && !may_be_reached(f)) return;
            bool has_own = false;
            for (const Index v : topology_.vertices(f)) {
                has_own = has_own || is_own(v);
                if (v < 0 || is_taken[at(v)] != 0) continue;
                is_taken[at(v)] = 1;
                reached.push_back({v, f});
            }
            if (has_own && !is_infinite) result.push_back(f);
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
    /// Finite ones that are not older than a site, at own sites, that may be reached.
    [[nodiscard]] std::vector<Index> faces_that_came(Index first) const {
        std::vector<Index> faces;
        for (Index f = 0; f < topology_.faces(); ++f) {
            const auto& v = topology_.vertices(f);
            if (std::max({v[0], v[1], v[2]}) < first || topology_.is_infinite(f)) continue;
            if ((is_own(v[0]) || is_own(v[1]) || is_own(v[2])) && may_be_reached(f))
                faces.push_back(f);
        }
        return faces;
    }
    /// The edges between sites, one of them own, of which sites that are not known may take the
    /// middle and leave both ends; of the faces that came with the site `first` or later.
    [[nodiscard]] std::vector<HalfEdge> edges_that_may_be_reached(Index first) const {
        std::vector<HalfEdge> edges;
        if constexpr (!Kernel::is_straight) {
            if (unknown_.empty()) return edges;
            // Sites that stay within what is known, and by more than what may reach in from beyond
            // with a radius below 0: of two of them no edge is taken.
            double least = 0.0;
            for (const auto& each : unknown_) least = std::min(least, each.second.low[2]);
            std::vector<char> stays(sites_.size());
            for (std::size_t v = 0; v < sites_.size(); ++v) {
                const double r = sites_[v].r - least;
                stays[v] = static_cast<char>(
                    sites_[v].x - r > known_.low[0] && sites_[v].x + r < known_.high[0] &&
                    sites_[v].y - r > known_.low[1] && sites_[v].y + r < known_.high[1]);
            }
            const auto sticks_out = [&](Index v) { return v >= 0 && stays[at(v)] == 0; };
            const auto came = [&](const Index(&v)[3]) {
                return std::max({v[0], v[1], v[2]}) >= first;
            };
            for (Index f = 0; f < topology_.faces(); ++f) {
                const auto& v = topology_.vertices(f);
                if (topology_.is_vacant(f)) continue;
                if (!sticks_out(v[0]) && !sticks_out(v[1]) && !sticks_out(v[2])) continue;
                for (unsigned k = 0; k < 3; ++k) {
                    const HalfEdge h = Topology::first_edge(f) + k;
                    const HalfEdge twin = topology_.twin(h);
                    if (h > twin || !(came(v) || came(topology_.vertices(Topology::face(twin)))))
                        continue;
                    const Index i = topology_.origin(h);
                    const Index j = topology_.target(h);
                    if (i < 0 || j < 0 || !(is_own(i) || is_own(j))) continue;
                    const Middle middle(sites_[at(i)], sites_[at(j)]);
                    if (std::ranges::any_of(unknown_, [&](const auto& each) {
                            return middle.may_be_taken_from(each.second);
                        }))
                        edges.push_back(h);
                }
            }
        }
        return edges;
    }
    /// Calls ask(part) for each part of whose sites that are not known may(extent) says so.
    template <class May, class Ask>
    void for_parts_with(const May& may, const Ask& ask) const {
        std::size_t asked = std::numeric_limits<std::size_t>::max();
        for (const auto& [part, extent] : unknown_) {
            if (part == asked || !may(extent)) continue;
            ask(part);
            asked = part;
        }
    }
    void ask_about_edge(HalfEdge h, std::vector<Questions>& questions) {
        const auto about = topology_.about(h);
        EdgeQuestion question;
        for (std::size_t k = 0; k < 4; ++k)
            question[k] = about[k] < 0 ? at_infinity() : placed(about[k]);
        const Middle middle(question[0].site, question[1].site);
        for_parts_with([&](const Extent& extent) { return middle.may_be_taken_from(extent); },
                       [&](std::size_t part) { questions[part].edges.push_back(question); });
        ++told_.edges;
    }
    void ask_about_face(Index f, std::vector<Questions>& questions) {
        const std::array<Placed, 3> face = corners(f);
        const Ball<M, weight_is> ball(face);
        for_parts_with([&](const Extent& extent) { return ball.may_be_reached_from(extent); },
                       [&](std::size_t part) { questions[part].faces.push_back(face); });
        ++told_.faces;
    }

    // ---- hidden sites --------------------------------------------------------------------------

    void settle_hidden(std::span<const PartBounds> parts, std::size_t number, Exchange& exchange) {
        std::vector<Placed> hidden;
        std::vector<Placed> by;
        if (own_ > 0) {
            Kernel kernel = this->kernel();
            settle_hiders(topology_, kernel, std::span(hidden_by_), Workers(1));
            for (Index v = 0; at(v) < own_; ++v)
                if (hidden_by_[at(v)] >= 0) {
                    hidden.push_back(placed(v));
                    by.push_back(placed(hidden_by_[at(v)]));
                }
        }
        std::vector<Questions> questions(parts.size());
        std::vector<std::vector<std::size_t>> asked(parts.size());
        for (std::size_t k = 0; k < hidden.size(); ++k) {
            const Point p = {hidden[k].site.x, hidden[k].site.y};
            const double high = nearness<M>(p, extent_of<M, weight_is>(by[k].site)).high;
            for (std::size_t q = 0; q < parts.size(); ++q) {
                if (q == number || is_empty(parts[q].extent)) continue;
                if (nearness<M>(p, parts[q].extent).low > high) continue;
                questions[q].hidden.push_back({hidden[k], by[k]});
                asked[q].push_back(k);
            }
        }
        const bool is_asked = exchange.is_for_any(
            std::ranges::any_of(questions, [](const Questions& each) { return !each.are_none(); }));
        if (is_asked) {
            const std::vector<Answers> answers = exchange.ask(std::move(questions));
            for (std::size_t q = 0; q < parts.size(); ++q)
                for (std::size_t i = 0; i < asked[q].size(); ++i) {
                    const std::size_t k = asked[q][i];
                    const Placed& other = answers[q].nearest[i];
                    Few<M, weight_is, 3> few({&hidden[k], &other, &by[k]});
                    if (other.id != by[k].id && few.kernel().is_nearer(0, 1, 2)) by[k] = other;
                }
        }
        hidden_.clear();
        for (std::size_t k = 0; k < hidden.size(); ++k) hidden_.push_back({hidden[k].id, by[k].id});
        std::ranges::sort(hidden_, {}, &WholeHidden::site);
    }

    // ---- by numbers in the whole ---------------------------------------------------------------

    [[nodiscard]] std::int64_t id(Index v) const noexcept { return v < 0 ? -1 : ids_[at(v)]; }
    /// Of two vertices, one of them a site.
    [[nodiscard]] Index lesser(Index a, Index b) const noexcept {
        return a < 0 ? b : b < 0 ? a : ids_[at(a)] < ids_[at(b)] ? a : b;
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
    Extent known_ = no_extent();
    std::vector<std::pair<std::size_t, Extent>> unknown_;  ///< of each part, beyond known_
    std::vector<Extent> beyond_;                           ///< all that
    std::unordered_set<std::int64_t> guests_;

    LargeArray<S> sites_;
    LargeArray<std::int64_t> ids_;
    LargeArray<Index> numbers_;
    bool are_far_ = false;  ///< ids are beyond an Index
    LargeArray<Index> by_rank_;
    LargeArray<Index> hidden_by_;
    Topology topology_{0};
    std::vector<WholeHidden> hidden_;
    Told told_;
};

}  // namespace

std::unique_ptr<Part> make_part(Metric metric, WeightIs weight_is) {
    return with_kernel(metric, weight_is, []<class M, WeightIs w>() -> std::unique_ptr<Part> {
        return std::make_unique<PartOf<M, w>>();
    });
}

}  // namespace signum::distributed
