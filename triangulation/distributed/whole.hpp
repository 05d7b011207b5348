#pragma once
/// The whole from what parts tell: which faces meet in an edge. In an array, or in stretches of it
/// that ranks hold.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "part.hpp"

namespace signum::distributed {

/// Stretches of site numbers, as even as can be: what begins with a site goes to who has it.
class Stretches {
 public:
    Stretches(std::int64_t sites, std::size_t count) noexcept : sites_(sites), count_(count) {}
    /// That of a site; of infinity the first.
    [[nodiscard]] std::size_t of(std::int64_t site) const noexcept {
        if (site < 0) return 0;
        return static_cast<std::size_t>(static_cast<unsigned __int128>(site) * count_ /
                                        static_cast<unsigned __int128>(sites_));
    }
    /// Where one begins, and the one before it ends.
    [[nodiscard]] std::int64_t begin(std::size_t stretch) const noexcept {
        return static_cast<std::int64_t>(
            (static_cast<unsigned __int128>(sites_) * stretch + count_ - 1) / count_);
    }
    /// The same of faces, of which those at infinity come before all.
    [[nodiscard]] std::int64_t begin_of_faces(std::size_t stretch) const noexcept {
        return stretch == 0 ? -1 : begin(stretch);
    }

 private:
    std::int64_t sites_;
    std::size_t count_;
};

/// An edge as one of its faces has it.
struct HalfOfEdge {
    std::int64_t lesser;  ///< its sites; infinity, -1, is the other one
    std::int64_t other;
    std::int64_t place;  ///< 8 times the number of the face, and side()
};

/// Three halves of a face.
template <class Put>
void each_half(const WholeFace& face, std::int64_t number, const Put& put) {
    for (std::int64_t corner = 0; corner < 3; ++corner) {
        const std::int64_t from = face[static_cast<std::size_t>((corner + 1) % 3)];
        const std::int64_t to = face[static_cast<std::size_t>((corner + 2) % 3)];
        const bool is_forward = to < 0 || (from >= 0 && from < to);
        put(is_forward ? HalfOfEdge{from, to, 8 * number + 2 * corner}
                       : HalfOfEdge{to, from, 8 * number + 2 * corner + 1});
    }
}

/// The face across from a corner.
struct Across {
    std::int64_t place;  ///< 4 times the number of the face, and the corner
    std::int64_t neighbour;
};

/// Joins the halves of edges of which there is one between their sites; these are to be all halves
/// with a lesser site from `first` to before `last`. O(n), unless a site has neighbours without
/// bound.
[[nodiscard]] inline std::vector<Across> joined(std::span<const HalfOfEdge> halves,
                                                std::int64_t first, std::int64_t last) {
    std::vector<std::size_t> begins(static_cast<std::size_t>(last - first) + 2);
    const auto bucket = [&](const HalfOfEdge& half) {
        return static_cast<std::size_t>(half.lesser - first);
    };
    for (const HalfOfEdge& each : halves) ++begins[bucket(each) + 2];
    for (std::size_t b = 2; b < begins.size(); ++b) begins[b] += begins[b - 1];
    struct Dealt {
        std::int64_t other;
        std::int64_t place;
    };
    std::vector<Dealt> dealt(halves.size());
    // The begin of each bucket moves to its end.
    for (const HalfOfEdge& each : halves)
        dealt[begins[bucket(each) + 1]++] = {each.other, each.place};
    std::vector<Across> result;
    result.reserve(halves.size());
    for (std::size_t b = 0; b + 1 < begins.size(); ++b) {
        const std::span<Dealt> of_site =
            std::span(dealt).subspan(begins[b], begins[b + 1] - begins[b]);
        std::ranges::sort(of_site, {}, &Dealt::other);
        for (std::size_t k = 0, end; k < of_site.size(); k = end) {
            end = k + 1;
            while (end < of_site.size() && of_site[end].other == of_site[k].other) ++end;
            if (end - k != 2) continue;
            for (const auto& [one, two] : {std::pair(of_site[k].place, of_site[k + 1].place),
                                           std::pair(of_site[k + 1].place, of_site[k].place)})
                result.push_back({one / 2, two / 8});
        }
    }
    return result;
}

/// Faces, sorted, some of the whole's.
class SortedFaces {
 public:
    /// Those of which the first site, or infinity, is `first` or a later one, but before `last`.
    SortedFaces(std::vector<WholeFace> faces, std::int64_t first, std::int64_t last)
        : first_(first), begins_(static_cast<std::size_t>(last - first) + 2) {
        for (const WholeFace& face : faces) ++begins_[bucket(face) + 2];
        for (std::size_t b = 2; b < begins_.size(); ++b) begins_[b] += begins_[b - 1];
        faces_.resize(faces.size());
        for (const WholeFace& face : faces) faces_[begins_[bucket(face) + 1]++] = face;
        for (std::size_t b = 0; b + 1 < begins_.size(); ++b) std::ranges::sort(of(b));
    }
    [[nodiscard]] const std::vector<WholeFace>& faces() const noexcept { return faces_; }
    /// Where a face stands among them. Throws std::logic_error where it does not.
    [[nodiscard]] std::size_t place_of(const WholeFace& face) {
        const std::span<WholeFace> some = of(bucket(face));
        const auto found = std::ranges::lower_bound(some, face);
        if (found == some.end() || *found != face)
            throw std::logic_error("the parts of a tessellation do not fit together");
        return begins_[bucket(face)] + static_cast<std::size_t>(found - some.begin());
    }

 private:
    [[nodiscard]] std::size_t bucket(const WholeFace& face) const noexcept {
        return static_cast<std::size_t>(face[0] - first_);
    }
    [[nodiscard]] std::span<WholeFace> of(std::size_t b) noexcept {
        return std::span(faces_).subspan(begins_[b], begins_[b + 1] - begins_[b]);
    }
    std::int64_t first_;
    std::vector<std::size_t> begins_;
    std::vector<WholeFace> faces_;
};

}  // namespace signum::distributed
