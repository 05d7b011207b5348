#include "part_of_space.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

#include "../options.hpp"
#include "../space/build.hpp"
#include "../space/kernel.hpp"
#include "../space/nearest_site.hpp"
#include "../space/order.hpp"
#include "settling.hpp"
#include "whole.hpp"

namespace signum::distributed {
namespace {

using spatial::Four;

std::size_t at(Index i) noexcept {
    return static_cast<std::size_t>(i);
}

template <class K>
class PartOfSpace final : public Settling<K> {
    using S = typename K::S;
    using Kernel = spatial::ExactKernel<S>;

 public:
    void each_face(const std::function<void(std::span<const std::int64_t>)>& put) const override {
        each_cell([&](const Four& v) {
            const WholeCell<4> ids = {id(v[0]), id(v[1]), id(v[2]), id(v[3])};
            std::size_t first = 4;
            for (std::size_t k = 0; k < 4; ++k)
                if (v[k] >= 0 && (first == 4 || ids[k] < ids[first])) first = k;
            if (is_own(v[first])) put(in_order(ids));
        });
    }
    void each_adjacency(const std::function<void(const Adjacency&)>& /*put*/) const override {}
    void each_star(const std::function<void(std::int64_t, std::span<const std::int64_t>)>& put)
        const override {
        // The cells at each own site, one site after the other.
        std::vector<std::size_t> ends(sites_.size() + 1);
        const auto each_at_own = [&](const auto& visit) {
            each_cell([&](const Four& v) {
                for (const Index each : v)
                    if (is_own(each)) visit(at(each), v);
            });
        };
        each_at_own([&](std::size_t v, const Four&) { ++ends[v + 1]; });
        for (std::size_t v = 0; v < sites_.size(); ++v) ends[v + 1] += ends[v];
        std::vector<Four> cells(ends.back());
        std::vector<std::size_t> next(ends.begin(), ends.end() - 1);
        each_at_own([&](std::size_t v, const Four& cell) { cells[next[v]++] = cell; });
        std::vector<std::int64_t> neighbours;
        for (std::size_t v = 0; v < sites_.size(); ++v) {
            if (ends[v] == ends[v + 1]) continue;
            neighbours.clear();
            for (std::size_t c = ends[v]; c < ends[v + 1]; ++c)
                for (const Index each : cells[c])
                    if (each != static_cast<Index>(v)) neighbours.push_back(id(each));
            std::ranges::sort(neighbours);
            neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
            put(id(static_cast<Index>(v)), neighbours);
        }
    }

    [[nodiscard]] Known known() const override {
        std::pair<Known, std::vector<Index>> sites_and_places = this->known_sites(
            numbers_, [&](Index v) { return placed(v); }, [&](Index v) { return is_own(v); });
        auto& known = sites_and_places.first;
        const auto& place = sites_and_places.second;
        const auto sites = static_cast<std::int64_t>(known.ids.size());
        std::vector<WholeCell<4>> cells;
        each_cell([&](const Four& v) {
            const auto number = [&](Index each) -> std::int64_t {
                return each < 0 ? -1 : place[at(each)];
            };
            cells.push_back(in_order({number(v[0]), number(v[1]), number(v[2]), number(v[3])}));
        });
        known.space = space_of(SortedCells<4>(std::move(cells), -1, sites), sites);
        for (const auto& [v, by] : nearest_)
            known.space.hidden.push_back({place[at(v)], place[at(by)]});
        std::ranges::sort(known.space.hidden, {}, &Hidden::site);
        return std::move(known);
    }

 private:
    /// The order of a cell in the whole.
    [[nodiscard]] static WholeCell<4> in_order(const WholeCell<4>& cell) noexcept {
        const auto& [a, b, c, d] = spatial::even_order_of(cell);
        return {cell[a], cell[b], cell[c], cell[d]};
    }
    [[nodiscard]] std::int64_t id(Index v) const noexcept { return numbers_.id(v); }
    [[nodiscard]] bool is_own(Index v) const noexcept { return v >= 0 && is_own_[at(v)] != 0; }
    [[nodiscard]] Placed placed(Index v) const noexcept {
        const S& s = sites_[at(v)];
        if constexpr (requires { s.w; })
            return {Site3{s.x, s.y, s.z, s.w}, id(v)};
        else
            return {s, id(v)};
    }
    template <class Visit>
    void each_cell(const Visit& visit) const {
        if (!insertion_) return;
        const spatial::Cells& cells = insertion_->cells();
        for (Index c = 0; at(c) < cells.size(); ++c)
            if (!cells.is_free(c)) visit(cells.vertex(c));
    }

    void build(std::span<const Placed> own, const std::vector<Placed>& others,
               const std::stop_token& stop) override {
        std::vector<Placed> all(own.begin(), own.end());
        all.insert(all.end(), others.begin(), others.end());
        std::vector<S> given;
        given.reserve(all.size());
        for (const Placed& each : all) given.push_back(straight<K>(each));
        const LargeArray<Index> order = spatial::insertion_order(
            all.size(), [&](Index i) { return place_of(all[at(i)]); }, 1);
        spatial::Builder<S> builder(given, order);
        if (builder.apexes() > 0)
            throw NoStructure("the sites lie in one plane, or are hidden by one of them");
        builder.copy_sites();
        auto [sites, places] = std::move(builder).release_sites();
        sites_ = std::move(sites);
        make_room(sites_.size() + sites_.size() / 16 + 1000);
        for (const Index place : places) {
            numbers_.push_back(all[at(place)].id);
            is_own_.push_back(static_cast<char>(at(place) < own.size()));
        }
        numbers_.settle();
        kernel_.emplace(std::span<const S>(sites_), numbers_.all());
        insertion_.emplace(*kernel_, spatial::frame_of(std::span<const S>(sites_)),
                           sites_.capacity());
        insert_from(4, stop);
    }
    void insert(const std::vector<Placed>& others) override {
        const auto before = static_cast<Index>(sites_.size());
        if (sites_.size() + others.size() > sites_.capacity()) {
            make_room((sites_.size() + others.size()) * 3 / 2);
            insertion_->expect(sites_.capacity());
        }
        for (const Placed& each : others) {
            sites_.push_back(straight<K>(each));
            numbers_.push_back(each.id);
            is_own_.push_back(0);
        }
        numbers_.settle();
        kernel_->extend(std::span<const S>(sites_), numbers_.all());
        insert_from(before, {});
    }
    void insert_from(Index first, const std::stop_token& stop) {
        for (Index q = first; at(q) < sites_.size(); ++q) {
            constexpr Index often = 4096;
            if (q % often == 0 && stop.stop_requested()) throw Stopped();
            insertion_->insert(q, [&](Index v, Index near) { hidden_.push_back({v, near}); });
        }
    }
    void make_room(std::size_t sites) {
        sites_.reserve(sites);
        numbers_.reserve(sites);
        is_own_.reserve(sites);
    }

    void ask(std::vector<Questions>& questions) override {
        if (this->unknown().empty()) return;
        const spatial::Cells& cells = insertion_->cells();
        const auto is_new = [&](const Four& v) {
            return v[0] != spatial::Cells::free &&
                   std::max({v[0], v[1], v[2], v[3]}) >= asked_of_ &&
                   std::min({v[0], v[1], v[2], v[3]}) >= 0;
        };
        const auto owns = [&](const Four& v) {
            return std::ranges::count_if(v, [&](Index each) { return is_own(each); });
        };
        // From the cells that are not of own sites alone to those beside them, as long as they may
        // be reached (part.hpp). Those that come later are all at sites of others.
        std::vector<char> is_seen(cells.size());
        std::vector<Index> waiting;
        const auto look_at = [&](Index c) {
            if (is_seen[at(c)] != 0) return;
            is_seen[at(c)] = 1;
            const Four& v = cells.vertex(c);
            if (!is_new(v)) return;
            const Corners cell = {placed(v[0]), placed(v[1]), placed(v[2]), placed(v[3])};
            if (!this->may_be_reached(Ball<K>(cell))) return;
            waiting.push_back(c);
            if (owns(v) > 0) this->ask_about_face(cell, questions);
        };
        for (Index c = 0; at(c) < cells.size(); ++c)
            if (const Four& v = cells.vertex(c); is_new(v) && owns(v) < 4) look_at(c);
        while (!waiting.empty()) {
            const Index c = waiting.back();
            waiting.pop_back();
            for (const Index n : cells.neighbour(c)) look_at(n);
        }
        asked_of_ = static_cast<Index>(sites_.size());
    }
    [[nodiscard]] std::vector<HiddenBy> hidden_by_known() override {
        std::vector<HiddenBy> result;
        if (hidden_.empty()) return result;
        // Who is near may be hidden later: then who is near to that one.
        constexpr Index is_visible = -1;
        std::vector<Index> near_to(sites_.size(), is_visible);
        for (auto last = hidden_.rbegin(); last != hidden_.rend(); ++last) {
            const Index of_near = near_to[at(last->near)];
            near_to[at(last->site)] = of_near == is_visible ? last->near : of_near;
        }
        LargeArray<Index> visible;
        for (Index v = 0; at(v) < sites_.size(); ++v)
            if (near_to[at(v)] == is_visible) visible.push_back(v);
        const spatial::NearestSite<S> nearest(sites_, numbers_.all(), std::move(visible));
        for (const spatial::HiddenNear& each : hidden_) {
            const Index by = nearest(centre3(sites_[at(each.site)]), near_to[at(each.site)]);
            nearest_.push_back({each.site, by});
            if (is_own(each.site)) result.push_back({placed(each.site), placed(by)});
        }
        return result;
    }

    LargeArray<S> sites_;
    Numbers numbers_;
    std::vector<char> is_own_;
    std::optional<Kernel> kernel_;
    std::optional<spatial::Insertion<Kernel>> insertion_;
    std::vector<spatial::HiddenNear> hidden_;
    std::vector<Hidden> nearest_;  ///< of all that are hidden and known
    Index asked_of_ = 0;           ///< sites that were there when cells were last asked about
};

}  // namespace

std::unique_ptr<Part> make_part_of_space(const Kind& kind) {
    return with_kind(kind, []<class K>() -> std::unique_ptr<Part> {
        if constexpr (K::dimension == 3)
            return std::make_unique<PartOfSpace<K>>();
        else
            return nullptr;
    });
}

}  // namespace signum::distributed
