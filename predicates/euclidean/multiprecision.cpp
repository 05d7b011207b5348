#include <signum/predicates/euclidean/multiprecision.hpp>

#include <signum/predicates/euclidean/cold_discs.hpp>
#include <signum/predicates/euclidean/polynomials.hpp>

namespace signum::euclidean::multiprecision {
namespace {

template <class... Sites>
[[nodiscard]] auto discs(const Sites&... sites) {
    return rational_discs(std::array{sites...});
}

}  // namespace

bool hides(const Site& i, const Site& q) noexcept {
    return hides_perturbed(i, q, true);
}

bool hides_perturbed(const Site& i, const Site& q, bool i_precedes_q) noexcept {
    const auto d = discs(i, q);
    return euclidean::hides(d[0], d[1], i_precedes_q);
}

Sign nearer(Point p, const Site& a, const Site& b) noexcept {
    return euclidean::nearer(discs(Site{p.x, p.y, 0.0}, a, b));
}

Sign edge_bounded(const Site& i, const Site& j, const Site& k) noexcept {
    return euclidean::edge_bounded(discs(i, j, k));
}

Sign exists(const Site& i, const Site& j, const Site& k) noexcept {
    return euclidean::exists(discs(i, j, k));
}

Sign exists_perturbed(const Site& i, const Site& j, const Site& k,
                      const std::array<Index, 3>& ranks) noexcept {
    return euclidean::exists_perturbed(discs(i, j, k), ranks);
}

Sign in_circle(const Site& i, const Site& j, const Site& k, const Site& q) noexcept {
    return euclidean::in_circle(discs(i, j, k, q));
}

Sign in_circle_perturbed(const Site& i, const Site& j, const Site& k, const Site& q,
                         const std::array<Index, 4>& ranks) noexcept {
    return euclidean::in_circle_perturbed(discs(i, j, k, q), ranks);
}

Sign in_circle_infinite(const Site& a, const Site& b, const Site& q) noexcept {
    const auto d = discs(a, b, q);
    return euclidean::in_circle_infinite(d[0], d[1], d[2]);
}

Sign in_circle_infinite_perturbed(const Site& a, const Site& b, const Site& q,
                                  const std::array<Index, 3>& ranks) noexcept {
    return euclidean::in_circle_infinite_perturbed(discs(a, b, q), ranks);
}

}  // namespace signum::euclidean::multiprecision
