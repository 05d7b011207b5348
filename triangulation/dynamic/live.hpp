#pragma once
/// Sites of one metric that come, go and move, and their tessellation.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "../../core/index.hpp"
#include "../../core/site.hpp"
#include "../dynamic.hpp"
#include "../insertion/collinear.hpp"
#include "../insertion/delete.hpp"
#include "../insertion/hiders.hpp"
#include "../insertion/insert.hpp"
#include "../structure/assemble.hpp"
#include "../structure/spatial_order.hpp"
#include "../structure/topology.hpp"
#include "../triangulate.hpp"
#include "lists.hpp"
#include "local_checks.hpp"
#include "near_face.hpp"
#include "ranks.hpp"
#include "repair.hpp"
#include "star.hpp"

namespace signum::triangulation {

/// Laws:
///  1. Where the visible sites have a structure, topology_ is their tessellation (is_built_), and
///     line_ is empty. Where they have none, all centres on one line in the power metric, one
///     visible site or none in the others, they stand in line_, in order.
///  2. hidden_by_ is -1 for visible sites alone. face_of_ is a face at a visible site of the
///     structure, and -1 for every other place.
///  3. A hidden site is kept by one that hides it alone, whether that is visible itself or not: in
///     the power metric one with the same centre. Or, in the power metric, by a visible corner of
///     a face, or end of a stretch of the line, that contains its centre. So it can reappear only
///     where the one that keeps it goes, or, in the latter case, that face.
///  4. A site has a place for as long as nothing is built anew: place_of_ says which, handle_of_ is
///     the other way round, and free handles have the places that are left. All below speaks of
///     places but for the public functions. The tie rule knows sites by their handles.
///  5. Where an exception leaves a change, the sites are those before it, and what is built is of
///     no use (is_broken_; laws 1 to 3 need not hold): the next change begins with building anew.
template <class Kernel>
class Live {
 public:
    using S = typename Kernel::SiteType;
    static constexpr bool is_straight = Kernel::is_straight;

    explicit Live(Metric metric)
        : metric_(metric), ranks_(sites_, handle_of_), line_(Along{&sites_}) {
        grow(16);
    }
    Live(const Live&) = delete;
    Live& operator=(const Live&) = delete;

    [[nodiscard]] bool contains(Index handle) const noexcept {
        return handle >= 0 && at(handle) < live_.size() && live_[at(place_of_[at(handle)])];
    }
    [[nodiscard]] std::size_t size() const noexcept { return count_; }
    [[nodiscard]] std::size_t rebuilds() const noexcept { return rebuilds_; }
    [[nodiscard]] std::uint64_t insertions() const noexcept { return insertions_; }
    [[nodiscard]] const Moves& moves() const noexcept { return moves_; }
    [[nodiscard]] Site site(Index handle) const noexcept { return site_at(place_of_[at(handle)]); }

    Index insert(const Site& site) {
        return guarded([&] {
            std::set<Index>::node_type freed;
            if (!free_.empty()) freed = free_.extract(free_.begin());
            const Index handle = freed.empty() ? static_cast<Index>(count_) : freed.value();
            const auto undo = [&] {
                if (at(handle) < live_.size()) live_[at(place_of_[at(handle)])] = false;
                free_.insert(std::move(freed));
            };
            with_undo(undo, [&] {
                if (at(handle) == live_.size()) grow(2 * live_.size());
                const Index h = place_of_[at(handle)];
                put(h, site);
                add(h);
            });
            return handle;
        });
    }

    void erase(Index handle) {
        guarded([&] {
            std::set<Index> freed = {handle};
            with_undo(given_back(handle), [&] { take(place_of_[at(handle)]); });
            free_.merge(freed);
        });
    }

    void change(Index handle, double third) {
        guarded([&] {
            Site site = this->site(handle);
            site.r = third;
            with_undo(given_back(handle), [&] { replace(handle, site); });
        });
    }

    void move(Index handle, Point centre) {
        guarded([&] {
            const Index h = place_of_[at(handle)];
            with_undo(given_back(handle), [&] {
                if (is_built_ && face_of_[at(h)] >= 0 && move_inside(h, centre)) {
                    ++moves_.kept;
                    return;
                }
                ++moves_.mended;
                replace(handle, {centre.x, centre.y, site_at(h).r});
            });
        });
    }

    /// See repair.hpp. Of a large set that came in no order the memory is read in no order, too: it
    /// is built anew, along a curve, and again when as many edges have changed as there are.
    void move_all(std::span<const Point> centres) {
        guarded([&] {
            moved_ = sites_;
            place_before_ = place_of_;
            std::size_t next = 0;
            for (std::size_t handle = 0; next < centres.size(); ++handle)
                if (const Index h = place_of_[handle]; live_[at(h)])
                    set_centre(moved_[at(h)], centres[next++]);
            has_moved_ = false;
            const auto undo = [&] {
                if (!has_moved_) return;
                for (std::size_t handle = 0; handle < place_of_.size(); ++handle)
                    sites_[at(place_of_[handle])] = moved_[at(place_before_[handle])];
            };
            with_undo(undo, [&] {
                if constexpr (!is_straight) ranks_.renew(moved_);
                const bool is_scattered = count_ > large && changes_ > 2 * count_;
                if (!is_built_ || is_scattered || !mend()) {
                    ++moves_.built;
                    swap_moved();
                    build();
                }
            });
        });
    }

    [[nodiscard]] Tessellation tessellation() const {
        std::vector<Site> live;
        std::vector<Index> number(live_.size(), -1);  // by place
        for (const Index h : place_of_)
            if (live_[at(h)]) {
                number[at(h)] = static_cast<Index>(live.size());
                live.push_back(site_at(h));
            }
        constexpr WeightIs weight_is =
            std::is_same_v<S, power::Site> ? WeightIs::weight : WeightIs::radius;
        if (!is_built_) return triangulate({live, weight_is == WeightIs::weight}, metric_);
        std::vector<Index> hidden_by = hidden_by_;
        settle_hiders(*topology_, *kernel_, hidden_by, Workers(1));
        TessellationArrays arrays;
        arrays.metric = metric_;
        arrays.weight_is = weight_is;
        arrays.sites = static_cast<std::int64_t>(live.size());
        for (const Index h : place_of_)
            if (live_[at(h)] && hidden_by[at(h)] >= 0)
                arrays.hidden.push_back({number[at(h)], number[at(hidden_by[at(h)])]});
        assemble(Topology(*topology_), number, number, arrays, Workers(1));
        return {std::move(arrays), std::move(live), {}};
    }

 private:
    /// So many sites, and what belongs to them, lie in a processor's caches, in whatever order.
    static constexpr std::size_t large = std::size_t{1} << 14;
    /// Where of so many sites more than one edge or face is wrong, or more than one site must be
    /// taken out, to build is quicker than to mend (benchmarks/moves_benchmark.cpp).
    static constexpr std::size_t most_wrong = 4;
    static constexpr std::size_t most_taken = 16;

    [[nodiscard]] Site site_at(Index h) const noexcept {
        const S& s = sites_[at(h)];
        if constexpr (requires { s.w; })
            return {s.x, s.y, s.w};
        else
            return {s.x, s.y, s.r};
    }
    static void set_centre(S& site, Point centre) noexcept {
        site.x = centre.x;
        site.y = centre.y;
    }

    /// Does what may be left by an exception. What is built is of no use then: the next change
    /// builds it anew.
    template <class Change>
    decltype(auto) guarded(const Change& change) {
        try {
            if (is_broken_) restore();
            return change();
        } catch (...) {
            is_broken_ = true;
            is_built_ = false;
            throw;
        }
    }
    /// Puts the sites back where an exception leaves a change; `undo` tells those that it concerns.
    template <class Undo, class Change>
    void with_undo(const Undo& undo, const Change& change) {
        const std::size_t count = count_;
        try {
            change();
        } catch (...) {
            undo();
            count_ = count;
            throw;
        }
    }
    /// Undoes whatever has become of the site, wherever its place is then.
    [[nodiscard]] auto given_back(Index handle) noexcept {
        return [this, handle, site = sites_[at(place_of_[at(handle)])]] {
            const std::size_t h = at(place_of_[at(handle)]);
            sites_[h] = site;
            live_[h] = true;
        };
    }
    void restore() {
        grow(live_.size());
        build();
        is_broken_ = false;
    }
    void swap_moved() noexcept {
        sites_.swap(moved_);
        has_moved_ = true;
    }

    /// Another site under the same handle.
    void replace(Index handle, const Site& site) {
        take(place_of_[at(handle)]);
        const Index h = place_of_[at(handle)];
        put(h, site);
        add(h);
    }

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

    /// Room for so many sites; what an exception has left half done it does again.
    void grow(std::size_t capacity) {
        sites_.resize(capacity);
        hidden_by_.resize(capacity, -1);
        none_hidden_.resize(capacity, -1);
        face_of_.resize(capacity, -1);
        kept_.make_room(2 * capacity, capacity);
        handle_of_.reserve(capacity);
        place_of_.reserve(capacity);
        live_.resize(capacity, false);
        for (std::size_t h = handle_of_.size(); h < capacity; ++h) {
            handle_of_.push_back(static_cast<Index>(h));
            place_of_.push_back(static_cast<Index>(h));
        }
        kernel_ = std::make_unique<Kernel>(kernel_of(sites_));
        if (!is_built_) return;
        topology_->make_room(capacity);
        const Index recent = insertion_->recent();
        insertion_ = std::make_unique<Insertion<Kernel>>(*topology_, *kernel_, hidden_by_, recent);
    }

    [[nodiscard]] Kernel kernel_of(const std::vector<S>& sites) const noexcept {
        if constexpr (is_straight)
            return Kernel(sites.data(), handle_of_.data());
        else
            return Kernel(sites.data());
    }

    /// From scratch, along a curve.
    void build() {
        is_built_ = false;
        line_.clear();
        kept_.clear();
        std::fill(hidden_by_.begin(), hidden_by_.end(), -1);
        std::fill(face_of_.begin(), face_of_.end(), -1);
        sort_places();
        *kernel_ = kernel_of(sites_);
        if constexpr (!is_straight) ranks_.restart(count_);
        for (Index h = 0; at(h) < count_; ++h) add_near_recent(h);
        changes_ = 0;
    }

    /// The live sites get the first places, in the order of insertion, the free handles the rest.
    void sort_places() {
        std::vector<Index> handles;
        std::vector<S> sites;
        std::vector<Index> free;
        for (std::size_t h = 0; h < live_.size(); ++h) {
            if (!live_[h]) {
                free.push_back(handle_of_[h]);
                continue;
            }
            handles.push_back(handle_of_[h]);
            sites.push_back(sites_[h]);
        }
        std::ranges::sort(free);
        StridedSites view;
        if (!sites.empty()) view = {sites.size(), sizeof(S), &sites[0].x, &sites[0].y};
        std::size_t place = 0;
        for (const Index i : spatial_order(view, 1)) {
            sites_[place] = sites[at(i)];
            handle_of_[place++] = handles[at(i)];
        }
        std::ranges::copy(free, handle_of_.begin() + static_cast<std::ptrdiff_t>(place));
        for (std::size_t h = 0; h < live_.size(); ++h) {
            live_[h] = h < place;
            place_of_[at(handle_of_[h])] = static_cast<Index>(h);
        }
    }

    /// From the line, of two sites at least, to a structure: the same sites, tied to infinity.
    void leave_line() {
        const std::vector<Index> chain(line_.begin(), line_.end());
        line_.clear();
        topology_ = std::make_unique<Topology>(live_.size());
        connect_line(*topology_, chain);
        insertion_ = std::make_unique<Insertion<Kernel>>(*topology_, *kernel_, hidden_by_, 0);
        is_built_ = true;
        for (Index f = 0; f < topology_->faces(); ++f) note_face(f);
    }

    /// And back, when the sites that stay visible have no structure any more.
    void return_to_line(const std::vector<Index>& visible) {
        is_built_ = false;
        for (const Index v : visible) {
            face_of_[at(v)] = -1;
            line_.insert(v);
        }
    }

    void note_face(Index f) {
        for (const Index v : topology_->vertices(f))
            if (v >= 0) face_of_[at(v)] = f;
    }

    [[nodiscard]] HalfEdge spoke_of(Index v) const { return topology_->spoke(face_of_[at(v)], v); }

    /// The two lists of those that u keeps: by itself, and with others.
    [[nodiscard]] static Index alone(Index u) noexcept { return 2 * u; }
    [[nodiscard]] static Index with_others(Index u) noexcept { return 2 * u + 1; }

    /// `by` comes before `hidden` in the tie rule's order, or hides it with others.
    void keep(Index by, Index hidden) {
        hidden_by_[at(hidden)] = by;
        face_of_[at(hidden)] = -1;
        const bool is_alone = !is_straight || kernel_->centre(by) == kernel_->centre(hidden);
        kept_.add(is_alone ? alone(by) : with_others(by), hidden);
    }

    /// A visible site vanishes behind h. What it keeps with others lies in faces that h has now.
    void hide(Index v, Index h) {
        keep(h, v);
        for (const Index of_v : kept_.release(with_others(v))) keep(h, of_v);
    }

    [[nodiscard]] Index face_near(const S& site) const noexcept {
        const std::span<const Index> face_of(face_of_.data(), count_ + free_.size());
        return near_face(*topology_, face_of, insertion_->recent(), [&](Index v) {
            const double x = sites_[at(v)].x - site.x;
            const double y = sites_[at(v)].y - site.y;
            return x * x + y * y;
        });
    }

    /// Inserts a live site that is in no list.
    void add(Index h) {
        if (is_built_) insertion_->start_from(face_near(sites_[at(h)]));
        add_near_recent(h);
    }
    /// The same where the one inserted last is not far.
    void add_near_recent(Index h) {
        ++insertions_;
        hidden_by_[at(h)] = -1;
        if (!is_built_) return add_to_line(h);
        if (!insertion_->insert(h)) return add_above_all(h);
        if (Index by = hidden_by_[at(h)]; by >= 0) {
            if constexpr (is_straight)
                for (const Index v : topology_->vertices(insertion_->recent()))
                    if (v != infinite && kernel_->centre(v) == kernel_->centre(h)) by = v;
            keep(by, h);
            return;
        }
        changes_ += 3;
        for (const Index v : insertion_->enclosed()) hide(v, h);
        face_of_[at(h)] = insertion_->recent();
        for (const HalfEdge of : topology_->fan(spoke_of(h))) note_face(Topology::face(of));
        if constexpr (is_straight)
            for (const Index hidden : taken_from_star(h)) keep(h, hidden);
    }

    /// h hides all others.
    void add_above_all(Index h) {
        for (Index f = 0; f < topology_->faces(); ++f)
            for (const Index v : topology_->vertices(f))
                if (v >= 0 && face_of_[at(v)] >= 0) hide(v, h);
        return_to_line({h});
    }

    /// The same as long as the visible sites have no structure.
    void add_to_line(Index h) {
        if (line_.empty()) {
            line_.insert(h);
        } else if constexpr (is_straight) {
            if (line_.size() > 1 && kernel_->ccw(*line_.begin(), *line_.rbegin(), h) != 0) {
                --insertions_;
                leave_line();
                return add(h);
            }
            add_on_line(h);
        } else {
            const Index other = *line_.begin();
            if (kernel_->hides(other, h)) {
                keep(other, h);
                return;
            }
            const bool hides_other = kernel_->hides(h, other);
            if (hides_other) {
                line_.clear();
                keep(h, other);
            }
            line_.insert(h);
            if (!hides_other) leave_line();
        }
    }

    /// One step of a lower hull that is kept in order (power metric).
    void add_on_line(Index h) {
        auto after = line_.lower_bound(h);
        if (after != line_.end() && kernel_->centre(*after) == kernel_->centre(h)) {
            if (precedes(*after, h)) {
                keep(*after, h);
                return;
            }
            hide(*after, h);
            after = line_.erase(after);
        } else if (after != line_.begin() && after != line_.end() &&
                   !kernel_->conflicts_on_line(*std::prev(after), *after, h)) {
            keep(*after, h);
            return;
        }
        const auto place = line_.insert(after, h);
        // Out of two neighbours on one side the nearer one vanishes above h and the farther one.
        while (place != line_.begin() && std::prev(place) != line_.begin()) {
            const auto near = std::prev(place);
            if (kernel_->conflicts_on_line(*std::prev(near), h, *near)) break;
            hide(*near, h);
            line_.erase(near);
        }
        while (std::next(place) != line_.end() && std::next(place, 2) != line_.end()) {
            const auto near = std::next(place);
            if (kernel_->conflicts_on_line(h, *std::next(near), *near)) break;
            hide(*near, h);
            line_.erase(near);
        }
        for (const Index hidden : taken_from_line(place)) keep(h, hidden);
    }

    /// The hidden sites on the two stretches at a place of the line, out of those that the ends of
    /// these keep and one of them would not keep without that place.
    template <class Place>
    [[nodiscard]] std::vector<Index> taken_from_line(Place place) {
        std::vector<Index> taken;
        const auto before = line_.key_comp();
        if (place != line_.begin())
            kept_.extract(with_others(*std::prev(place)), taken,
                          [&](Index hidden) { return before(*std::prev(place), hidden); });
        if (std::next(place) != line_.end())
            kept_.extract(with_others(*std::next(place)), taken,
                          [&](Index hidden) { return before(hidden, *std::next(place)); });
        return taken;
    }

    /// The hidden sites whose centres lie in the star of h, out of those that its neighbours keep.
    [[nodiscard]] std::vector<Index> taken_from_star(Index h) {
        std::vector<Index> taken;
        const HalfEdge spoke = spoke_of(h);
        std::optional<Star<Kernel>> star;
        for (const HalfEdge of : topology_->fan(spoke)) {
            const Index u = topology_->target(of);
            if (u == infinite || kept_.is_empty(with_others(u))) continue;
            if (!star) star.emplace(*topology_, *kernel_, spoke);
            kept_.extract(with_others(u), taken,
                          [&](Index hidden) { return star->contains(hidden); });
        }
        return taken;
    }

    /// Out of the sites and out of what is built.
    void take(Index h) {
        std::vector<Index> freed = kept_.release(alone(h));
        pair_off(freed);
        bool is_whole = true;
        if (hidden_by_[at(h)] >= 0)
            kept_.remove(h);
        else
            is_whole = detach(h, freed);
        live_[at(h)] = false;
        hidden_by_[at(h)] = -1;
        face_of_[at(h)] = -1;
        if constexpr (!is_straight) ranks_.erase(h);
        --count_;
        if (!is_whole) {
            ++rebuilds_;
            return build();
        }
        add_all(freed);
    }

    /// A visible site out of what is built, and those that it keeps with others, which are freed;
    /// false where all has to be built anew.
    bool detach(Index h, std::vector<Index>& freed) {
        const std::vector<Index> others = kept_.release(with_others(h));
        freed.insert(freed.end(), others.begin(), others.end());
        changes_ += 3;
        return is_built_ ? take_from_structure(h, freed) : take_from_line(h, freed);
    }

    /// Of sites that one alone hid many may hide one another. In pairs, one keeps the other: half
    /// of them are left for the next time, instead of all for every one that goes.
    void pair_off(std::vector<Index>& sites) {
        std::ranges::sort(sites, [&](Index a, Index b) { return precedes(a, b); });
        std::vector<Index> left;
        for (std::size_t i = 0; i < sites.size(); ++i) {
            left.push_back(sites[i]);
            if (i + 1 < sites.size() && hides_alone(sites[i], sites[i + 1])) {
                keep(sites[i], sites[i + 1]);
                ++i;
            }
        }
        sites = std::move(left);
    }

    /// Whether a alone hides b, which comes behind it in the tie rule's order.
    [[nodiscard]] bool hides_alone(Index a, Index b) {
        if constexpr (is_straight)
            return kernel_->centre(a) == kernel_->centre(b);
        else
            return kernel_->hides(a, b);
    }

    bool take_from_line(Index h, std::vector<Index>& freed) {
        const auto place = line_.find(h);
        const std::vector<Index> taken = taken_from_line(place);
        freed.insert(freed.end(), taken.begin(), taken.end());
        line_.erase(place);
        return true;
    }

    /// False where all has to be built anew.
    bool take_from_structure(Index h, std::vector<Index>& freed) {
        const HalfEdge spoke = spoke_of(h);
        if constexpr (is_straight)
            for (const Index hidden : taken_from_star(h)) freed.push_back(hidden);
        std::vector<Index> ring;
        patch_.clear();
        for (const HalfEdge of : topology_->fan(spoke)) {
            if (const Index v = topology_->target(of); v != infinite) ring.push_back(v);
            patch_.push_back(Topology::face(of));
            patch_.push_back(Topology::face(topology_->twin(Topology::next(of))));
        }
        switch (Deletion<Kernel>(*insertion_, none_hidden_).erase(spoke)) {
            case Gap::closed:
                break;
            case Gap::open:
                return_to_line(ring);
                return true;
            case Gap::ambiguous:
                return false;
        }
        // The faces of the patch take places of the star's.
        std::erase_if(patch_, [&](Index f) { return topology_->is_vacant(f); });
        for (const Index f : patch_) note_face(f);
        return true;
    }

    /// All sites to the places where they are in moved_; false, and what is built is of no use any
    /// more, where that is better done from scratch.
    bool mend();

    /// Gives the hidden sites to those that keep them now that all have moved; whether all stay
    /// hidden. Some are looked at where others do not lie yet in the star of their keepers: these
    /// are looked at in their turn.
    bool keep_hidden();

    /// A site to another centre, if its star is as right there and is not at the hull, so that the
    /// hull stays as it is; otherwise nothing is done.
    bool move_inside(Index h, Point centre);
    void displace(Index h, Point centre) {
        if constexpr (!is_straight) ranks_.erase(h);
        set_centre(sites_[at(h)], centre);
        if constexpr (!is_straight) ranks_.insert(h);
    }
    [[nodiscard]] bool is_star_right(HalfEdge spoke);

    /// The earlier in the rule's order, the less often a site is hidden again. Many come in that of
    /// construction: in another one each might change what all before it made.
    void add_all(std::vector<Index>& sites) {
        constexpr std::size_t few = 64;
        std::ranges::sort(sites, [&](Index a, Index b) { return precedes(a, b); });
        if (sites.size() <= few) {
            for (const Index site : sites) add(site);
            return;
        }
        std::vector<S> centres;
        for (const Index site : sites) centres.push_back(sites_[at(site)]);
        const StridedSites view(centres.size(), sizeof(S), &centres[0].x, &centres[0].y);
        for (const Index i : spatial_order(view, 1)) add(sites[at(i)]);
    }

    [[nodiscard]] bool precedes(Index a, Index b) const {
        if constexpr (is_straight)
            return a != b && kernel_->precedes(a, b);
        else
            return sites_[at(a)].rank < sites_[at(b)].rank;
    }

    [[nodiscard]] static std::size_t at(Index i) noexcept { return static_cast<std::size_t>(i); }
    /// The order of centres along any line.
    struct Along {
        const std::vector<S>* sites;
        bool operator()(Index a, Index b) const {
            const S& p = (*sites)[at(a)];
            const S& q = (*sites)[at(b)];
            return p.x != q.x ? p.x < q.x : p.y < q.y;
        }
    };
    struct NoRanks {
        NoRanks(std::vector<S>&, std::vector<Index>&) {}
    };

    Metric metric_;
    std::vector<S> sites_;
    std::vector<bool> live_;
    std::vector<Index> hidden_by_;
    std::vector<Index> none_hidden_;
    std::vector<Index> face_of_;
    Lists kept_;
    std::vector<Index> handle_of_;
    std::vector<Index> place_of_;
    std::set<Index> free_;  // handles
    std::vector<S> moved_;  // the sites at other centres, while all move; then, before that
    std::vector<Index> place_before_;  // and their places there
    bool has_moved_ = false;           // which of the two
    std::vector<Index> patch_;         // the faces that the last deletion made
    std::size_t changes_ = 0;          // edges, roughly, since the last time that all was built
    Moves moves_;
    std::size_t count_ = 0;
    std::size_t rebuilds_ = 0;
    std::uint64_t insertions_ = 0;
    bool is_built_ = false;
    bool is_broken_ = false;
    [[no_unique_address]] std::conditional_t<is_straight, NoRanks, Ranks> ranks_;
    std::set<Index, Along> line_;
    std::unique_ptr<Kernel> kernel_;
    std::unique_ptr<Topology> topology_;
    std::unique_ptr<Insertion<Kernel>> insertion_;
};

}  // namespace signum::triangulation

#include "live_moves.hpp"
