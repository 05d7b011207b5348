#include "batch.hpp"

#include <algorithm>

#include "../core/contract.hpp"
#include "batch/lanes.hpp"
#include "power.hpp"

namespace signum::predicates::batch {
namespace {

std::int8_t ask_ccw(const Questions<3>& of, std::size_t i) noexcept {
    return static_cast<std::int8_t>(signum::ccw(of.site(0, i), of.site(1, i), of.site(2, i)));
}
template <class S>
std::int8_t ask_in_circle(const Questions<4>& of, std::size_t i) noexcept {
    const auto site = [&](std::size_t m) { return power::made_of<S>(of.site(m, i)); };
    return static_cast<std::int8_t>(power::in_circle(site(0), site(1), site(2), site(3)));
}

/// The barriers keep the arithmetic in the environment that is tested here, wherever this function
/// is inlined (filters/environment.hpp): what the filter reads it reads behind the first one.
template <std::size_t n>
std::size_t answer(Filter<n> filter, Ask<n> ask, const Questions<n>& questions,
                   std::int8_t* signs) noexcept {
    asm volatile("" : : : "memory");
    std::size_t asked = questions.count;
    if (filter != nullptr && filters::environment_is_default()) {
        asked = filter(questions, signs, ask);
    } else {
        for (std::size_t i = 0; i < questions.count; ++i) signs[i] = ask(questions, i);
    }
    asm volatile("" : : : "memory");
    return asked;
}

template <std::size_t n>
Third third_of(const Questions<n>& questions) noexcept {
    Third third = Third::none;
    for (const StridedSites* sites : questions.operands) {
        if (sites->third() == nullptr) continue;
        const Third own = sites->third_is_weight() ? Third::weight : Third::radius;
        SIGNUM_EXPECTS(third == Third::none || third == own);
        third = own;
    }
    return third;
}

const Instructions* widest() noexcept {
    static const std::span<const Instructions> all = instructions();
    return all.empty() ? nullptr : all.data();
}

template <std::size_t n>
Questions<n> questions(const std::array<const StridedSites*, n>& operands,
                       std::span<std::int8_t> signs) noexcept {
    for ([[maybe_unused]] const StridedSites* operand : operands)
        SIGNUM_EXPECTS(operand->size() == signs.size() || operand->size() == 1);
    return {operands, nullptr, signs.size()};
}
template <std::size_t n>
Questions<n> questions(const StridedSites& sites, std::span<const std::array<Index, n>> places,
                       [[maybe_unused]] std::span<std::int8_t> signs) noexcept {
    SIGNUM_EXPECTS(places.size() == signs.size());
    SIGNUM_EXPECTS(std::ranges::all_of(places, [&](const std::array<Index, n>& each) {
        return std::ranges::all_of(each, [&](Index place) {
            return place >= 0 && static_cast<std::size_t>(place) < sites.size();
        });
    }));
    Questions<n> result = {{}, places.empty() ? nullptr : places.front().data(), places.size()};
    result.operands.fill(&sites);
    return result;
}

}  // namespace

std::size_t ccw(const Instructions* with, const Questions<3>& questions,
                std::int8_t* signs) noexcept {
    // Sites that are copied are copied without their third numbers.
    const bool whole = questions.places == nullptr && third_of(questions) != Third::none;
    return answer<3>(with == nullptr ? nullptr : with->ccw[whole], ask_ccw, questions, signs);
}
std::size_t in_circle(const Instructions* with, const Questions<4>& questions,
                      std::int8_t* signs) noexcept {
    constexpr Ask<4> asks[] = {ask_in_circle<Point>, ask_in_circle<Site>,
                               ask_in_circle<power::Site>};
    const auto third = static_cast<std::size_t>(third_of(questions));
    return answer<4>(with == nullptr ? nullptr : with->in_circle[third], asks[third], questions,
                     signs);
}

}  // namespace signum::predicates::batch

namespace signum {

namespace batch = predicates::batch;

void ccw_batch(const StridedSites& a, const StridedSites& b, const StridedSites& c,
               std::span<std::int8_t> signs) noexcept {
    batch::ccw(batch::widest(), batch::questions<3>({&a, &b, &c}, signs), signs.data());
}
void ccw_batch(const StridedSites& sites, std::span<const std::array<Index, 3>> triples,
               std::span<std::int8_t> signs) noexcept {
    batch::ccw(batch::widest(), batch::questions<3>(sites, triples, signs), signs.data());
}

namespace power {

void in_circle_batch(const StridedSites& i, const StridedSites& j, const StridedSites& k,
                     const StridedSites& q, std::span<std::int8_t> signs) noexcept {
    batch::in_circle(batch::widest(), batch::questions<4>({&i, &j, &k, &q}, signs), signs.data());
}
void in_circle_batch(const StridedSites& sites, std::span<const std::array<Index, 4>> quadruples,
                     std::span<std::int8_t> signs) noexcept {
    batch::in_circle(batch::widest(), batch::questions<4>(sites, quadruples, signs), signs.data());
}

}  // namespace power
}  // namespace signum
