#pragma once
/// What the library says of sites in the plane.

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "../../triangulation/kernels/predicates_of.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../property/environments.hpp"
#include "plane_case.hpp"

namespace signum::hard {

/// How the library is asked.
struct Way {
    Options options;
    int environment = 0;
};

inline double size_of(const Site& site) {
    return site.r;
}
inline double size_of(const power::Site& site) {
    return site.w;
}

template <class Predicates>
class LibraryOfPlane : public PlaneAnswers {
    using S = typename Predicates::SiteType;

 public:
    LibraryOfPlane(Metric metric, std::vector<S> sites, const Way& way)
        : metric_(metric), sites_(std::move(sites)), way_(way) {}

    bool hides(Number i, Number q) const override {
        return ask([&] { return Predicates::hidden(sites_[q], sites_[i]); });
    }
    bool exists(Number i, Number j, Number k) const override {
        return ask([&] { return Predicates::exists(sites_[i], sites_[j], sites_[k]); });
    }
    std::string in_circle(Number i, Number j, Number k, Number q) const override {
        return letter(ask([&]() -> int {
            return Predicates::in_circle(sites_[i], sites_[j], sites_[k], sites_[q]);
        }));
    }
    bool conflicts(Number i, Number j, Number k, Number q) const override {
        const auto ranks = ranks_of<4>({i, j, k, q});
        return ask([&] {
            return Predicates::in_circle_perturbed(sites_[i], sites_[j], sites_[k], sites_[q],
                                                   ranks) > 0;
        });
    }
    bool conflicts_at_infinity(Number a, Number b, Number q) const override {
        const auto ranks = ranks_of<3>({a, b, q});
        return ask([&] {
            return Predicates::in_circle_infinite_perturbed(sites_[a], sites_[b], sites_[q],
                                                            ranks) > 0;
        });
    }
    std::vector<std::array<std::int32_t, 3>> faces() const override {
        return {whole().faces().begin(), whole().faces().end()};
    }
    std::vector<std::array<std::int32_t, 2>> hidden() const override {
        std::vector<std::array<std::int32_t, 2>> result;
        for (const Hidden& h : whole().hidden()) result.push_back({h.site, h.by});
        return result;
    }

 private:
    template <class Question>
    auto ask(const Question& question) const {
        return within(way_.environment, question);
    }
    /// Places in the order of the tie rule: falling weight or radius, rising x, y, index.
    template <std::size_t n>
    std::array<Index, n> ranks_of(const std::array<Number, n>& numbers) const {
        const auto size = [&](const S& site) {
            return std::is_same_v<S, Site> && metric_ == Metric::power ? std::abs(size_of(site))
                                                                       : size_of(site);
        };
        const auto key = [&](std::size_t m) {
            const S& site = sites_[numbers[m]];
            return std::tuple(-size(site), site.x, site.y, m);
        };
        std::array<Index, n> ranks{};
        for (std::size_t a = 0; a < n; ++a)
            for (std::size_t b = 0; b < n; ++b) ranks[a] += static_cast<Index>(key(b) < key(a));
        return ranks;
    }
    const Tessellation& whole() const {
        if (whole_ == nullptr) {
            Options options = way_.options;
            if (!builds(options.method, metric_)) options.method = Method::incremental;
            whole_ = std::make_unique<Tessellation>(
                ask([&] { return triangulate(sites_, metric_, options); }));
        }
        return *whole_;
    }

    Metric metric_;
    std::vector<S> sites_;
    Way way_;
    mutable std::unique_ptr<Tessellation> whole_;
};

inline std::unique_ptr<PlaneAnswers> library_of(const std::string& metric,
                                                const std::vector<Site>& sites, const Way& way) {
    using triangulation::PredicatesOf;
    if (metric == "weights") {
        std::vector<power::Site> weighted;
        for (const Site& site : sites) weighted.push_back({site.x, site.y, site.r});
        return std::make_unique<LibraryOfPlane<PredicatesOf<Power, WeightIs::weight>>>(
            Metric::power, weighted, way);
    }
    return with_metric(
        metric_named(metric).value(), [&]<class M>(M each) -> std::unique_ptr<PlaneAnswers> {
            return std::make_unique<LibraryOfPlane<PredicatesOf<M>>>(each, sites, way);
        });
}

}  // namespace signum::hard
