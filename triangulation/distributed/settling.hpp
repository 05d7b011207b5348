#pragma once
/// How a part settles, whatever its kind: who is known of others, what is asked, and who hides. For
/// sources only.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <stop_token>
#include <unordered_set>
#include <utility>
#include <vector>

#include "../../core/large_array.hpp"
#include "../../exact/floating_environment.hpp"
#include "few.hpp"
#include "part.hpp"

namespace signum::distributed {

/// Sites by their numbers in the whole, and as ties are decided by them: only the order counts.
class Numbers {
 public:
    void reserve(std::size_t sites) {
        ids_.reserve(sites);
        numbers_.reserve(sites);
    }
    void push_back(std::int64_t id) { ids_.push_back(id); }
    [[nodiscard]] std::int64_t id(Index v) const noexcept {
        return v < 0 ? -1 : ids_[static_cast<std::size_t>(v)];
    }
    /// To be called when sites have come. Numbers of others may change.
    void settle() {
        constexpr std::int64_t most = std::numeric_limits<Index>::max();
        const std::size_t before = numbers_.size();
        numbers_.resize(ids_.size());
        are_far_ = are_far_ || std::any_of(ids_.begin() + static_cast<std::ptrdiff_t>(before),
                                           ids_.end(), [](std::int64_t id) { return id > most; });
        if (!are_far_) {
            for (std::size_t i = before; i < ids_.size(); ++i)
                numbers_[i] = static_cast<Index>(ids_[i]);
            return;
        }
        const std::vector<Index> by_id = in_order();
        for (std::size_t k = 0; k < by_id.size(); ++k)
            numbers_[static_cast<std::size_t>(by_id[k])] = static_cast<Index>(k);
    }
    [[nodiscard]] std::span<const Index> all() const noexcept { return numbers_; }
    /// Sites in the order of their numbers.
    [[nodiscard]] std::vector<Index> in_order() const {
        std::vector<Index> order(ids_.size());
        std::iota(order.begin(), order.end(), 0);
        std::ranges::sort(order, {}, [&](Index v) { return id(v); });
        return order;
    }

 private:
    LargeArray<std::int64_t> ids_;
    LargeArray<Index> numbers_;
    bool are_far_ = false;  ///< ids are beyond an Index
};

/// A hidden site, and who is nearest to its centre of those that are known.
using HiddenBy = std::array<Placed, 2>;

[[nodiscard]] inline bool are_some(const std::vector<Questions>& questions) noexcept {
    return !std::ranges::all_of(questions, &Questions::are_none);
}

/// Makes it the nearest of all, who may be of any part but `own`, of which all sites are in
/// extents.
template <class K>
void ask_for_nearest(std::vector<HiddenBy>& hidden, std::span<const Extent> extents,
                     std::size_t own, Exchange& exchange) {
    std::vector<Questions> questions(extents.size());
    std::vector<std::vector<std::size_t>> asked(extents.size());
    for (std::size_t k = 0; k < hidden.size(); ++k) {
        const auto& [site, by] = hidden[k];
        const double high = nearness<K>(place_of(site), extent_of<K>(by)).high;
        for (std::size_t q = 0; q < extents.size(); ++q) {
            if (q == own || is_empty(extents[q])) continue;
            if (nearness<K>(place_of(site), extents[q]).low > high) continue;
            questions[q].hidden.push_back(hidden[k]);
            asked[q].push_back(k);
        }
    }
    if (!exchange.is_for_any(are_some(questions))) return;
    const std::vector<Answers> answers = exchange.ask(std::move(questions));
    for (std::size_t q = 0; q < extents.size(); ++q)
        for (std::size_t i = 0; i < asked[q].size(); ++i) {
            auto& [site, by] = hidden[asked[q][i]];
            const Placed& other = answers[q].nearest[i];
            if (other.id != by.id && is_nearer<K>(site, other, by)) by = other;
        }
}

template <class K>
class Settling : public Part {
 public:
    void settle(const SiteStore& own, std::span<const Placed> common,
                std::span<const PartBounds> parts, std::size_t number, Exchange& exchange,
                const std::stop_token& stop) final {
        const exact::IeeeEnvironment environment;
        look_around(own, parts, number);
        const bool has_own = !own.sites().empty();
        std::vector<Questions> questions(parts.size());
        for (std::size_t q = 0; q < parts.size(); ++q)
            if (q != number && has_own && meet(parts[q].extent, searched_))
                questions[q].boxes.push_back(searched_);
        guests_.clear();
        std::vector<Placed> others;
        take_new(common, others);
        for (const Answers& answers : exchange.ask(std::move(questions)))
            take_new(answers.sites, others);
        ++told_.rounds;
        told_.sites += others.size();

        questions.assign(parts.size(), {});
        if (has_own) {
            build(own.sites(), others, stop);
            ask(questions);
        }
        while (exchange.is_for_any(are_some(questions))) {
            std::vector<Placed> found;
            for (const Answers& answers : exchange.ask(std::move(questions)))
                take_new(answers.sites, found);
            ++told_.rounds;
            told_.sites += found.size();
            questions.assign(parts.size(), {});
            if (found.empty()) continue;
            insert(found);
            ask(questions);
        }
        settle_hidden(parts, number, exchange, has_own);
    }
    [[nodiscard]] std::vector<WholeHidden> hidden() const final { return hidden_; }
    [[nodiscard]] Told told() const noexcept final { return told_; }

 protected:
    /// Known without a structure, and the places of sites among its.
    template <class PlacedOf, class IsOwn>
    [[nodiscard]] static std::pair<Known, std::vector<Index>> known_sites(const Numbers& numbers,
                                                                          const PlacedOf& placed,
                                                                          const IsOwn& is_own) {
        Known known;
        const std::vector<Index> order = numbers.in_order();
        std::vector<Index> place(order.size());
        for (const Index v : order) {
            place[static_cast<std::size_t>(v)] = static_cast<Index>(known.ids.size());
            const Placed each = placed(v);
            known.ids.push_back(each.id);
            known.are_own.push_back(static_cast<char>(is_own(v)));
            known.sites.push_back(each.site);
        }
        return {std::move(known), std::move(place)};
    }

    /// The structure of the own sites and those of others.
    virtual void build(std::span<const Placed> own, const std::vector<Placed>& others,
                       const std::stop_token& stop) = 0;
    /// More of others.
    virtual void insert(const std::vector<Placed>& others) = 0;
    /// About all that has come since it was last called, and that sites may reach that are not
    /// known.
    virtual void ask(std::vector<Questions>& questions) = 0;
    [[nodiscard]] virtual std::vector<HiddenBy> hidden_by_known() = 0;

    /// Where sites are that are not known: of each part, beyond the sides of a box.
    [[nodiscard]] const Extent& searched() const noexcept { return searched_; }
    [[nodiscard]] const std::vector<std::pair<std::size_t, Extent>>& unknown() const noexcept {
        return unknown_;
    }
    [[nodiscard]] bool may_be_reached(const Ball<K>& ball) const {
        return std::ranges::any_of(
            beyond_, [&](const Extent& side) { return ball.may_be_reached_from(side); });
    }
    /// Whether a search for faces that sites which are not known may reach goes on at a face: with
    /// n towards any side of the box, where f >= h - G at its vertex (part.hpp).
    [[nodiscard]] bool leads_on(const Ball<K>& ball) const {
        if (beyond_.empty()) return false;
        for (std::size_t axis = 0; axis < K::dimension; ++axis)
            if (ball.leads(axis, 1.0, searched_.high[axis], greatest_) ||
                ball.leads(axis, -1.0, searched_.low[axis], greatest_))
                return true;
        return false;
    }
    void ask_about_face(const Corners& face, std::vector<Questions>& questions) {
        const Ball<K> ball(face);
        for_parts_with([&](const Extent& extent) { return ball.may_be_reached_from(extent); },
                       [&](std::size_t part) { questions[part].faces.push_back(face); });
        ++told_.faces;
    }
    void ask_about_edge(const EdgeQuestion& edge, std::vector<Questions>& questions) {
        const Middle middle = Middle::between_faces<K>(edge);
        for_parts_with([&](const Extent& extent) { return middle.may_be_taken_from(extent); },
                       [&](std::size_t part) { questions[part].edges.push_back(edge); });
        ++told_.edges;
    }

 private:
    /// So many times how far own sites are apart are looked beyond the own box.
    static constexpr double looked_beyond = K::dimension == 3 ? 2.5 : 3.0;

    /// What is known of others: all in a box, and nothing beyond its sides.
    void look_around(const SiteStore& own, std::span<const PartBounds> parts, std::size_t number) {
        const auto grown = [&](double by) {
            Extent box = own.extent();
            for (std::size_t axis = 0; axis < K::dimension; ++axis) {
                box.low[axis] -= by;
                box.high[axis] += by;
            }
            return box;
        };
        const bool has_own = !own.sites().empty();
        double spacing = own.spacing();
        const Extent most = grown(looked_beyond * spacing);
        for (const PartBounds& other : parts)
            if (!is_empty(other.extent) && meet(other.extent, most))
                spacing = std::min(spacing, other.spacing);
        searched_ = grown(looked_beyond * spacing);

        unknown_.clear();
        Extent all = no_extent();
        for (std::size_t q = 0; q < parts.size() && has_own; ++q) {
            if (q == number || is_empty(parts[q].extent)) continue;
            all.include(parts[q].extent);
            for (const Extent& beyond : sides_of(searched_)) {
                const Extent extent = overlap(parts[q].extent, beyond);
                if (meet(extent, extent)) unknown_.push_back({q, extent});
            }
        }
        greatest_ = all.high[weight_place];
        beyond_.clear();
        if (unknown_.empty()) return;
        for (const Extent& side : sides_of(searched_))
            if (const Extent extent = overlap(all, side); meet(extent, extent))
                beyond_.push_back(extent);
    }
    /// The half-spaces beyond the sides of a box, as extents.
    [[nodiscard]] static std::vector<Extent> sides_of(const Extent& box) {
        constexpr double far = HUGE_VAL;
        const Extent all = {{-far, -far, -far, -far}, {far, far, far, far}};
        std::vector<Extent> sides(2 * K::dimension, all);
        for (std::size_t axis = 0; axis < K::dimension; ++axis) {
            sides[2 * axis].low[axis] = std::nextafter(box.high[axis], far);
            sides[2 * axis + 1].high[axis] = std::nextafter(box.low[axis], -far);
        }
        return sides;
    }
    [[nodiscard]] static Extent overlap(const Extent& a, const Extent& b) noexcept {
        Extent both = a;
        for (std::size_t axis = 0; axis < axes; ++axis) {
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
    /// Calls ask(part) for each part of whose sites that are not known may(extent) says so.
    template <class May, class Ask>
    void for_parts_with(const May& may, const Ask& ask) const {
        std::size_t asked = parts_of_none;
        for (const auto& [part, extent] : unknown_) {
            if (part == asked || !may(extent)) continue;
            ask(part);
            asked = part;
        }
    }

    void settle_hidden(std::span<const PartBounds> parts, std::size_t number, Exchange& exchange,
                       bool has_own) {
        std::vector<HiddenBy> hidden;
        if (has_own) hidden = hidden_by_known();
        std::vector<Extent> extents;
        for (const PartBounds& each : parts) extents.push_back(each.extent);
        ask_for_nearest<K>(hidden, extents, number, exchange);
        hidden_.clear();
        for (const auto& [site, by] : hidden) hidden_.push_back({site.id, by.id});
        std::ranges::sort(hidden_, {}, &WholeHidden::site);
    }

    static constexpr std::size_t parts_of_none = ~std::size_t{0};

    Extent searched_ = no_extent();
    std::vector<std::pair<std::size_t, Extent>> unknown_;
    std::vector<Extent> beyond_;   ///< all of it, side by side
    double greatest_ = -HUGE_VAL;  ///< what weighs any site there, at most
    std::unordered_set<std::int64_t> guests_;
    std::vector<WholeHidden> hidden_;
    Told told_;
};

}  // namespace signum::distributed
