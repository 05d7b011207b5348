/// One call of a predicate: against the sign of the plain determinant on random input, and in each
/// of the stages behind the filter. Operands lie in the first-level cache; the sum of the signs is
/// used.

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "../exact/sign_of_sum.hpp"
#include "../predicates/batch.hpp"
#include "../predicates/batch/lanes.hpp"
#include "../predicates/power.hpp"
#include "../tool/generate/generate.hpp"

#include "interleaved.hpp"

namespace signum::benchmarks {
namespace {

/// 256 tuples of at most 96 bytes: 24 KiB.
constexpr std::size_t tuples = 256;
constexpr double nanosecond = 1e-9;

template <class S, std::size_t n>
using Operands = std::vector<std::array<S, n>>;

// --- The contestants -----------------------------------------------------------------------------

struct NaiveCcw {
    template <class S>
    Sign operator()(const S& a, const S& b, const S& c) const {
        return sign_of(predicates::ccw_determinant(a.x - c.x, a.y - c.y, b.x - c.x, b.y - c.y));
    }
};
struct ExactCcw {
    template <class S>
    Sign operator()(const S& a, const S& b, const S& c) const {
        return ccw(a, b, c);
    }
};
struct NaiveInCircle {
    template <class S>
    Sign operator()(const S& i, const S& j, const S& k, const S& q) const {
        return sign_of(
            power::in_circle_determinant(power::row(i, q), power::row(j, q), power::row(k, q)));
    }
};
struct ExactInCircle {
    template <class S>
    Sign operator()(const S& i, const S& j, const S& k, const S& q) const {
        return power::in_circle(i, j, k, q);
    }
};

// --- Batches
// ---------------------------------------------------------------------------------------

/// In the second-level cache, and beyond all caches but the last.
constexpr std::size_t batches[] = {4096, 1'000'000};

/// The questions, an array an operand, as a batch takes them.
template <class S, std::size_t n>
struct Batch {
    std::array<std::vector<S>, n> operands;
    std::vector<std::int8_t> signs;

    explicit Batch(const std::vector<std::array<S, n>>& questions) : signs(questions.size()) {
        for (const std::array<S, n>& question : questions)
            for (std::size_t m = 0; m < n; ++m) operands[m].push_back(question[m]);
    }
};

/// One question after another, as a user would write it.
template <class Predicate>
struct OneByOne {
    template <class S, std::size_t n>
    void operator()(Batch<S, n>& batch) const {
        std::array<const S*, n> operands;
        for (std::size_t m = 0; m < n; ++m) operands[m] = batch.operands[m].data();
        std::int8_t* const signs = batch.signs.data();
        for (std::size_t i = 0; i < batch.signs.size(); ++i)
            signs[i] = std::apply(
                [i](const auto*... sites) {
                    return static_cast<std::int8_t>(Predicate()(sites[i]...));
                },
                operands);
    }
};
struct AtOnce {
    template <class S>
    void operator()(Batch<S, 3>& batch) const {
        const auto& [a, b, c] = batch.operands;
        ccw_batch(a, b, c, batch.signs);
    }
    template <class S>
    void operator()(Batch<S, 4>& batch) const {
        const auto& [i, j, k, q] = batch.operands;
        power::in_circle_batch(i, j, k, q, batch.signs);
    }
};

template <class Contestant, class S, std::size_t n>
void add_batch(const std::string& name, Batch<S, n> batch) {
    benchmark::RegisterBenchmark(name.c_str(),
                                 [batch = std::move(batch)](benchmark::State& state) mutable {
                                     for (auto _ : state) {
                                         Contestant()(batch);
                                         benchmark::ClobberMemory();
                                     }
                                 });
}

/// Calls the predicate on all operands, again and again.
template <class Predicate, class Operand>
void add(const std::string& name, std::vector<Operand> operands) {
    benchmark::RegisterBenchmark(name.c_str(),
                                 [operands = std::move(operands)](benchmark::State& state) {
                                     const Operand* first = operands.data();
                                     const std::size_t count = operands.size();
                                     for (auto _ : state) {
                                         // The compiler must not know that these are the operands
                                         // of the last time.
                                         benchmark::DoNotOptimize(first);
                                         Sign sum = 0;
                                         for (std::size_t i = 0; i < count; ++i)
                                             sum += std::apply(Predicate(), first[i]);
                                         benchmark::DoNotOptimize(sum);
                                     }
                                 });
}

void add_failure(const std::string& name) {
    benchmark::RegisterBenchmark(name.c_str(), [](benchmark::State& state) {
        state.SkipWithError("wrong stage");
        for (auto _ : state) {
        }
    });
}

// --- The operands --------------------------------------------------------------------------------

template <class S>
constexpr const char* name_of_type = "Point";
template <>
constexpr const char* name_of_type<power::Site> = "power::Site";
template <>
constexpr const char* name_of_type<Site> = "Site";

/// A site of any kind; where the kind has a weight, r is its radius.
template <class S>
S make_site(double x, double y, double r) {
    if constexpr (std::same_as<S, Point>)
        return {x, y};
    else
        return {x, y, std::same_as<S, power::Site> ? r * r : r};
}

/// Uniform centres and radii, triples counterclockwise.
template <class S, std::size_t n>
Operands<S, n> random_operands(std::size_t count = tuples) {
    const std::vector<Site> sites = generate(
        Distribution::random,
        {.count = static_cast<std::int64_t>(count * n), .radius_to = 100.0, .seed = 20 + n});
    Operands<S, n> result(count);
    for (std::size_t i = 0; i < count; ++i) {
        auto& tuple = result[i];
        for (std::size_t m = 0; m < n; ++m) {
            const Site& site = sites[i * n + m];
            tuple[m] = make_site<S>(site.x, site.y, site.r);
        }
        // The orientation of a triple of ccw is left to chance.
        if (n == 4 &&
            ccw(power::centre(tuple[0]), power::centre(tuple[1]), power::centre(tuple[2])) < 0)
            std::swap(tuple[0], tuple[1]);
    }
    return result;
}

/// Which near tie: what the operands of a colder stage look like.
enum class Tie { ulp, grid, exact, tiny };
constexpr Tie ties[] = {Tie::ulp, Tie::grid, Tie::exact, Tie::tiny};
const char* name_of(Tie tie) {
    constexpr const char* names[] = {"a rounding away from a tie", "exact tie on a grid",
                                     "exact tie of random doubles",
                                     "exact tie at 2^-600: rationals"};
    return names[static_cast<int>(tie)];
}

/// A number to build ties from: with the bits of a grid, or with more than a product holds.
double tie_number(Tie tie, std::mt19937_64& random) {
    if (tie == Tie::grid) return static_cast<double>(random() % 1000);
    const double number = 700.0 * static_cast<double>(random() >> 11) * 0x1p-53;
    return tie == Tie::tiny ? number * 0x1p-600 : number;
}

template <class S>
Stage stage(const std::array<S, 4>& t) {
    return power::in_circle_decision(t[0], t[1], t[2], t[3]).stage;
}
Stage stage(const std::array<Point, 3>& t) {
    return ccw_decision(t[0], t[1], t[2]).stage;
}

/// The corners of rectangles, all of one radius: on a circle exactly, or up to a rounding.
template <class S>
Operands<S, 4> tied_circles(Tie tie) {
    std::mt19937_64 random(40);
    Operands<S, 4> result;
    while (result.size() < tuples) {
        const auto [left, right] = std::minmax({tie_number(tie, random), tie_number(tie, random)});
        const auto [low, high] = std::minmax({tie_number(tie, random), tie_number(tie, random)});
        if (!(left < right && low < high)) continue;
        const double r = tie_number(tie, random);
        const double off = tie == Tie::ulp ? std::nextafter(left, right) : left;
        const std::array<S, 4> corners = {make_site<S>(left, low, r), make_site<S>(right, low, r),
                                          make_site<S>(right, high, r), make_site<S>(off, high, r)};
        // Where all differences are exact, integers decide.
        if (tie == Tie::ulp && stage(corners) != Stage::refine) continue;
        result.push_back(corners);
    }
    return result;
}

/// Two points and the one halfway between them, exactly, or up to a rounding.
Operands<Point, 3> tied_lines(Tie tie) {
    std::mt19937_64 random(30);
    Operands<Point, 3> result;
    while (result.size() < tuples) {
        const Point a = {tie_number(tie, random), tie_number(tie, random)};
        const Point d = {tie_number(tie, random), tie_number(tie, random)};
        const Point b = {a.x + d.x, a.y + d.y};
        const Point c = {b.x + d.x, b.y + d.y};
        const bool exact = b.x - a.x == d.x && c.x - b.x == d.x && b.y - a.y == d.y &&
                           c.y - b.y == d.y && d != Point();
        if (!exact) continue;
        const double off = tie == Tie::ulp ? std::nextafter(b.y, c.y) : b.y;
        const std::array<Point, 3> triple = {a, {b.x, off}, c};
        // Where a and c are near each other a rounding is much, and the filter sees it.
        if (ccw_decision(triple[0], triple[1], triple[2]).stage == Stage::filter) continue;
        result.push_back(triple);
    }
    return result;
}

/// The one stage that decides all operands; two stages in one row would be a wrong row.
template <class Operand>
bool one_stage(const std::vector<Operand>& operands) {
    for (const Operand& operand : operands)
        if (stage(operand) != stage(operands.front()) || stage(operand) == Stage::filter)
            return false;
    return true;
}

// --- What is run ---------------------------------------------------------------------------------

template <class S>
std::string title(const char* predicate, const char* contestant) {
    return fmt::format("{} {} {}", predicate, name_of_type<S>, contestant);
}

template <class S, std::size_t n, class Naive, class Exact>
void add_batches(const char* predicate) {
    for (const std::size_t count : batches) {
        const Batch<S, n> batch(random_operands<S, n>(count));
        const std::string name = fmt::format("{} {}", title<S>(predicate, "batch"), count);
        add_batch<OneByOne<Naive>>(name + " naive", batch);
        add_batch<OneByOne<Exact>>(name + " exact", batch);
        add_batch<AtOnce>(name + " at once", batch);
    }
}

template <class S>
void add_random() {
    add<NaiveCcw>(title<S>("ccw", "naive"), random_operands<S, 3>());
    add<ExactCcw>(title<S>("ccw", "exact"), random_operands<S, 3>());
    add<NaiveInCircle>(title<S>("in_circle", "naive"), random_operands<S, 4>());
    add<ExactInCircle>(title<S>("in_circle", "exact"), random_operands<S, 4>());
    add_batches<S, 3, NaiveCcw, ExactCcw>("ccw");
    add_batches<S, 4, NaiveInCircle, ExactInCircle>("in_circle");
}

template <class Predicate, class Operand>
void add_if_one_stage(const std::string& name, std::vector<Operand> operands) {
    if (one_stage(operands)) {
        add<Predicate>(name, std::move(operands));
    } else {
        add_failure(name);
    }
}

template <class S>
void add_ties() {
    for (const Tie tie : ties)
        add_if_one_stage<ExactInCircle>(title<S>("in_circle", name_of(tie)), tied_circles<S>(tie));
}

void add_line_ties() {
    for (const Tie tie : ties)
        add_if_one_stage<ExactCcw>(title<Point>("ccw", name_of(tie)), tied_lines(tie));
}

constexpr std::size_t terms[] = {6, 16, 64, 288};
/// 2048 terms in all: 16 KiB.
constexpr std::size_t sums(std::size_t terms_of_sum) {
    return 2048 / terms_of_sum;
}

std::string name_of_sum(std::size_t n, bool zero) {
    return fmt::format("sign_of_sum {} {}", n, zero ? "zero" : "random");
}

/// Random terms of three binades or so; where asked for, the last one makes the sum 0.
std::vector<double> summands(std::size_t n, bool zero) {
    std::mt19937_64 random(50);
    std::vector<double> result;
    for (std::size_t s = 0; s < sums(n); ++s) {
        double sum = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
            // Multiples of 2^-40 between -1 and 1: sums of hundreds are exact.
            const double term = static_cast<double>(random() >> 23) * 0x1p-40 - 1.0;
            result.push_back(i + 1 == n && zero ? -sum : term);
            sum += term;
        }
    }
    return result;
}

void add_sum(std::size_t n, bool zero) {
    benchmark::RegisterBenchmark(name_of_sum(n, zero).c_str(),
                                 [n, operands = summands(n, zero)](benchmark::State& state) {
                                     const double* first = operands.data();
                                     for (auto _ : state) {
                                         benchmark::DoNotOptimize(first);
                                         Sign sum = 0;
                                         for (std::size_t s = 0; s < sums(n); ++s)
                                             sum += sign_of_sum({first + s * n, n});
                                         benchmark::DoNotOptimize(sum);
                                     }
                                 });
}

// --- What is printed -----------------------------------------------------------------------------

constexpr double one_call = nanosecond * static_cast<double>(tuples);

template <class S>
void print_random(const Measurements& measured, const char* predicate, const char* limit) {
    const std::string naive = title<S>(predicate, "naive");
    const std::string exact = title<S>(predicate, "exact");
    print_row({fmt::format("`{}`, `{}`", predicate, name_of_type<S>),
               measured.cell(naive, one_call), measured.cell(exact, one_call),
               measured.ratio(exact, naive), limit});
}

template <class S>
void print_batches(const Measurements& measured, const char* predicate) {
    for (const std::size_t count : batches) {
        const std::string name = fmt::format("{} {}", title<S>(predicate, "batch"), count);
        const double unit = nanosecond * static_cast<double>(count);
        print_row({fmt::format("`{}`, `{}`, {}", predicate, name_of_type<S>, count),
                   measured.cell(name + " naive", unit), measured.cell(name + " exact", unit),
                   measured.cell(name + " at once", unit),
                   measured.ratio(name + " at once", name + " naive"),
                   measured.ratio(name + " at once", name + " exact")});
    }
}

template <class S>
std::string stage_of_ties(Tie tie) {
    return signum::name_of(stage(tied_circles<S>(tie).front()));
}

void print_tables(const Measurements& measured) {
    fmt::print("Predicates on random input, ns a call ({}):\n\n", SIGNUM_FLAGS);
    print_header({"predicate", "naive", "signum", "signum / naive", "at most"});
    for (const auto& [predicate, limit] : {std::pair{"ccw", "1.3"}, std::pair{"in_circle", "2"}}) {
        print_random<Point>(measured, predicate, limit);
        print_random<power::Site>(measured, predicate, limit);
        print_random<Site>(measured, predicate, limit);
    }

    const auto instructions = predicates::batch::instructions();
    fmt::print("\nBatches on random input, ns a question ({}):\n\n",
               instructions.empty() ? "without Highway" : instructions.front().name);
    print_header({"predicate, sites, questions", "naive, one by one", "signum, one by one",
                  "signum, a batch", "batch / naive", "batch / one by one"});
    for (const char* predicate : {"ccw", "in_circle"}) {
        print_batches<Point>(measured, predicate);
        print_batches<power::Site>(measured, predicate);
        print_batches<Site>(measured, predicate);
    }

    fmt::print("\nThe stages behind the filter, ns a call:\n\n");
    print_header({"operands", "`in_circle` decided by", "`Point`", "`power::Site`", "`Site`",
                  "`ccw` decided by", "`Point`"});
    for (const Tie tie : ties) {
        const auto cell = [&](const std::string& name) { return measured.cell(name, one_call); };
        print_row({name_of(tie), stage_of_ties<Point>(tie),
                   cell(title<Point>("in_circle", name_of(tie))),
                   cell(title<power::Site>("in_circle", name_of(tie))),
                   cell(title<Site>("in_circle", name_of(tie))),
                   signum::name_of(stage(tied_lines(tie).front())),
                   cell(title<Point>("ccw", name_of(tie)))});
    }

    fmt::print("\n`sign_of_sum`, ns a call:\n\n");
    print_header({"terms", "random", "sum 0"});
    for (const std::size_t n : terms) {
        const double unit = nanosecond * static_cast<double>(sums(n));
        print_row({fmt::format("{}", n), measured.cell(name_of_sum(n, false), unit),
                   measured.cell(name_of_sum(n, true), unit)});
    }
    fmt::print("\n{}\n", measured.footnote());
}

}  // namespace
}  // namespace signum::benchmarks

int main(int argc, char** argv) {
    using namespace signum;
    using namespace signum::benchmarks;
    add_random<Point>();
    add_random<power::Site>();
    add_random<Site>();
    add_ties<Point>();
    add_ties<power::Site>();
    add_ties<Site>();
    add_line_ties();
    for (const std::size_t n : terms) {
        add_sum(n, false);
        add_sum(n, true);
    }
    print_tables(run_interleaved(argc, argv, 21));
}
