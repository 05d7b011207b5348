/// Asks shared libraries made of single/signum_predicates.cpp, compiled by other compilers and with
/// other flags, what the library itself says of the configurations of the record (docs/record.md):
/// seven in eight are ties, of which three quarters are moved by ulps. Every second configuration
/// is asked in the next of the floating-point environments. Prints how many calls of each function
/// there were; exit 1 where one differs.
///
/// usage: single_calls CALLS SEED LIBRARY.so...

#include <dlfcn.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "../../../exact/sign_of_sum.hpp"
#include "../../../fuzz/record/mix.hpp"
#include "../../../fuzz/record/sites.hpp"
#include "../../../predicates/euclidean.hpp"
#include "../../../predicates/manhattan.hpp"
#include "../../../predicates/power.hpp"
#include "../../../predicates/space.hpp"
#include "../../../predicates/supremum.hpp"
#include "../../property/environments.hpp"

namespace signum::fuzz {
namespace {

using Number = const double*;
using Kinds = std::array<Kind, 6>;
constexpr Kinds kinds = {Kind::points,    Kind::weights,   Kind::radii,
                         Kind::euclidean, Kind::manhattan, Kind::supremum};

class Libraries {
 public:
    explicit Libraries(char** names) {
        for (; *names != nullptr; ++names) {
            void* const library = dlopen(*names, RTLD_NOW | RTLD_LOCAL);
            if (library == nullptr) {
                std::fprintf(stderr, "%s\n", dlerror());
                std::exit(2);
            }
            all_.push_back(library);
        }
    }
    /// Asks each library in this environment, and counts the answers that differ.
    template <class... Operands>
    void ask(const char* function, int expected, int environment, Operands... operands) {
        using Function = int(Operands...);
        auto& [asked, functions] = functions_[function];
        if (functions.empty())
            for (void* const library : all_) functions.push_back(dlsym(library, function));
        for (std::size_t k = 0; k < functions.size(); ++k) {
            auto* const call = reinterpret_cast<Function*>(functions[k]);
            const int said = within(environment, [&] { return call(operands...); });
            if (said == expected) continue;
            ++wrong_;
            if (wrong_ <= 20)
                std::fprintf(stderr, "library %zu, %s: %s is %d, not %d\n", k,
                             name_of_environment(environment).c_str(), function, expected, said);
            is_wrong_ = true;
        }
        asked += functions.size();
        calls_ += functions.size();
    }
    [[nodiscard]] std::uint64_t calls() const { return calls_; }
    [[nodiscard]] std::uint64_t wrong() const { return wrong_; }
    [[nodiscard]] bool take_wrong() { return std::exchange(is_wrong_, false); }
    void print() const {
        for (const auto& [name, counted] : functions_)
            std::printf("%-40s %12llu\n", name.c_str(),
                        static_cast<unsigned long long>(counted.first));
        std::printf("%-40s %12llu, %llu wrong\n", "all", static_cast<unsigned long long>(calls_),
                    static_cast<unsigned long long>(wrong_));
    }

 private:
    std::vector<void*> all_;
    std::map<std::string, std::pair<std::uint64_t, std::vector<void*>>> functions_;
    std::uint64_t calls_ = 0;
    std::uint64_t wrong_ = 0;
    bool is_wrong_ = false;
};

template <class S>
void ask_power_circles(Libraries& libraries, int environment, const Configuration<2>& given,
                       const std::array<std::array<double, 3>, 4>& n, const char* circle,
                       const char* infinite) {
    const auto site = [&](std::size_t m) { return site_of<S>(given.balls[m]); };
    // The sign of the determinant, whichever way the three turn.
    libraries.ask(
        circle,
        predicates::decide<Arithmetic::exact, power::InCircle>(site(0), site(1), site(2), site(3))
            .sign,
        environment, Number(n[0].data()), Number(n[1].data()), Number(n[2].data()),
        Number(n[3].data()));
    if (given.balls[0].centre != given.balls[1].centre)
        libraries.ask(infinite, power::in_circle_infinite(site(0), site(1), site(2)), environment,
                      Number(n[0].data()), Number(n[1].data()), Number(n[2].data()));
}

/// Of a metric that takes radii.
template <class Predicates>
void ask_metric(Libraries& libraries, int environment, int metric, const Configuration<2>& given,
                const std::array<std::array<double, 3>, 4>& n) {
    const auto metric_number = static_cast<std::int32_t>(metric);
    const std::array<Site, 4> s = {site_of<Site>(given.balls[0]), site_of<Site>(given.balls[1]),
                                   site_of<Site>(given.balls[2]), site_of<Site>(given.balls[3])};
    const auto at = [&](std::size_t m) { return Number(n[m].data()); };
    const bool exists = Predicates::exists(s[0], s[1], s[2]);
    libraries.ask("signum_exists", exists ? 1 : 0, environment, metric_number, at(0), at(1), at(2));
    bool is_hidden = false;
    for (std::size_t m = 0; m < 3; ++m) {
        const bool hides = Predicates::hidden(s[3], s[m]);
        is_hidden |= hides;
        libraries.ask("signum_hidden", hides ? 1 : 0, environment, metric_number, at(3), at(m));
    }
    const Point p = {s[3].x, s[3].y};
    libraries.ask("signum_nearer", Predicates::nearer(p, s[0], s[1]), environment, metric_number,
                  at(3), at(0), at(1));
    if (exists) {
        const auto places = ranks<2, 4>(given, std::array<std::size_t, 4>{0, 1, 2, 3});
        libraries.ask("signum_in_circle_perturbed",
                      Predicates::in_circle_perturbed(s[0], s[1], s[2], s[3], places), environment,
                      metric_number, at(0), at(1), at(2), at(3), places.data());
        if (!is_hidden)
            libraries.ask("signum_in_circle", Predicates::in_circle(s[0], s[1], s[2], s[3]),
                          environment, metric_number, at(0), at(1), at(2), at(3));
    }
    if (given.balls[0].centre == given.balls[1].centre || Predicates::hidden(s[0], s[1]) ||
        Predicates::hidden(s[1], s[0]))
        return;
    const auto three = ranks<2, 3>(given, std::array<std::size_t, 3>{0, 1, 2});
    libraries.ask("signum_in_circle_infinite", Predicates::in_circle_infinite(s[0], s[1], s[2]),
                  environment, metric_number, at(0), at(1), at(2));
    libraries.ask("signum_in_circle_infinite_perturbed",
                  Predicates::in_circle_infinite_perturbed(s[0], s[1], s[2], three), environment,
                  metric_number, at(0), at(1), at(2), three.data());
}

/// The functions of a metric's namespace.
#define SIGNUM_FUNCTIONS_OF(Name, metric)                                                     \
    struct Name {                                                                             \
        static bool exists(const Site& i, const Site& j, const Site& k) {                     \
            return metric::exists(i, j, k);                                                   \
        }                                                                                     \
        static bool hidden(const Site& q, const Site& i) { return metric::hidden(q, i); }     \
        static Sign nearer(const Point& p, const Site& a, const Site& b) {                    \
            return metric::nearer(p, a, b);                                                   \
        }                                                                                     \
        static Sign in_circle(const Site& i, const Site& j, const Site& k, const Site& q) {   \
            return metric::in_circle(i, j, k, q);                                             \
        }                                                                                     \
        static Sign in_circle_infinite(const Site& a, const Site& b, const Site& q) {         \
            return metric::in_circle_infinite(a, b, q);                                       \
        }                                                                                     \
        static Sign in_circle_perturbed(const Site& i, const Site& j, const Site& k,          \
                                        const Site& q, const std::array<Index, 4>& ranks) {   \
            return metric::in_circle_perturbed(i, j, k, q, ranks);                            \
        }                                                                                     \
        static Sign in_circle_infinite_perturbed(const Site& a, const Site& b, const Site& q, \
                                                 const std::array<Index, 3>& ranks) {         \
            return metric::in_circle_infinite_perturbed(a, b, q, ranks);                      \
        }                                                                                     \
    };
SIGNUM_FUNCTIONS_OF(OfPower, power)
SIGNUM_FUNCTIONS_OF(OfEuclidean, euclidean)
SIGNUM_FUNCTIONS_OF(OfManhattan, manhattan)
SIGNUM_FUNCTIONS_OF(OfSupremum, supremum)

/// The same numbers with both signs, some moved by ulps, and all of them in another order.
void ask_sum(Libraries& libraries, int environment, const Configuration<2>& given,
             std::uint64_t bits) {
    std::vector<double> terms;
    for (const Ball<2>& ball : given.balls)
        for (const double x : {ball.centre[0], ball.centre[1], ball.size}) {
            terms.push_back(x);
            const double moved = (bits & 7) == 0 ? std::nextafter(x, 0.0) : x;
            terms.insert(terms.begin() + static_cast<std::ptrdiff_t>(bits % terms.size()), -moved);
            bits = bits * 6364136223846793005U + 1442695040888963407U;
        }
    libraries.ask("signum_sign_of_sum", sign_of_sum(terms), environment, Number(terms.data()),
                  terms.size());
}

void ask(Libraries& libraries, int environment, const Configuration<2>& given) {
    std::array<std::array<double, 3>, 4> n;
    for (std::size_t m = 0; m < 4; ++m)
        n[m] = {given.balls[m].centre[0], given.balls[m].centre[1], given.balls[m].size};
    const auto centre = [&](std::size_t m) { return site_of<Point>(given.balls[m]); };
    libraries.ask("signum_ccw", ccw(centre(0), centre(1), centre(2)), environment,
                  Number(n[0].data()), Number(n[1].data()), Number(n[2].data()));
    switch (given.kind) {
        case Kind::points:
            ask_power_circles<Point>(libraries, environment, given, n, "signum_in_circle_points",
                                     "signum_in_circle_infinite_points");
            break;
        case Kind::weights: {
            ask_power_circles<power::Site>(libraries, environment, given, n,
                                           "signum_in_circle_weights",
                                           "signum_in_circle_infinite_weights");
            const power::Site a = site_of<power::Site>(given.balls[0]);
            const power::Site b = site_of<power::Site>(given.balls[1]);
            libraries.ask("signum_nearer_weights", power::nearer(centre(3), a, b), environment,
                          Number(n[3].data()), Number(n[0].data()), Number(n[1].data()));
            libraries.ask("signum_hidden_weights", power::hidden(a, b) ? 1 : 0, environment,
                          Number(n[0].data()), Number(n[1].data()));
            break;
        }
        case Kind::radii:
            ask_metric<OfPower>(libraries, environment, 0, given, n);
            break;
        case Kind::euclidean:
            ask_metric<OfEuclidean>(libraries, environment, 1, given, n);
            break;
        case Kind::manhattan:
            ask_metric<OfManhattan>(libraries, environment, 2, given, n);
            break;
        default:
            ask_metric<OfSupremum>(libraries, environment, 3, given, n);
    }
}
void ask(Libraries& libraries, int environment, const Configuration<3>& given) {
    std::array<std::array<double, 4>, 5> n;
    for (std::size_t m = 0; m < 5; ++m) {
        const Ball<3>& ball = given.balls[m];
        n[m] = {ball.centre[0], ball.centre[1], ball.centre[2], ball.size};
    }
    const auto at = [&](std::size_t m) { return Number(n[m].data()); };
    const auto point = [&](std::size_t m) { return site_of<Point3>(given.balls[m]); };
    libraries.ask("signum_ccw_space", ccw(point(0), point(1), point(2), point(3)), environment,
                  at(0), at(1), at(2), at(3));
    if (given.kind == Kind::points) {
        libraries.ask("signum_in_sphere_points",
                      predicates::decide<Arithmetic::exact, power::InSphere>(
                          point(0), point(1), point(2), point(3), point(4))
                          .sign,
                      environment, at(0), at(1), at(2), at(3), at(4));
    } else if (given.kind == Kind::weights) {
        const auto site = [&](std::size_t m) { return site_of<power::Site3>(given.balls[m]); };
        libraries.ask("signum_in_sphere_weights",
                      predicates::decide<Arithmetic::exact, power::InSphere>(
                          site(0), site(1), site(2), site(3), site(4))
                          .sign,
                      environment, at(0), at(1), at(2), at(3), at(4));
    } else {
        const auto site = [&](std::size_t m) { return site_of<Site3>(given.balls[m]); };
        libraries.ask("signum_nearer_space",
                      power::nearer_decision(point(4), site(0), site(1)).sign, environment, at(4),
                      at(0), at(1));
    }
}

int run(int count, char** words) {
    if (count < 4) {
        std::fprintf(stderr, "usage: single_calls CALLS SEED LIBRARY.so...\n");
        return 2;
    }
    const std::uint64_t calls = std::strtoull(words[1], nullptr, 10);
    const std::uint64_t seed = std::strtoull(words[2], nullptr, 10);
    Libraries libraries(words + 3);
    constexpr Shares shares = {64, 32, 64};
    constexpr Shares extreme = {1, 1, 1, 0, true};
    Mix<2> plane(seed, shares);
    Mix<3> space(seed + 1, shares);
    Mix<2> plane_of_extremes(seed + 2, extreme);
    Mix<3> space_of_extremes(seed + 3, extreme);
    Configuration<2> in_plane;
    Configuration<3> in_space;
    for (std::uint64_t turn = 0; libraries.calls() < calls; ++turn) {
        const Kind kind = kinds[turn % kinds.size()];
        const int environment = turn % 2 == 0 ? 0 : static_cast<int>(turn / 2 % environments);
        const bool is_extreme = turn % 64 == 0;
        (is_extreme ? plane_of_extremes : plane).make(kind, in_plane);
        ask(libraries, environment, in_plane);
        if (turn % 16 == 0) ask_sum(libraries, environment, in_plane, turn * 0x9E3779B97F4A7C15U);
        const Kind kind_of_space = kinds[turn % 3];
        (is_extreme ? space_of_extremes : space).make(kind_of_space, in_space);
        ask(libraries, environment, in_space);
        if (libraries.take_wrong() && libraries.wrong() <= 20) {
            std::fprintf(stderr,
                         "  seed %llu turn %llu kind %s:", static_cast<unsigned long long>(seed),
                         static_cast<unsigned long long>(turn), std::string(name_of(kind)).c_str());
            for (const Ball<2>& ball : in_plane.balls)
                std::fprintf(stderr, " %a %a %a", ball.centre[0], ball.centre[1], ball.size);
            std::fprintf(stderr, " |");
            for (const Ball<3>& ball : in_space.balls)
                std::fprintf(stderr, " %a %a %a %a", ball.centre[0], ball.centre[1], ball.centre[2],
                             ball.size);
            std::fprintf(stderr, "\n");
        }
    }
    libraries.print();
    return libraries.wrong() == 0 ? 0 : 1;
}

}  // namespace
}  // namespace signum::fuzz

int main(int count, char** words) {
    return signum::fuzz::run(count, words);
}
