#pragma once
/// What is checked of a tessellation's arrays without knowing a coordinate: numbers, counts, order.

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "../../core/strided_sites.hpp"
#include "../arrays.hpp"
#include "../structure/topology.hpp"
#include "../validate.hpp"

namespace signum::triangulation {

[[nodiscard]] inline std::size_t at(Index i) noexcept {
    return static_cast<std::size_t>(i);
}

[[nodiscard]] inline std::string name(Index vertex) {
    return vertex == infinite ? "infinity" : "site " + std::to_string(vertex);
}

/// Why the arrays are no valid tessellation.
struct Invalid {
    std::string why;
};

/// The sites as the predicates take them. Throws std::invalid_argument for NaN and infinity.
template <class S>
[[nodiscard]] std::vector<S> load(const StridedSites& input) {
    std::vector<S> result(input.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
        const Site site = input[i];
        if (!std::isfinite(site.x) || !std::isfinite(site.y) || !std::isfinite(site.r))
            throw std::invalid_argument("site " + std::to_string(i) + " is not finite");
        result[i] = {site.x, site.y, site.r};
    }
    return result;
}

/// The part of a check that all metrics share. What is wrong is thrown as Invalid; what is right
/// but not the canonical choice is noted.
class ArraysCheck {
 protected:
    ArraysCheck(const TessellationArrays& arrays, std::size_t sites)
        : arrays_(arrays), sites_(sites) {}

    /// The judgement of the checks that `all` makes.
    template <class Checks>
    [[nodiscard]] Validation judgement(Checks all) {
        try {
            all();
        } catch (const Invalid& invalid) {
            return {false, false, invalid.why};
        }
        return {true, not_canonical_.empty(), not_canonical_};
    }

    [[nodiscard]] static std::string face_name(Index f) { return "face " + std::to_string(f); }
    void note(const std::string& why) {
        if (not_canonical_.empty()) not_canonical_ = why;
    }
    [[nodiscard]] const Face& face(Index f) const { return arrays_.faces[at(f)]; }
    [[nodiscard]] Index faces() const { return static_cast<Index>(arrays_.faces.size()); }
    /// Every number names a site; every site is visible or hidden, once; as many faces as Euler
    /// asks.
    void check_sites() {
        const auto n = static_cast<Index>(sites_);
        if (arrays_.sites != n)
            throw Invalid{"the tessellation speaks of " + std::to_string(arrays_.sites) +
                          " sites, the input has " + std::to_string(n)};
        std::vector<char> seen(sites_, 0);
        for (Index f = 0; f < faces(); ++f) {
            const Face& v = face(f);
            for (const Index i : v) {
                if (i < infinite || i >= n)
                    throw Invalid{face_name(f) + ": there is no site " + std::to_string(i)};
                if (i != infinite) seen[at(i)] = 1;
            }
            if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0])
                throw Invalid{face_name(f) + " has a vertex twice"};
        }
        for (const Hidden& hidden : arrays_.hidden) {
            if (hidden.site < 0 || hidden.site >= n || hidden.by < 0 || hidden.by >= n)
                throw Invalid{
                    "hidden: there is no site " +
                    std::to_string(hidden.site < 0 || hidden.site >= n ? hidden.site : hidden.by)};
            if (seen[at(hidden.site)] != 0)
                throw Invalid{name(hidden.site) + (seen[at(hidden.site)] == 1
                                                       ? " is both visible and hidden"
                                                       : " is hidden twice")};
            seen[at(hidden.site)] = 2;
        }
        if (arrays_.faces.empty()) {
            const auto lone = std::find(seen.begin(), seen.end(), 0);
            if (lone != seen.end()) *lone = 1;
        }
        for (Index i = 0; i < n; ++i) {
            if (seen[at(i)] == 0) throw Invalid{name(i) + " is neither visible nor hidden"};
            visible_ += static_cast<Index>(seen[at(i)] == 1);
        }
        for (const Hidden& hidden : arrays_.hidden)
            if (seen[at(hidden.by)] != 1)
                throw Invalid{name(hidden.site) + " is hidden by " + name(hidden.by) +
                              ", which is hidden itself"};
        if (visible_ == 0 && n > 0) throw Invalid{"every site is hidden"};
        const Index expected = visible_ < 2 ? 0 : 2 * visible_ - 2;
        if (faces() != expected)
            throw Invalid{std::to_string(visible_) + " visible sites have " +
                          std::to_string(expected) + " faces, not " + std::to_string(faces())};
    }

    /// The number of half-edges out of the origin of h.
    [[nodiscard]] Index degree_at(HalfEdge h) const {
        Index count = 0;
        for ([[maybe_unused]] const HalfEdge of : topology_.fan(h)) ++count;
        return count;
    }

    /// The arrays as the library itself would write them.
    void check_canonical_order() {
        for (Index f = 0; f < faces(); ++f) {
            const Face& v = face(f);
            if (v[0] > v[1] || v[0] > v[2])
                note(face_name(f) + " does not begin with its smallest vertex");
            if (f > 0 && v < face(f - 1)) note(face_name(f) + " is not in sorted order");
        }
        for (std::size_t i = 1; i < arrays_.hidden.size(); ++i)
            if (arrays_.hidden[i].site < arrays_.hidden[i - 1].site)
                note("the hidden sites are not in sorted order");
    }

    const TessellationArrays& arrays_;
    std::size_t sites_;
    Topology topology_{0};
    Index visible_ = 0;

 private:
    std::string not_canonical_;
};

}  // namespace signum::triangulation
