/// The stages behind a filter, as predicates/ladder/ladder.hpp has them, but for its wide and its
/// rational numbers: expansions in the window, dyadic numbers everywhere.

namespace signum::predicates {

template <Arithmetic>
using ExactNumber = exact::Dyadic;
template <Arithmetic>
[[nodiscard]] inline exact::Dyadic exactly(double value) {
    return exact::Dyadic(value);
}

namespace ladder {

using filters::Verdict;

struct Refined {
    using Number = filters::DoubleDouble;
    [[nodiscard]] static Number difference(double a, double b) noexcept {
        return filters::exact_difference(a, b);
    }
    [[nodiscard]] static Number difference_of_squares(double a, double b) noexcept {
        return filters::exact_difference(a, b) * filters::exact_sum(a, b);
    }
    [[nodiscard]] static Number zero() noexcept { return {0.0, 0.0}; }
};
struct Expanded {
    [[nodiscard]] static exact::Expansion<2> difference(double a, double b) noexcept {
        return exact::difference(a, b);
    }
    [[nodiscard]] static exact::Expansion<4> difference_of_squares(double a, double b) noexcept {
        return exact::product(a, a) - exact::product(b, b);
    }
    [[nodiscard]] static exact::Expansion<1> zero() noexcept { return {}; }
};
struct Exactly {
    using Number = exact::Dyadic;
    [[nodiscard]] static Number difference(double a, double b) { return Number(a) - Number(b); }
    [[nodiscard]] static Number difference_of_squares(double a, double b) {
        return Number(a) * Number(a) - Number(b) * Number(b);
    }
    [[nodiscard]] static Number zero() { return {}; }
};

[[nodiscard]] inline Verdict judged(double value, double bound) noexcept {
    if (filters::magnitude(value) > bound) return Verdict::certain(filters::sign_of_nonzero(value));
    return Verdict::uncertain();
}

template <class Formula>
struct FilterAgain {
    static constexpr Stage stage = Stage::filter;
    template <class... Sites>
    [[nodiscard]] static Verdict ask(const Sites&... sites) noexcept {
        return Formula::filter(sites...);
    }
};
template <class Formula>
struct Bounded {
    static constexpr Stage stage = Stage::filter;
    template <class... Sites>
    [[nodiscard]] static Verdict ask(const Sites&... sites) noexcept {
        const auto [value, bound] = Formula::bounded(sites...);
        return judged(value, bound);
    }
};
template <class Formula>
struct InExactNumbers {
    static constexpr Stage stage = Stage::multiprecision;
    template <class... Sites>
    [[nodiscard, gnu::cold, gnu::noinline]] static Verdict ask(const Sites&... sites) noexcept {
        return Verdict::certain(Formula::template value<Exactly>(sites...).sign());
    }
};

/// Those of degree 2 alone; the others would be as long as all the rest.
template <class Formula>
struct InExpansions : InExactNumbers<Formula> {};
template <>
struct InExpansions<Ccw> {
    static constexpr Stage stage = Stage::exact;
    [[nodiscard, gnu::noinline]] static Verdict ask(const Point& a, const Point& b,
                                                    const Point& c) noexcept {
        return Verdict::certain(Ccw::value<Expanded>(a, b, c).sign());
    }
};

template <class First, class... Others>
struct Steps {
    template <class... Sites>
    [[nodiscard]] static Decision climb(const Sites&... sites) noexcept {
        const Verdict verdict = First::ask(sites...);
        if constexpr (sizeof...(Others) > 0)
            if (!verdict.is_certain()) return Steps<Others...>::climb(sites...);
        return {verdict.sign(), First::stage};
    }
};
template <class Formula>
using Beyond = Steps<InExactNumbers<Formula>>;

template <int exponent, class S>
[[nodiscard]] inline bool in_window(const S& s) noexcept {
    using exact::window::contains;
    bool holds = contains(s.x, exponent) && contains(s.y, exponent);
    if constexpr (words::has_z<S>) holds = holds && contains(s.z, exponent);
    if constexpr (words::has_r<S>) holds = holds && contains(s.r, exponent);
    if constexpr (words::has_w<S>) holds = holds && contains(s.w, 2 * exponent);
    return holds;
}
template <class Formula, class Within, class Outside, class... Sites>
[[nodiscard, gnu::noinline]] Decision climb_one(const Sites&... sites) noexcept {
    if constexpr (words::has_window<Formula>)
        if ((in_window<Formula::window>(sites) && ...)) return Within::climb(sites...);
    return Outside::climb(sites...);
}
template <Arithmetic, class Formula, class Within, class Outside, class... Sites>
[[nodiscard]] inline Decision climb(const Sites&... sites) noexcept {
    return exact::in_ieee_environment(climb_one<Formula, Within, Outside, Sites...>, sites...);
}

}  // namespace ladder
}  // namespace signum::predicates
