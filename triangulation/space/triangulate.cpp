#include "triangulate.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "../../core/insertion_rounds.hpp"
#include "../../core/pages.hpp"
#include "../../core/parallel.hpp"
#include "../../exact/floating_environment.hpp"
#include "../../predicates/space/nearer.hpp"
#include "../structure/watch.hpp"
#include "build.hpp"
#include "construct.hpp"
#include "kernel.hpp"
#include "nearest_site.hpp"
#include "order.hpp"
#include "parts.hpp"

namespace signum {
namespace {

using spatial::Builder;
using spatial::Cells;
using spatial::HiddenNear;
using spatial::infinite;
using spatial::Leaves;
using spatial::Mark;

template <class S, class Kernel>
class Construction {
 public:
    Construction(std::span<const S> sites, const Options& options, int levels)
        : sites_(sites),
          options_(options),
          workers_(Kernel::is_exact ? options.threads : 1, sites.size()),
          levels_(!Kernel::is_exact               ? 0
                  : levels != spatial::any_levels ? levels
                  : sites.size() < 8 * spatial::sampled
                      ? 0
                      : spatial::levels_for(sites.size(), workers_)),
          is_forced_(levels != spatial::any_levels),
          watch_(options.stop, options.progress, sites.size()) {}

    [[nodiscard]] SpaceTessellation run() {
        SpaceTessellation result;
        result.sites = static_cast<std::int64_t>(sites_.size());
        if (sites_.empty()) return result;
        LargeArray<Index> order = counted<Index>(workers_, sites_.size());
        if (levels_ > 0 && build_in_parts(order)) {
            result.dimension = 3;
        } else {
            put_in_order(order);
            build(order, result);
        }
        watch_.end();
        find_nearest(result.hidden);
        all_ = {};
        release(hidden_);
        assemble(result);
        if constexpr (!Kernel::is_exact) expect_all(result);
        return result;
    }

 private:
    [[nodiscard]] const S& site(Index i) const noexcept {
        return sites_[static_cast<std::size_t>(i)];
    }
    void put_in_order(std::span<Index> order) const {
        spatial::put_in_insertion_order(
            order, [&](Index i) { return centre3(site(i)); }, options_.seed);
    }

    [[nodiscard]] auto in_parts(std::span<const Index> some, int levels, std::span<Mark> marks,
                                const triangulation::Watch& watch) const {
        return spatial::PartsOfSpace<S>(sites_, some, levels, is_forced_, marks, workers_,
                                        options_.seed, watch)
            .run();
    }
    /// Whether parts are joined, and not handed on to one thread, tried with a sample of the sites.
    /// Of sites on a sphere, or on any surface that is thinner than the sample's sites are apart,
    /// nearly all may be reached from beyond a cut. Leaves the marks as they are.
    [[nodiscard]] bool parts_help(std::span<Mark> marks) const {
        std::vector<Index> sample;
        for (std::size_t i = 0; i < spatial::sampled; ++i)
            sample.push_back(static_cast<Index>(mix(options_.seed + i) % sites_.size()));
        std::ranges::sort(sample);
        sample.erase(std::unique(sample.begin(), sample.end()), sample.end());
        const std::function<void(double)> nobody;
        const triangulation::Watch watch(options_.stop, nobody, sample.size());
        bool help = false;
        watch.guard_all([&] { help = in_parts(sample, 1, marks, watch).part.loose.empty(); });
        for (const Index i : sample) marks[static_cast<std::size_t>(i)] = Mark::is_elsewhere;
        return help;
    }

    /// False, and there are no cells, where nothing is gained by parts; `order` then holds the
    /// sites that are not known to be hidden, so far.
    [[nodiscard]] bool build_in_parts(LargeArray<Index>& order) {
        if constexpr (Kernel::is_exact) {
            LargeArray<Mark> marks(sites_.size(), Mark::is_elsewhere);
            if (!is_forced_ && !parts_help(marks)) return false;
            typename spatial::PartsOfSpace<S>::Result built;
            watch_.guard_all([&] { built = in_parts(order, levels_, marks, watch_); });
            auto& [leaves, part, numbers] = built;
            if (part.loose.empty()) {
                leaves_ = std::move(leaves);
                if (!part.hidden.empty()) take_hidden(std::move(numbers), part.hidden);
                return true;
            }
            // The dimension is that of all sites, the hidden ones, too.
            if (Builder<S>(sites_, part.loose).apexes() > 0) return false;
            hidden_before_ = std::move(part.hidden);
            order.assign(part.loose.begin(), part.loose.end());
        }
        return false;
    }
    /// All cells, and who is hidden.
    void build(LargeArray<Index>& order, SpaceTessellation& result) {
        Builder<S> builder(sites_, order);
        builder.copy_sites();
        release(order);
        result.dimension = 3 - static_cast<int>(builder.apexes());
        auto built =
            builder.template run<Kernel>([&](Index q) { watch_.at(static_cast<std::size_t>(q)); });
        leaves_.cells.push_back(std::move(built.cells));
        room_ = std::move(built.room);
        if (hidden_before_.empty()) {
            all_ = std::move(builder).release_sites();
            hidden_ = std::move(built.hidden);
            return;
        }
        // With those that are hidden by parts alone.
        for (const HiddenNear& each : built.hidden)
            hidden_before_.push_back({builder.number(each.site), builder.number(each.near)});
        LargeArray<Index> numbers = std::move(builder).release_sites().numbers;
        std::vector<bool> has_place(sites_.size(), false);
        for (const Index i : numbers) has_place[static_cast<std::size_t>(i)] = true;
        for (Index i = 0; i < static_cast<Index>(sites_.size()); ++i)
            if (!has_place[static_cast<std::size_t>(i)]) numbers.push_back(i);
        take_hidden(std::move(numbers), hidden_before_);
    }
    /// All sites in such an order, without apexes, and who is hidden, by the places there.
    void take_hidden(LargeArray<Index> numbers, std::span<const HiddenNear> hidden) {
        all_.numbers = std::move(numbers);
        all_.sites = LargeArray<S>(all_.numbers.size());
        LargeArray<Index> place(sites_.size());
        workers_.each_range(all_.sites.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t p = begin; p < end; ++p) {
                all_.sites[p] = site(all_.numbers[p]);
                place[static_cast<std::size_t>(all_.numbers[p])] = static_cast<Index>(p);
            }
        });
        hidden_.resize(hidden.size());
        workers_.each_range(hidden.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t h = begin; h < end; ++h)
                hidden_[h] = {place[static_cast<std::size_t>(hidden[h].site)],
                              place[static_cast<std::size_t>(hidden[h].near)]};
        });
    }

    /// The visible site nearest to the centre of each hidden one. Looked for from whoever hid it or
    /// was nearest to it when it came, or, where that has become hidden itself, from whoever did so
    /// to that one.
    void find_nearest(std::vector<Hidden>& result) const {
        if (hidden_.empty()) return;
        constexpr Index is_visible = -1;
        LargeArray<Index> hider(all_.sites.size(), is_visible);
        for (auto last = hidden_.rbegin(); last != hidden_.rend(); ++last) {
            const auto& [v, near] = *last;
            const Index of_near = hider[static_cast<std::size_t>(near)];
            hider[static_cast<std::size_t>(v)] = of_near == is_visible ? near : of_near;
        }
        LargeArray<Index> visible;
        visible.reserve(all_.sites.size() - hidden_.size());
        for (Index v = 0; v < static_cast<Index>(all_.sites.size()); ++v)
            if (hider[static_cast<std::size_t>(v)] == is_visible && !is_apex(v))
                visible.push_back(v);
        if (!Kernel::is_exact && visible.empty()) throw BrokenStructure("all sites are hidden");
        const Index any = visible.front();
        const spatial::NearestSite<S> nearest(all_.sites, all_.numbers, std::move(visible));
        result.resize(hidden_.size());
        workers_.each_range(hidden_.size(), [&](std::size_t begin, std::size_t end) {
            const exact::IeeeEnvironment environment;
            for (std::size_t h = begin; h < end; ++h) {
                const auto v = static_cast<std::size_t>(hidden_[h].site);
                const Index start = hider[v];
                const Index by = nearest(centre3(all_.sites[v]), is_apex(start) ? any : start);
                result[h] = {all_.numbers[v], all_.numbers[static_cast<std::size_t>(by)]};
            }
        });
        std::ranges::sort(result, {}, &Hidden::site);
    }
    [[nodiscard]] bool is_apex(Index v) const noexcept {
        return all_.numbers[static_cast<std::size_t>(v)] >= static_cast<Index>(sites_.size());
    }
    /// Laws 1 and 2 of the result. Of one leaf in memory that the structure had: the spheres', then
    /// the vertices'. It is read from its first cell to its last: there neighbours lie close to one
    /// another, which in the result they do not.
    void assemble(SpaceTessellation& result) {
        const bool is_one = leaves_.cells.size() == 1;
        result.cells = std::move(room_);
        const Places places = sort_cells(result.cells);
        if (is_one) {
            result.neighbours = leaves_.cells[0].forget_vertices();
            result.neighbours.resize(result.cells.size());
        } else {
            workers_.each(leaves_.cells.size(), [&](std::size_t leaf) {
                static_cast<void>(leaves_.cells[leaf].forget_vertices());
            });
            make_room(workers_, result.cells.size(), result.neighbours);
        }
        const auto fill = [&](const Range& range, const auto& place_of) {
            const auto& [leaf, begin, end] = range;
            const Cells& structure = leaves_.cells[leaf];
            SpaceCell* const all = result.neighbours.data();
            for (Index c = begin; c < end; ++c) {
                const Index own = place_of(leaves_.name(leaf, c));
                if (own == no_vertex) continue;
                SpaceCell neighbours = structure.neighbour(c);
                for (Index& n : neighbours)
                    if (n >= 0) n = place_of(n);
                all[own] = neighbours;
            }
        };
        const std::vector<Range> ranges = ranges_of_cells();
        workers_.each(ranges.size(), [&](std::size_t i) {
            // Those of one leaf are named as they lie.
            if (is_one)
                fill(ranges[i], [place = places.all.data()](Index c) { return place[c]; });
            else
                fill(ranges[i], [place = places.all.data(), begins = places.begins.data(),
                                 leaves = leaves_.names()](Index c) {
                    return place[begins[leaves.leaf(c)] + leaves.local(c)];
                });
        });
        for (std::vector<SpaceCell>* const each : {&result.cells, &result.neighbours})
            if (each->size() < each->capacity() / 2)
                *each = std::vector<SpaceCell>(each->begin(), each->end());
    }
    /// At which place of the result each cell of the structure is, leaf by leaf; no_vertex for free
    /// ones.
    struct Places {
        LargeArray<Index> all;
        std::vector<Index> begins;  ///< of each leaf
    };
    /// Local cells of a leaf.
    struct Range {
        std::size_t leaf;
        Index begin, end;
    };
    /// Ranges that make up all cells, a few for each thread.
    [[nodiscard]] std::vector<Range> ranges_of_cells() const {
        std::vector<Range> ranges;
        const std::size_t leaves = leaves_.cells.size();
        for (std::size_t leaf = 0; leaf < leaves; ++leaf) {
            const std::size_t size = leaves_.cells[leaf].size();
            const std::size_t count = (workers_.range_count(leaves * size) + leaves - 1) / leaves;
            for (std::size_t i = 0; i < count; ++i)
                ranges.push_back({leaf, static_cast<Index>(size * i / count),
                                  static_cast<Index>(size * (i + 1) / count)});
        }
        return ranges;
    }
    /// Every site is visible, or hidden by one that is. Where regions of conflict were no balls, or
    /// flat sites had volumes by rounding, that need not be so.
    static void expect_all(const SpaceTessellation& result) {
        std::vector<bool> is_visible(static_cast<std::size_t>(result.sites), false);
        for (const SpaceCell& cell : result.cells)
            for (const Index v : cell)
                if (v >= 0) is_visible[static_cast<std::size_t>(v)] = true;
        std::vector<bool> is_told = is_visible;
        for (const auto& [site, by] : result.hidden) {
            if (is_visible[static_cast<std::size_t>(site)])
                throw BrokenStructure("a hidden site is a vertex of a cell");
            if (!is_visible[static_cast<std::size_t>(by)])
                throw BrokenStructure("no site is near to a hidden one");
            is_told[static_cast<std::size_t>(site)] = true;
        }
        if (!std::ranges::all_of(is_told, std::identity{}))
            throw BrokenStructure("a site is neither visible nor hidden");
    }
    /// A cell and its name as a number, by which cells of one bucket are sorted.
    struct Member {
        std::uint64_t high, low;
        friend bool operator<(const Member& m, const Member& n) noexcept {
            return m.high != n.high ? m.high < n.high : m.low < n.low;
        }
    };
    static_assert(sizeof(Member) == sizeof(SpaceCell) && max_sites_in_space <= 1 << 28);
    /// Cells by their first vertex, or by the second where the first is at infinity: there may be
    /// as many of these as of all others. So many vertices make a bucket.
    static constexpr std::uint32_t bucket_bits = 10;
    [[nodiscard]] static std::uint32_t above_all(Index v) noexcept {
        return static_cast<std::uint32_t>(v - no_vertex);
    }
    [[nodiscard]] static std::uint32_t leading(const SpaceCell& cell) noexcept {
        return above_all(cell[0] == infinite ? cell[1] : cell[0]);
    }
    /// From high bits to low: 10 of the leading vertex, 29 of each of the last three, 31 of the
    /// name.
    [[nodiscard]] static Member pack(const SpaceCell& cell, Index name) noexcept {
        const std::uint64_t first = leading(cell) & ((1U << bucket_bits) - 1);
        const std::uint64_t second = above_all(cell[1]);
        const std::uint64_t third = above_all(cell[2]);
        const std::uint64_t fourth = above_all(cell[3]);
        return {first << 54 | second << 25 | third >> 4,
                third << 60 | fourth << 31 | static_cast<std::uint64_t>(name)};
    }
    [[nodiscard]] static Index name_of(const Member& member) noexcept {
        return static_cast<Index>(member.low & 0x7FFF'FFFF);
    }
    [[nodiscard]] static SpaceCell unpack(const Member& member, Index first) noexcept {
        const auto vertex = [](std::uint64_t bits) {
            return static_cast<Index>(bits & 0x1FFF'FFFF) + no_vertex;
        };
        return {first, vertex(member.high >> 25), vertex(member.high << 4 | member.low >> 60),
                vertex(member.low >> 31)};
    }

    /// The cells that are not free, sorted. Members of a bucket stand where its cells are to be,
    /// and are then sorted in the processor's own memory.
    [[nodiscard]] Places sort_cells(std::vector<SpaceCell>& cells) const {
        const std::uint32_t half =
            (above_all(static_cast<Index>(sites_.size())) >> bucket_bits) + 1;
        const std::size_t buckets = 2 * static_cast<std::size_t>(half);
        const auto bucket = [&](const SpaceCell& cell) {
            return (leading(cell) >> bucket_bits) + (cell[0] == infinite ? 0 : half);
        };
        const std::vector<Range> ranges = ranges_of_cells();
        // How many cells of each range are in each bucket; then where the next of them goes.
        std::vector<std::size_t> next(ranges.size() * buckets, 0);
        workers_.each(ranges.size(), [&](std::size_t i) {
            const Cells& structure = leaves_.cells[ranges[i].leaf];
            std::size_t* const own = &next[i * buckets];
            for (Index c = ranges[i].begin; c < ranges[i].end; ++c)
                if (!structure.is_free(c)) ++own[bucket(structure.vertex(c))];
        });
        std::vector<std::size_t> begins(buckets + 1, 0);
        std::size_t size = 0;
        for (std::size_t b = 0; b < buckets; ++b) {
            begins[b] = size;
            for (std::size_t i = 0; i < ranges.size(); ++i)
                size += std::exchange(next[i * buckets + b], size);
        }
        begins[buckets] = size;
        if (size > std::numeric_limits<Index>::max() - 1)
            throw std::length_error("more than 2^31 - 1 cells");
        if (cells.capacity() < size)
            make_room(workers_, size, cells);
        else
            cells.resize(size);
        const auto put = [&](std::size_t to, const Member& member) {
            std::memcpy(&cells[to], &member, sizeof member);
        };
        Places places;
        std::size_t all = 0;
        for (const Cells& leaf : leaves_.cells) {
            places.begins.push_back(static_cast<Index>(all));
            all += leaf.size();
        }
        places.all = LargeArray<Index>(all);
        workers_.each(ranges.size(), [&](std::size_t i) {
            const auto& [leaf, begin, end] = ranges[i];
            const Cells& structure = leaves_.cells[leaf];
            std::size_t* const own = &next[i * buckets];
            Index* const place = &places.all[static_cast<std::size_t>(places.begins[leaf])];
            expect_writes(place + begin, static_cast<std::size_t>(end - begin) * sizeof(Index));
            for (Index c = begin; c < end; ++c) {
                if (structure.is_free(c)) {
                    place[c] = no_vertex;
                    continue;
                }
                const SpaceCell& cell = structure.vertex(c);
                put(own[bucket(cell)]++, pack(cell, leaves_.name(leaf, c)));
            }
        });
        const std::size_t groups = std::min(buckets, 8 * workers_.range_count(size));
        workers_.each(groups, [&](std::size_t group) {
            LargeArray<Member> room;
            for (std::size_t b = buckets * group / groups; b < buckets * (group + 1) / groups; ++b)
                sort_bucket(b, half, std::span(cells).subspan(begins[b], begins[b + 1] - begins[b]),
                            begins[b], places, room);
        });
        return places;
    }
    void sort_bucket(std::size_t b, std::size_t half, std::span<SpaceCell> cells, std::size_t first,
                     Places& places, LargeArray<Member>& room) const {
        // By the leading vertex, then within what is one vertex's.
        std::array<std::uint32_t, (1U << bucket_bits) + 1> ends{};
        const auto leading_of = [](const Member& member) { return member.high >> 54; };
        if (room.size() < cells.size()) room.resize(2 * cells.size());
        const std::span<Member> sorted = std::span(room).first(cells.size());
        const auto member_at = [&](std::size_t i) {
            Member member;
            std::memcpy(&member, &cells[i], sizeof member);
            return member;
        };
        for (std::size_t i = 0; i < cells.size(); ++i) ++ends[leading_of(member_at(i)) + 1];
        for (std::size_t v = 1; v < ends.size(); ++v) ends[v] += ends[v - 1];
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const Member member = member_at(i);
            sorted[ends[leading_of(member)]++] = member;
        }
        const Leaves::Names names = leaves_.names();
        const Index* const begin_of = places.begins.data();
        Index* const place = places.all.data();
        std::uint32_t next = 0;
        for (std::size_t v = 0; v + 1 < ends.size(); ++v) {
            std::sort(sorted.begin() + next, sorted.begin() + ends[v]);
            const Index vertex =
                b < half ? infinite : static_cast<Index>((b - half) << bucket_bits | v) + no_vertex;
            for (; next < ends[v]; ++next) {
                const Index name = name_of(sorted[next]);
                cells[next] = unpack(sorted[next], vertex);
                place[begin_of[names.leaf(name)] + names.local(name)] =
                    static_cast<Index>(first + next);
            }
        }
    }

    std::span<const S> sites_;
    const Options& options_;
    Workers workers_;
    int levels_;
    bool is_forced_;
    triangulation::Watch watch_;
    Leaves leaves_;
    std::vector<SpaceCell> room_;
    // The sites in an order of insertion, and the hidden ones, by their places there; and by their
    // numbers those that were known before one thread began anew.
    spatial::Numbered<S> all_;
    std::vector<HiddenNear> hidden_;
    std::vector<HiddenNear> hidden_before_;
};

template <class S>
SpaceTessellation construct(std::span<const S> sites, const Options& options,
                            int levels = spatial::any_levels) {
    if (std::ssize(sites) > max_sites_in_space)
        throw std::invalid_argument("too many sites: " + std::to_string(sites.size()) +
                                    "; at most " + std::to_string(max_sites_in_space));
    for (std::size_t i = 0; i < sites.size(); ++i)
        if (!are_finite(sites[i]))
            throw std::invalid_argument("site " + std::to_string(i) + " is not finite");
    // Apexes, and who is nearest, want denormals kept; the predicates would be right without.
    const exact::IeeeEnvironment environment;
    switch (options.arithmetic) {
        case Arithmetic::exact:
            return Construction<S, spatial::ExactKernel<S>>(sites, options, levels).run();
        case Arithmetic::naive:
            return Construction<S, spatial::NaiveKernel<S>>(sites, options, levels).run();
        default:
            throw std::invalid_argument("tessellations of space know exact and naive arithmetic");
    }
}

}  // namespace

namespace spatial {
template <power::PowerSite3 S>
SpaceTessellation construct_in_parts(std::span<const S> sites, const Options& options, int levels) {
    return construct(sites, options, levels);
}
template SpaceTessellation construct_in_parts(std::span<const Point3>, const Options&, int);
template SpaceTessellation construct_in_parts(std::span<const Site3>, const Options&, int);
template SpaceTessellation construct_in_parts(std::span<const power::Site3>, const Options&, int);
}  // namespace spatial

SpaceTessellation triangulate(std::span<const Point3> sites, Power /*metric*/,
                              const Options& options) {
    return construct(sites, options);
}
SpaceTessellation triangulate(std::span<const Site3> sites, Power /*metric*/,
                              const Options& options) {
    return construct(sites, options);
}
SpaceTessellation triangulate(std::span<const power::Site3> sites, Power /*metric*/,
                              const Options& options) {
    return construct(sites, options);
}

}  // namespace signum
