#pragma once
/// The supremum and the Manhattan metric of space: cubes and octahedra, by trying all spheres that
/// four of their facets make, and by distances from their definition.
///
/// A sphere (X, rho) touches a site (c, r) from outside where the greatest of n·(c - X) is rho + r,
/// for the normals n of the facets. In a facet with which it touches any site, n·X + rho is the
/// greatest n·c - r of all sites. What touches all sites is a part of the boundary of a polyhedron
/// in the space of (X, rho), with corners and without lines: its spheres are among the corners,
/// four independent facets each, or there are infinitely many, along an edge from some corner.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rectangular_oracle.hpp"

namespace signum::fuzz::rectangular_oracle {

using Normal = std::array<int, 4>;  // (n, 1)

/// In the library's order of facets: the first one is +x, or +++.
[[nodiscard]] inline std::vector<Normal> normals_of(bool octahedron) {
    if (!octahedron)
        return {{1, 0, 0, 1},  {-1, 0, 0, 1}, {0, 1, 0, 1},
                {0, -1, 0, 1}, {0, 0, 1, 1},  {0, 0, -1, 1}};
    std::vector<Normal> normals;
    for (const int x : {1, -1})
        for (const int y : {1, -1})
            for (const int z : {1, -1}) normals.push_back({x, y, z, 1});
    return normals;
}

/// The vector across three.
[[nodiscard]] inline Normal across(const Normal& a, const Normal& b, const Normal& c) {
    Normal result;
    for (std::size_t k = 0; k < 4; ++k) {
        std::array<std::size_t, 3> at{};
        for (std::size_t l = 0, n = 0; l < 4; ++l)
            if (l != k) at[n++] = l;
        const int minor = a[at[0]] * (b[at[1]] * c[at[2]] - b[at[2]] * c[at[1]]) -
                          a[at[1]] * (b[at[0]] * c[at[2]] - b[at[2]] * c[at[0]]) +
                          a[at[2]] * (b[at[0]] * c[at[1]] - b[at[1]] * c[at[0]]);
        result[k] = k % 2 == 0 ? minor : -minor;
    }
    return result;
}
[[nodiscard]] inline int inner(const Normal& a, const Normal& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

/// Four independent facets, and 16 times the sphere in which they lie at 1 each: columns.
struct Corner {
    std::array<std::size_t, 4> facets;
    std::array<Normal, 4> solution;
};
[[nodiscard]] inline std::vector<Corner> corners_of(std::span<const Normal> normals) {
    std::vector<Corner> corners;
    const std::size_t n = normals.size();
    for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = a + 1; b < n; ++b)
            for (std::size_t c = b + 1; c < n; ++c)
                for (std::size_t e = c + 1; e < n; ++e) {
                    Corner corner{{a, b, c, e}, {}};
                    bool independent = true;
                    for (std::size_t t = 0; t < 4; ++t) {
                        const auto other = [&](std::size_t k) -> const Normal& {
                            return normals[corner.facets[(t + k) % 4]];
                        };
                        Normal v = across(other(1), other(2), other(3));
                        const int by = inner(v, other(0));
                        independent &= by != 0;
                        for (int& x : v) x = independent ? 16 * x / by : 0;
                        corner.solution[t] = v;
                    }
                    if (independent) corners.push_back(corner);
                }
    return corners;
}

template <class Number>
struct Ball3 {
    std::array<Number, 3> c;
    Number r;
};

/// The spheres that touch four sites.
template <class Number, bool octahedron>
class SpaceSpheres {
 public:
    /// 16 times its centre and size, and the facets in which it touches, the first the highest bit.
    struct Sphere {
        std::array<Number, 4> at;
        unsigned facets = 0;
        friend bool operator==(const Sphere& a, const Sphere& b) { return a.at == b.at; }
    };

    explicit SpaceSpheres(const std::array<Ball3<Number>, 4>& sites) {
        std::array<Number, facets> most;
        std::array<unsigned, facets> pinned{};
        for (std::size_t f = 0; f < facets; ++f)
            for (std::size_t m = 0; m < 4; ++m) {
                const Number form = along(normals()[f], sites[m].c) - sites[m].r;
                const int sign = m == 0 ? 1 : sign_of<Number>(form - most[f]);
                if (sign > 0) most[f] = form;
                if (sign >= 0) pinned[f] = (sign > 0 ? 0U : pinned[f]) | 1U << m;
            }
        for (const Corner& corner : corners()) {
            Sphere sphere;
            for (std::size_t k = 0; k < 4; ++k) {
                Number sum = Number(0);
                for (std::size_t t = 0; t < 4; ++t)
                    sum = sum + times(corner.solution[t][k], most[corner.facets[t]]);
                sphere.at[k] = sum;
            }
            bool touches = true;
            for (std::size_t m = 0; m < 4 && touches; ++m)
                touches = sign_of<Number>(gap(sphere, sites[m])) == 0;
            if (!touches) continue;
            bool known = false;
            for (const Sphere& other : spheres_) known |= other == sphere;
            if (known) continue;
            for (std::size_t f = 0; f < facets; ++f) {
                const Number place = along(normals()[f], sphere.at) + sphere.at[3];
                if (sign_of<Number>(place - times(16, most[f])) == 0) sphere.facets |= 0x80U >> f;
            }
            infinitely_many_ |= begins_an_edge(sphere.facets, pinned);
            spheres_.push_back(sphere);
        }
        std::sort(spheres_.begin(), spheres_.end(),
                  [](const Sphere& a, const Sphere& b) { return a.facets > b.facets; });
    }

    [[nodiscard]] bool infinitely_many() const { return infinitely_many_; }
    [[nodiscard]] const std::vector<Sphere>& spheres() const { return spheres_; }
    /// 16 times the distance of q from the sphere, negative where it conflicts.
    [[nodiscard]] static Number gap(const Sphere& sphere, const Ball3<Number>& q) {
        std::array<Number, 3> to;
        for (std::size_t k = 0; k < 3; ++k) to[k] = times(16, q.c[k]) - sphere.at[k];
        return norm(to) - times(16, q.r) - sphere.at[3];
    }
    /// Whether i covers q, with its boundary.
    [[nodiscard]] static bool covers(const Ball3<Number>& i, const Ball3<Number>& q) {
        std::array<Number, 3> to;
        for (std::size_t k = 0; k < 3; ++k) to[k] = q.c[k] - i.c[k];
        return !(i.r - q.r < norm(to));
    }

 private:
    static constexpr std::size_t facets = octahedron ? 8 : 6;
    [[nodiscard]] static const std::vector<Normal>& normals() {
        static const std::vector<Normal> all = normals_of(octahedron);
        return all;
    }
    [[nodiscard]] static const std::vector<Corner>& corners() {
        static const std::vector<Corner> all = corners_of(normals());
        return all;
    }
    [[nodiscard]] static Number times(int factor, const Number& number) {
        return Number(factor) * number;
    }
    template <class Vector>
    [[nodiscard]] static Number along(const Normal& normal, const Vector& v) {
        Number sum = Number(0);
        for (std::size_t k = 0; k < 3; ++k) {
            if (normal[k] > 0) sum = sum + v[k];
            if (normal[k] < 0) sum = sum - v[k];
        }
        return sum;
    }
    [[nodiscard]] static Number norm(const std::array<Number, 3>& v) {
        const Number x = positive(v[0]), y = positive(v[1]), z = positive(v[2]);
        if constexpr (octahedron) return x + y + z;
        return greater(greater(x, y), z);
    }
    /// Whether spheres go on touching all sites in some direction: out along an edge of the
    /// polyhedron, where three of the facets stay and no other sinks in.
    [[nodiscard]] static bool begins_an_edge(unsigned touched,
                                             const std::array<unsigned, facets>& pinned) {
        std::vector<std::size_t> at;
        for (std::size_t f = 0; f < facets; ++f)
            if ((touched & 0x80U >> f) != 0) at.push_back(f);
        for (std::size_t a = 0; a < at.size(); ++a)
            for (std::size_t b = a + 1; b < at.size(); ++b)
                for (std::size_t c = b + 1; c < at.size(); ++c) {
                    const Normal way = across(normals()[at[a]], normals()[at[b]], normals()[at[c]]);
                    bool out = false, in = false;
                    unsigned stays = 0;
                    for (const std::size_t f : at) {
                        const int sign = inner(way, normals()[f]);
                        out |= sign > 0;
                        in |= sign < 0;
                        if (sign == 0) stays |= pinned[f];
                    }
                    // Of the four or more facets three stay at most in a plane: some move.
                    if (out != in && stays == 0b1111U) return true;
                }
        return false;
    }

    std::vector<Sphere> spheres_;
    bool infinitely_many_ = false;
};

}  // namespace signum::fuzz::rectangular_oracle
