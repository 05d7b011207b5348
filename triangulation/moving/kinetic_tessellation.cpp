#include "kinetic_tessellation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "../../core/error_free.hpp"
#include "../../exact/dyadic.hpp"
#include "../../exact/floating_environment.hpp"
#include "../../exact/nearest_double.hpp"
#include "../../filters/bounds.hpp"
#include "../../predicates/power.hpp"
#include "../dynamic/local_checks.hpp"
#include "../insertion/hiders.hpp"
#include "../insertion/locate.hpp"
#include "../kernels/power_kernel.hpp"
#include "../structure/assemble.hpp"
#include "../triangulate.hpp"
#include "moving_triangulation.hpp"

namespace signum {

using kinetic::MovingTriangulation;

class KineticTessellation::State {
 public:
    State(double start, Fall fall) : triangulation(start, fall), time(start) {}

    MovingTriangulation triangulation;
    double time;
    bool is_telling = false;  ///< on_edge is at work
};

namespace {

void check(std::initializer_list<double> numbers, const std::string& what) {
    for (const double number : numbers)
        if (!std::isfinite(number))
            throw std::invalid_argument("a number of " + what + " is not finite");
}
void check(const MovingSite& site, const std::string& name) {
    check({site.x, site.y, site.vx, site.vy, site.r, site.time}, name);
}
void check_number(std::size_t sites) {
    if (sites > max_sites) throw std::invalid_argument("there are too many sites");
}

/// The double nearest to x + v s + g s²/2, s = t - start.
double nearest_place(double x, double v, double g, double start, double t) {
    if (g == 0.0) {
        const auto s = two_difference(t, start);
        const auto way = two_product(v, s.high);
        const auto sum = two_sum(x, way.high);
        const double rest = sum.low + (way.low + v * s.low);
        // A few units in the last place of what is small beside the sum.
        const double error =
            0x1p-48 * (std::fabs(sum.low) + std::fabs(way.low) + std::fabs(v * s.low)) + 0x1p-1000;
        const double low = sum.high + (rest - error);
        if (low == sum.high + (rest + error)) return low;
    }
    using exact::Dyadic;
    const Dyadic s = Dyadic(t) - Dyadic(start);
    const Dyadic place = Dyadic(x) + s * (Dyadic(v) + Dyadic(0.5) * (Dyadic(g) * s));
    return exact::nearest_double([&](const Dyadic& at) { return (place - at).sign(); });
}

/// Of sites where they are now, and by their weights alone: who is tied is in no conflict.
class TolerantKernel
    : public triangulation::PowerKernel<triangulation::PowerSigns<Site>, filters::NoTally> {
 public:
    using PowerKernel::PowerKernel;
    [[nodiscard]] bool conflicts(Index i, Index j, Index k, Index q) const {
        return power::in_circle(site(i), site(j), site(k), site(q)) > 0;
    }
    [[nodiscard]] bool conflicts_on_line(Index a, Index b, Index q) const {
        return power::in_segment_decision(site(a), site(b), site(q)).sign > 0;
    }
};

/// Whether the faces make a power triangulation of these sites (local_checks.hpp), and the hidden
/// ones are hidden there, too.
bool is_valid(const MovingTriangulation& of, TolerantKernel& kernel) {
    bool valid = true;
    triangulation::LocalChecks<TolerantKernel> checks(of.topology(), kernel);
    checks.survey([&](Index) { valid = false; }, [&](triangulation::HalfEdge) { valid = false; },
                  [&] { return !valid; });
    valid = valid && checks.hull(of.infinite_face());
    for (Index q = 0; valid && static_cast<std::size_t>(q) < of.numbers(); ++q) {
        if (!of.contains(q) || !of.is_hidden(q)) continue;
        const Index f = triangulation::locate(of.topology(), kernel, of.face_of(of.beside(q)), q);
        const auto& v = of.topology().vertices(f);
        valid = !of.topology().is_infinite(f) && !kernel.conflicts(v[0], v[1], v[2], q);
    }
    return valid;
}

}  // namespace

KineticTessellation::KineticTessellation(double start, Fall fall) {
    check({start, fall.x, fall.y}, "the start or the fall");
    state_ = std::make_unique<State>(start, fall);
}
KineticTessellation::KineticTessellation(std::span<const MovingSite> sites, double start, Fall fall)
    : KineticTessellation(start, fall) {
    check_number(sites.size());
    for (std::size_t i = 0; i < sites.size(); ++i) check(sites[i], "site " + std::to_string(i));
    const exact::IeeeEnvironment environment;
    state_->triangulation.insert(sites);
}
KineticTessellation::KineticTessellation(KineticTessellation&&) noexcept = default;
KineticTessellation& KineticTessellation::operator=(KineticTessellation&&) noexcept = default;
KineticTessellation::~KineticTessellation() = default;

void KineticTessellation::require(Index handle) const {
    if (!contains(handle))
        throw std::out_of_range("there is no site with handle " + std::to_string(handle));
}

void KineticTessellation::require_quiet() const {
    if (state_->is_telling)
        throw std::logic_error(
            "on_edge changes the tessellation that is just telling it something");
}

Index KineticTessellation::insert(const MovingSite& site) {
    check(site, "the site");
    check_number(size() + 1);
    require_quiet();
    const exact::IeeeEnvironment environment;
    return state_->triangulation.insert(site);
}
void KineticTessellation::erase(Index handle) {
    require(handle);
    require_quiet();
    const exact::IeeeEnvironment environment;
    state_->triangulation.erase(handle);
}
void KineticTessellation::change(Index handle, const MovingSite& site) {
    require(handle);
    check(site, "the site");
    require_quiet();
    const exact::IeeeEnvironment environment;
    state_->triangulation.change(handle, site);
}

bool KineticTessellation::contains(Index handle) const noexcept {
    return state_->triangulation.contains(handle);
}
std::size_t KineticTessellation::size() const noexcept {
    return state_->triangulation.size();
}
MovingSite KineticTessellation::site(Index handle) const {
    require(handle);
    return state_->triangulation.site(handle);
}

double KineticTessellation::time() const noexcept {
    return state_->time;
}
std::optional<double> KineticTessellation::next_event() const {
    const exact::IeeeEnvironment environment;
    const std::optional<double> time = state_->triangulation.next_time();
    return time && std::isfinite(*time) ? time : std::nullopt;
}
void KineticTessellation::advance(double time) {
    check({time}, "the time");
    require_quiet();
    if (filters::compare_numbers(time, state_->time) < 0)
        throw std::invalid_argument("a tessellation that moves does not go back in time");
    const exact::IeeeEnvironment environment;
    state_->triangulation.advance(time);
    state_->time = time;
}

std::vector<Face> KineticTessellation::faces() const {
    std::vector<Face> result;
    const MovingTriangulation& of = state_->triangulation;
    if (of.is_line()) return result;
    for (Index f = 0; f < of.topology().faces(); ++f) {
        if (of.topology().is_vacant(f) || of.topology().is_infinite(f)) continue;
        const auto& v = of.topology().vertices(f);
        Face face = {v[0], v[1], v[2]};
        std::rotate(face.begin(), std::ranges::min_element(face), face.end());
        result.push_back(face);
    }
    std::ranges::sort(result);
    return result;
}

Tessellation KineticTessellation::tessellation() const {
    const exact::IeeeEnvironment environment;
    const MovingTriangulation& of = state_->triangulation;
    const double t = state_->time;
    std::vector<Site> sites;
    std::vector<Index> number(of.numbers(), -1);
    std::vector<Site> by_handle(of.numbers());
    for (Index i = 0; static_cast<std::size_t>(i) < of.numbers(); ++i) {
        if (!of.contains(i)) continue;
        const MovingSite& m = of.site(i);
        const Site site = {nearest_place(m.x, m.vx, of.fall().x, m.time, t),
                           nearest_place(m.y, m.vy, of.fall().y, m.time, t), m.r};
        if (!std::isfinite(site.x) || !std::isfinite(site.y))
            throw std::overflow_error("site " + std::to_string(i) +
                                      " is beyond the doubles at this time");
        number[static_cast<std::size_t>(i)] = static_cast<Index>(sites.size());
        by_handle[static_cast<std::size_t>(i)] = site;
        sites.push_back(site);
    }
    if (of.is_line()) return triangulate(sites, Metric::power);

    using namespace triangulation;
    std::vector<Index> numbers(by_handle.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<Index>(i);
    TolerantKernel kernel(by_handle.data(), numbers.data());
    if (!is_valid(of, kernel)) return triangulate(sites, Metric::power);

    std::vector<Index> hidden_by(by_handle.size(), -1);
    for (Index i = 0; static_cast<std::size_t>(i) < hidden_by.size(); ++i)
        if (of.contains(i) && of.is_hidden(i))
            hidden_by[static_cast<std::size_t>(i)] = of.beside(i);
    settle_hiders(of.topology(), kernel, hidden_by, Workers(1));
    TessellationArrays arrays;
    arrays.metric = Metric::power;
    arrays.sites = static_cast<std::int64_t>(sites.size());
    for (std::size_t i = 0; i < hidden_by.size(); ++i)
        if (hidden_by[i] >= 0)
            arrays.hidden.push_back({number[i], number[static_cast<std::size_t>(hidden_by[i])]});
    assemble(Topology(of.topology()), number, number, arrays, Workers(1));
    return constructed(std::move(arrays), std::move(sites), {});
}

void KineticTessellation::watch(std::function<void(Index a, Index b, bool comes)> on_edge) {
    require_quiet();
    if (!on_edge) return state_->triangulation.watch({});
    state_->triangulation.watch(
        [state = state_.get(), tell = std::move(on_edge)](Index a, Index b, bool comes) {
            state->is_telling = true;
            tell(a, b, comes);
            state->is_telling = false;
        });
}

KineticStatistics KineticTessellation::statistics() const noexcept {
    KineticStatistics result = state_->triangulation.work();
    const roots::Tally& tally = state_->triangulation.tally();
    result.filtered = tally.filtered;
    result.exact = tally.exact;
    return result;
}

}  // namespace signum
