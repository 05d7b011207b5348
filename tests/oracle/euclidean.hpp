#pragma once
/// Brute force for the additively weighted Euclidean metric, |x-c| - r: the Apollonius graph of
/// discs that may intersect, touch, nest and coincide. It knows no predicate of the library and no
/// rule for ties: it really makes the radii smaller and looks at the discs that result.

#include "../../core/site.hpp"

#include "enclosure.hpp"
#include "oracle.hpp"

#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

namespace signum::oracle {

/// How much smaller the radii are made, in units of the sites' common grid. Sites are ordered by
/// falling radius, then rising x, y, index; a later site loses infinitely more.
enum class Spacing {
    /// Of the sites that one question names, the last loses e = 2^-scale, the one before it e^8,
    /// then e^64, then e^512: an infinitesimal of its own for each, as the polynomials that decide
    /// have at most degree 4 in one radius.
    powers,
    /// The last of all sites loses e, the one before it e², then e³, and so on. All questions are
    /// then about one and the same set of discs, so the answers belong to a real tessellation.
    steps
};

/// Questions about the shrunken discs. Nothing is ever 0; all answers are certain. A configuration
/// that is still degenerate after shrinking throws std::logic_error.
class ShrunkenDiscs {
 public:
    /// Throws std::invalid_argument for a NaN or an infinity. The scale is `fineness` times what is
    /// ample for numbers of the sites' length.
    ShrunkenDiscs(std::span<const Site> sites, Spacing spacing, int fineness = 1);
    /// Site m loses e^powers[m], whatever the order; powers are positive and all different.
    ShrunkenDiscs(std::span<const Site> sites, std::vector<std::int64_t> powers);

    std::int32_t size() const { return static_cast<std::int32_t>(discs_.size()); }
    /// Disc q lies inside disc i.
    bool hides(std::int32_t i, std::int32_t q) const;
    /// a is nearer to the centre of q than b.
    bool nearer(std::int32_t a, std::int32_t b, std::int32_t q) const;
    /// A circle touches i, j, k counterclockwise. None of them hides another.
    bool exists(std::int32_t i, std::int32_t j, std::int32_t k) const;
    /// q is nearer to that circle's centre than i, j, k.
    bool conflicts(std::int32_t i, std::int32_t j, std::int32_t k, std::int32_t q) const;
    /// q reaches across the line that has a and then b on its left. Neither hides the other.
    bool crosses(std::int32_t a, std::int32_t b, std::int32_t q) const;

 private:
    struct Grid {
        Integer x, y, r;
        std::int32_t rank;
    };
    std::vector<Grid> discs_;
    std::vector<std::int64_t> powers_;  // empty: those of the spacing
    Spacing spacing_;
    std::int64_t scale_ = 0;
    std::int64_t start_ = 0;

    template <class Question>
    auto ask(std::initializer_list<std::int32_t> names, Question question) const;
};

/// The tessellation of the shrunken discs. It is made twice, with differently spaced and much finer
/// infinitesimals, and checked: 2n-2 faces, every edge with a face on each side. Throws
/// std::logic_error where a check fails.
Tessellation euclidean(std::span<const Site> sites);

/// The tessellation of discs shrunk otherwise: one of those that the sites' ties allow.
Tessellation euclidean(std::span<const Site> sites, const std::vector<std::int64_t>& powers);

}  // namespace signum::oracle
