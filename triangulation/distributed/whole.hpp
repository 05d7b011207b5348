#pragma once
/// The whole from what parts tell: which faces meet in an edge, which cells in a facet. In an
/// array, or in stretches of it that ranks hold.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "part.hpp"

namespace signum::distributed {

/// Stretches of site numbers: what begins with a site goes to who has it.
class Stretches {
 public:
    /// As even as can be.
    Stretches(std::int64_t sites, std::size_t count) {
        for (std::size_t k = 0; k <= count; ++k)
            begins_.push_back(
                static_cast<std::int64_t>(static_cast<unsigned __int128>(sites) * k / count));
    }
    /// Each with about as many of a sample: one of what will be dealt to them.
    Stretches(std::int64_t sites, std::vector<std::int64_t> sample, std::size_t count)
        : begins_(1, 0) {
        std::ranges::sort(sample);
        for (std::size_t k = 1; k < count; ++k)
            begins_.push_back(
                sample.empty() ? 0 : std::max(sample[sample.size() * k / count], std::int64_t{0}));
        begins_.push_back(sites);
    }
    /// That of a site; of infinity the first.
    [[nodiscard]] std::size_t of(std::int64_t site) const noexcept {
        if (site < 0) return 0;
        const auto after = std::ranges::upper_bound(begins_, site);
        return static_cast<std::size_t>(after - begins_.begin()) - 1;
    }
    /// Where one begins, and the one before it ends.
    [[nodiscard]] std::int64_t begin(std::size_t stretch) const noexcept {
        return begins_[stretch];
    }
    /// The same of faces, of which those at infinity come before all.
    [[nodiscard]] std::int64_t begin_of_faces(std::size_t stretch) const noexcept {
        return stretch == 0 ? -1 : begin(stretch);
    }

 private:
    std::vector<std::int64_t> begins_;
};

/// An edge as one of its faces has it, or a facet as one of its cells has.
template <std::size_t corners>
struct Half {
    std::int64_t lesser;                           ///< the least of its sites
    std::array<std::int64_t, corners - 2> others;  ///< by their numbers; infinity, -1, is the last
    std::int64_t place;                            ///< as Across has it
};

/// Ranges of site numbers, in order, about as many as there are items, or one for each number.
class Buckets {
 public:
    /// Of numbers from `first` to before `last`.
    Buckets(std::int64_t first, std::int64_t last, std::size_t items) noexcept
        : first_(first),
          range_(static_cast<std::uint64_t>(last - first)),
          count_(std::min(static_cast<std::uint64_t>(items) + 1, range_)) {}
    [[nodiscard]] std::size_t count() const noexcept { return count_; }
    [[nodiscard]] std::size_t of(std::int64_t site) const noexcept {
        const auto place = static_cast<std::uint64_t>(site - first_);
        if (count_ == range_) return place;
        return static_cast<std::size_t>(static_cast<unsigned __int128>(place) * count_ / range_);
    }

 private:
    std::int64_t first_;
    std::uint64_t range_;
    std::uint64_t count_;
};

/// The half of a face or cell across from a corner.
template <std::size_t corners>
[[nodiscard]] Half<corners> half_of(const WholeCell<corners>& cell, std::int64_t number,
                                    std::size_t corner) noexcept {
    // Infinity, as a number without a sign, after all others.
    std::array<std::uint64_t, corners - 1> sites;
    for (std::size_t k = 0; k + 1 < corners; ++k)
        sites[k] = static_cast<std::uint64_t>(cell[k < corner ? k : k + 1]);
    const auto put_in_order = [&](std::size_t k) {
        if (sites[k + 1] < sites[k]) std::swap(sites[k], sites[k + 1]);
    };
    put_in_order(0);
    if constexpr (corners == 4) {
        put_in_order(1);
        put_in_order(0);
    }
    Half<corners> half;
    half.lesser = static_cast<std::int64_t>(sites[0]);
    for (std::size_t k = 0; k + 2 < corners; ++k)
        half.others[k] = static_cast<std::int64_t>(sites[k + 1]);
    half.place = 4 * number + static_cast<std::int64_t>(corner);
    return half;
}

/// The face or cell across from a corner.
struct Across {
    std::int64_t place;  ///< 4 times the number of the face or cell, and the corner
    std::int64_t neighbour;
};

/// Joins the halves of which there are two between their sites; these are to be all halves with a
/// lesser site from `first` to before `last`. O(n), unless a site has neighbours without bound.
template <std::size_t corners>
[[nodiscard]] std::vector<Across> joined(std::span<const Half<corners>> halves, std::int64_t first,
                                         std::int64_t last) {
    const Buckets buckets(first, last, halves.size());
    std::vector<std::size_t> begins(buckets.count() + 2);
    const auto bucket = [&](const Half<corners>& half) { return buckets.of(half.lesser); };
    for (const Half<corners>& each : halves) ++begins[bucket(each) + 2];
    for (std::size_t b = 2; b < begins.size(); ++b) begins[b] += begins[b - 1];
    struct Dealt {
        std::array<std::int64_t, corners - 1> sites;
        std::int64_t place;
    };
    std::vector<Dealt> dealt(halves.size());
    // The begin of each bucket moves to its end.
    for (const Half<corners>& each : halves) {
        Dealt& to = dealt[begins[bucket(each) + 1]++];
        to.sites[0] = each.lesser;
        std::ranges::copy(each.others, to.sites.begin() + 1);
        to.place = each.place;
    }
    std::vector<Across> result;
    result.reserve(halves.size());
    for (std::size_t b = 0; b + 1 < begins.size(); ++b) {
        const std::span<Dealt> in_bucket =
            std::span(dealt).subspan(begins[b], begins[b + 1] - begins[b]);
        std::ranges::sort(in_bucket, {}, &Dealt::sites);
        for (std::size_t k = 0, end; k < in_bucket.size(); k = end) {
            end = k + 1;
            while (end < in_bucket.size() && in_bucket[end].sites == in_bucket[k].sites) ++end;
            if (end - k != 2) continue;
            for (const auto& [one, two] : {std::pair(in_bucket[k].place, in_bucket[k + 1].place),
                                           std::pair(in_bucket[k + 1].place, in_bucket[k].place)})
                result.push_back({one, two / 4});
        }
    }
    return result;
}

/// Faces or cells, sorted, some of the whole's.
template <std::size_t corners>
class SortedCells {
    using Cell = WholeCell<corners>;

 public:
    /// Those of which the first site, or infinity, is `first` or a later one, but before `last`.
    SortedCells(std::vector<Cell> cells, std::int64_t first, std::int64_t last)
        : buckets_(first, last, cells.size()), begins_(buckets_.count() + 2) {
        for (const Cell& cell : cells) ++begins_[bucket(cell) + 2];
        for (std::size_t b = 2; b < begins_.size(); ++b) begins_[b] += begins_[b - 1];
        cells_.resize(cells.size());
        for (const Cell& cell : cells) cells_[begins_[bucket(cell) + 1]++] = cell;
        for (std::size_t b = 0; b + 1 < begins_.size(); ++b) std::ranges::sort(of(b));
    }
    [[nodiscard]] const std::vector<Cell>& cells() const noexcept { return cells_; }
    /// Where one stands among them. Throws std::logic_error where it does not.
    [[nodiscard]] std::size_t place_of(const Cell& cell) {
        const std::span<Cell> some = of(bucket(cell));
        const auto found = std::ranges::lower_bound(some, cell);
        if (found == some.end() || *found != cell)
            throw std::logic_error("the parts of a tessellation do not fit together");
        return begins_[bucket(cell)] + static_cast<std::size_t>(found - some.begin());
    }

 private:
    [[nodiscard]] std::size_t bucket(const Cell& cell) const noexcept {
        return buckets_.of(cell[0]);
    }
    [[nodiscard]] std::span<Cell> of(std::size_t b) noexcept {
        return std::span(cells_).subspan(begins_[b], begins_[b + 1] - begins_[b]);
    }
    Buckets buckets_;
    std::vector<std::size_t> begins_;
    std::vector<Cell> cells_;
};

/// The arrays of space but for hidden sites, of which the numbers fit.
[[nodiscard]] inline SpaceTessellation space_of(const SortedCells<4>& sorted, std::int64_t sites) {
    std::vector<Half<4>> halves;
    std::int64_t number = 0;
    for (const WholeCell<4>& cell : sorted.cells()) {
        for (std::size_t corner = 0; corner < 4; ++corner)
            halves.push_back(half_of(cell, number, corner));
        ++number;
    }
    SpaceTessellation space;
    space.dimension = 3;
    space.sites = sites;
    for (const auto& [a, b, c, d] : sorted.cells())
        space.cells.push_back({static_cast<Index>(a), static_cast<Index>(b), static_cast<Index>(c),
                               static_cast<Index>(d)});
    space.neighbours.resize(space.cells.size());
    for (const auto& [place, neighbour] : joined<4>(halves, 0, sites))
        space.neighbours[static_cast<std::size_t>(place / 4)][static_cast<std::size_t>(place % 4)] =
            static_cast<Index>(neighbour);
    return space;
}

}  // namespace signum::distributed
