#include "dynamic.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include "../exact/floating_environment.hpp"
#include "dynamic/live.hpp"
#include "kernels/additive_kernel.hpp"
#include "kernels/power_kernel.hpp"
#include "kernels/predicates_of.hpp"
#include "triangulate.hpp"

namespace signum {
namespace triangulation {
namespace {

template <class Predicates>
struct KernelOf {
    using Type = PowerKernel<PowerSigns<typename Predicates::SiteType>, filters::NoTally>;
};
template <Additive Predicates>
struct KernelOf<Predicates> {
    using Type = AdditiveKernel<typename Predicates::template Perturbed<>, filters::NoTally>;
};

/// A tessellation, by the predicates of its metric and sites.
template <class Predicates>
using LiveOf = Live<typename KernelOf<Predicates>::Type>;

/// One of them, in any metric.
template <class... M>
std::variant<std::unique_ptr<LiveOf<PredicatesOf<M>>>...,
             std::unique_ptr<LiveOf<PredicatesOf<Power, WeightIs::weight>>>>
    any_live(MetricTypes<M...>);

}  // namespace
}  // namespace triangulation

class DynamicTessellation::State {
 public:
    State(Metric metric, WeightIs weight_is) {
        triangulation::with_predicates(metric, weight_is, [&]<class Predicates>(Predicates) {
            live_ = std::make_unique<triangulation::LiveOf<Predicates>>(metric);
        });
    }

    template <class Visit>
    decltype(auto) visit(const Visit& visit) {
        return std::visit([&](auto& live) -> decltype(auto) { return visit(*live); }, live_);
    }

 private:
    decltype(triangulation::any_live(AllMetrics{})) live_;
};

namespace {

void check(double value) {
    if (!std::isfinite(value)) throw std::invalid_argument("a number of the site is not finite");
}

}  // namespace

DynamicTessellation::DynamicTessellation(Metric metric, WeightIs weight_is)
    : metric_(metric), weight_is_(weight_is) {
    if (weight_is == WeightIs::weight && !traits_of(metric).has_weights)
        throw std::invalid_argument(no_weights(metric));
}
DynamicTessellation::DynamicTessellation(DynamicTessellation&&) noexcept = default;
DynamicTessellation& DynamicTessellation::operator=(DynamicTessellation&&) noexcept = default;
DynamicTessellation::~DynamicTessellation() = default;

void DynamicTessellation::require(Index handle) const {
    if (!contains(handle))
        throw std::out_of_range("there is no site with handle " + std::to_string(handle));
}

Index DynamicTessellation::insert(const Site& site) {
    for (const double value : {site.x, site.y, site.r}) check(value);
    const exact::IeeeEnvironment environment;
    if (state_ == nullptr) state_ = std::make_unique<State>(metric_, weight_is_);
    return state_->visit([&](auto& live) { return live.insert(site); });
}

void DynamicTessellation::erase(Index handle) {
    require(handle);
    const exact::IeeeEnvironment environment;
    state_->visit([&](auto& live) { live.erase(handle); });
}

void DynamicTessellation::change(Index handle, double third) {
    require(handle);
    check(third);
    const exact::IeeeEnvironment environment;
    state_->visit([&](auto& live) { live.change(handle, third); });
}

void DynamicTessellation::move(Index handle, Point centre) {
    require(handle);
    for (const double value : {centre.x, centre.y}) check(value);
    const exact::IeeeEnvironment environment;
    state_->visit([&](auto& live) { live.move(handle, centre); });
}

void DynamicTessellation::move_all(std::span<const Point> centres) {
    if (centres.size() != size())
        throw std::invalid_argument(std::to_string(centres.size()) + " centres for " +
                                    std::to_string(size()) + " sites");
    for (const Point& centre : centres)
        for (const double value : {centre.x, centre.y}) check(value);
    if (centres.empty()) return;
    const exact::IeeeEnvironment environment;
    state_->visit([&](auto& live) { live.move_all(centres); });
}

bool DynamicTessellation::contains(Index handle) const noexcept {
    return state_ != nullptr && state_->visit([&](auto& live) { return live.contains(handle); });
}

std::size_t DynamicTessellation::size() const noexcept {
    return state_ == nullptr ? 0 : state_->visit([](auto& live) { return live.size(); });
}

Site DynamicTessellation::site(Index handle) const {
    require(handle);
    return state_->visit([&](auto& live) { return live.site(handle); });
}

Tessellation DynamicTessellation::tessellation() const {
    if (state_ == nullptr) return triangulate({{}, weight_is_ == WeightIs::weight}, metric_);
    const exact::IeeeEnvironment environment;
    return state_->visit([](auto& live) { return live.tessellation(); });
}

std::size_t DynamicTessellation::rebuilds() const noexcept {
    return state_ == nullptr ? 0 : state_->visit([](auto& live) { return live.rebuilds(); });
}

Moves DynamicTessellation::moves() const noexcept {
    return state_ == nullptr ? Moves() : state_->visit([](auto& live) { return live.moves(); });
}

std::uint64_t DynamicTessellation::insertions() const noexcept {
    return state_ == nullptr ? 0 : state_->visit([](auto& live) { return live.insertions(); });
}

}  // namespace signum
