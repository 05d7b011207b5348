/// Flips a second of sites that move at random, exact and in plain doubles, which take turns: the
/// same certificates and queue, roots by the same bisection but without bounds on errors. And how
/// many sites hide and appear a second where they have weights, and what a site takes of memory.
///
/// usage: kinetic_benchmark [most sites]

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <random>
#include <vector>

#include <fmt/format.h>

#include "../triangulation/flips/event_queue.hpp"
#include "../triangulation/moving/forms.hpp"
#include "../triangulation/moving/moving_triangulation.hpp"
#include "../triangulation/structure/flip.hpp"
#include "measuring.hpp"

namespace signum::benchmarks {
namespace {

using triangulation::HalfEdge;
using triangulation::Topology;

/// One site a unit of area, velocities in a square of side 2; weights up to a radius.
std::vector<MovingSite> sites(std::size_t number, double radius) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const double half = 0.5 * std::sqrt(static_cast<double>(number));
    std::vector<MovingSite> result;
    for (std::size_t i = 0; i < number; ++i)
        result.push_back({half * unit(random), half * unit(random), unit(random), unit(random),
                          0.5 * radius * (1.0 + unit(random)), 0.0});
    return result;
}

/// The first root of a polynomial in s > 0 at which it goes below 0, in plain doubles.
std::optional<double> first_root(const std::array<double, 5>& q) {
    constexpr std::size_t n = 4;
    struct Piece {
        std::array<double, n + 1> b;
        double low;
        double high;
    };
    if (q[0] == 0.0) return 0.0;
    const double scale = std::sqrt(std::sqrt(std::fabs(q[0] / q[n])));
    std::array<Piece, 40> pieces;
    constexpr std::array<double, n + 1> binomial = {1, 4, 6, 4, 1};
    double power = 1.0;
    for (std::size_t i = 0; i <= n; ++i, power *= scale)
        pieces[0].b[i] = q[i] * power / binomial[i];
    pieces[0].low = 0.0;
    pieces[0].high = 1.0;
    for (std::size_t left = 1; left > 0;) {
        Piece& piece = pieces[left - 1];
        int changes = 0;
        for (std::size_t i = 0; i < n; ++i)
            changes += static_cast<int>((piece.b[i] > 0.0) != (piece.b[i + 1] > 0.0));
        if (changes == 0) {
            --left;
            continue;
        }
        if (changes == 1 || left == pieces.size()) {
            const bool positive = piece.b[0] > 0.0;
            double below = scale * piece.low / (1.0 - piece.low);
            double above = piece.high < 1.0 ? scale * piece.high / (1.0 - piece.high) : 1e300;
            double s = scale * (piece.low + piece.high) / (2.0 - piece.low - piece.high);
            for (int step = 0; step < 60; ++step) {
                double value = q[n];
                double slope = 0.0;
                for (std::size_t k = n; k-- > 0;) {
                    slope = slope * s + value;
                    value = value * s + q[k];
                }
                ((value > 0.0) == positive ? below : above) = s;
                double next = s - value / slope;
                if (!(next > below && next < above))
                    next = above < 1e300 ? 0.5 * (below + above) : 2.0 * s;
                if (!(std::fabs(next - s) > 1e-15 * s)) break;
                s = next;
            }
            if (positive) return s;
            --left;
            continue;
        }
        Piece& first = pieces[left++];
        first.low = piece.low;
        first.high = piece.low = 0.5 * (piece.low + piece.high);
        for (std::size_t level = 0; level <= n; ++level) {
            first.b[level] = piece.b[0];
            for (std::size_t i = 0; i + level < n; ++i)
                piece.b[i] = 0.5 * (piece.b[i] + piece.b[i + 1]);
        }
    }
    return std::nullopt;
}

/// The Delaunay triangulation of moving points as one writes it in an hour: right as long as
/// rounding allows.
class Naive {
 public:
    Naive(std::vector<MovingSite> sites, const Topology& topology)
        : sites_(std::move(sites)), topology_(topology), queue_(4 * topology.room(), Order()) {
        for (Index f = 0; f < topology_.faces(); ++f) watch_edges(f);
    }
    void advance(double t) {
        while (!queue_.empty() && queue_.top().when <= t) {
            const auto event = queue_.pop();
            now_ = event.when;
            const HalfEdge h = event.subject;
            const Index f = Topology::face(h);
            const Index g = Topology::face(topology_.twin(h));
            for (const Index face : {f, g})
                for (HalfEdge e = Topology::first_edge(face); e < Topology::first_edge(face) + 3;
                     ++e)
                    queue_.erase(topology_.edge(e));
            flip(topology_, h);
            ++flips_;
            watch_edges(f);
            watch_edges(g);
        }
    }
    [[nodiscard]] std::uint64_t flips() const noexcept { return flips_; }

 private:
    struct Order {
        int operator()(double a, double b) const noexcept {
            return static_cast<int>(a > b) - static_cast<int>(a < b);
        }
    };
    void watch_edges(Index face) {
        for (HalfEdge h = Topology::first_edge(face); h < Topology::first_edge(face) + 3; ++h)
            watch(h);
    }
    void watch(HalfEdge h) {
        const Index a = topology_.apex(h);
        const Index b = topology_.origin(h);
        const Index c = topology_.target(h);
        const Index d = topology_.apex(topology_.twin(h));
        const auto site = [&](Index i) { return sites_[static_cast<std::size_t>(i)]; };
        const auto turn = [&](Index p, Index q, Index r) {
            const auto t = kinetic::orientation<double>(site(p), site(q), site(r), {{}, now_}).c;
            return std::array<double, 5>{t[0], t[1], t[2], 0.0, 0.0};
        };
        std::array<double, 5> certificate;
        if (a == infinite)
            certificate = turn(d, c, b);
        else if (d == infinite)
            certificate = turn(a, b, c);
        else if (b == infinite)
            certificate = turn(a, c, d);
        else if (c == infinite)
            certificate = turn(d, b, a);
        else
            certificate =
                kinetic::in_circle<double>(site(b), site(a), site(c), site(d), {{}, now_}).c;
        // That of an edge that was just flipped is above 0 but for rounding.
        if (certificate[0] < 0.0) certificate[0] = 0.0;
        const auto s = certificate[4] != 0.0 ? first_root(certificate) : first_of_turn(certificate);
        if (s && *s > 0.0)
            queue_.set(topology_.edge(h), now_ + *s);
        else
            queue_.erase(topology_.edge(h));
    }
    static std::optional<double> first_of_turn(const std::array<double, 5>& q) {
        const double root = std::sqrt(q[1] * q[1] - 4.0 * q[2] * q[0]);
        if (!(root >= 0.0)) return std::nullopt;
        const double half = -0.5 * (q[1] + std::copysign(root, q[1]));
        std::optional<double> first;
        for (const double s : {half / q[2], q[0] / half})
            if (s > 0.0 && (!first || s < *first)) first = s;
        return first;
    }

    std::vector<MovingSite> sites_;
    Topology topology_;
    triangulation::EventQueue<double, Order> queue_;
    double now_ = 0.0;
    std::uint64_t flips_ = 0;
};

void measure(std::size_t number, double radius) {
    const std::vector<MovingSite> moving = sites(number, radius);
    const double until = 0.3;
    std::vector<double> rates;
    std::vector<double> naive_rates;
    std::vector<double> ratios;
    double start = 0.0;
    double memory = 0.0;
    kinetic::Work work;
    for (int round = 0; round < 5; ++round) {
        const double before = bytes_taken();
        kinetic::MovingTriangulation exact(0.0, {});
        start = seconds_of([&] { exact.insert(moving); });
        std::optional<Naive> naive;
        if (radius == 0.0) naive.emplace(moving, exact.topology());
        const double time = seconds_of([&] { exact.advance(until); });
        memory = bytes_taken() - before;
        work = exact.work();
        rates.push_back(static_cast<double>(work.events) / time);
        if (!naive) continue;
        const double naive_time = seconds_of([&] { naive->advance(until); });
        naive_rates.push_back(static_cast<double>(naive->flips()) / naive_time);
        // Per flip, for where rounding errs their numbers differ.
        ratios.push_back(naive_rates.back() / rates.back());
    }
    const auto in_doubles = [&](const std::vector<double>& values, const char* format) {
        return values.empty() ? std::string("–")
                              : fmt::format(fmt::runtime(format), median(values));
    };
    fmt::print("| {} | {} | {:.0f} | {} | {} | {} | {} | {:.2f} | {:.0f} |\n", number,
               radius == 0.0 ? "none" : fmt::format("up to {}", radius), median(rates),
               in_doubles(naive_rates, "{:.0f}"), in_doubles(ratios, "{:.2f}"), work.flips,
               work.hidden + work.appeared, start * 1e6 / static_cast<double>(number),
               memory / static_cast<double>(number));
}

}  // namespace
}  // namespace signum::benchmarks

int main(int count, char** words) {
    const std::size_t most = count > 1 ? std::strtoul(words[1], nullptr, 10) : 100'000;
    fmt::print(
        "| sites | radii | events a second | in doubles | exact / doubles, time | flips | hidden "
        "and appeared | start, µs a site | bytes a site, both |\n| --: | --- | --: | --: | --: | "
        "--: | --: | --: | --: |\n");
    for (const std::size_t number : {1000UL, 10'000UL, 100'000UL, 1'000'000UL})
        for (const double radius : {0.0, 0.6})
            if (number <= most) signum::benchmarks::measure(number, radius);
    return 0;
}
