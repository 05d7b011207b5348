/// Constructions that ask through pointers, so that each algorithm is compiled once for all
/// arithmetics: in those that are so slow that it is not felt, and where somebody counts.

#include "../../predicates/ladder/with_arithmetic.hpp"
#include "constructions.hpp"

namespace signum::triangulation {
namespace {

/// PowerSigns<S, arithmetic> of an arithmetic that is chosen while the program runs.
template <class S>
struct PointedSigns {
    using SiteType = S;
    /// Some of them round.
    static constexpr bool is_trusted = false;

    bool is_exact;
    Decision (*ccw)(const S&, const S&, const S&) noexcept;
    Decision (*in_circle)(const S&, const S&, const S&, const S&) noexcept;
    Decision (*in_segment)(const S&, const S&, const S&) noexcept;
    Decision (*nearer)(const Point&, const S&, const S&) noexcept;
};
template <class Signs>
constexpr PointedSigns<typename Signs::SiteType> pointed_signs = {
    Signs::is_exact, &Signs::ccw, &Signs::in_circle, &Signs::in_segment, &Signs::nearer};

/// The predicates under the tie rule of a metric and an arithmetic, both chosen while the program
/// runs.
struct PointedPredicates {
    /// Some of them round.
    static constexpr Arithmetic arithmetic_used = Arithmetic::naive;
    template <std::size_t n>
    using Ranks = std::array<Index, n>;

    Decision (*hides)(const Site&, const Site&, const Ranks<2>&) noexcept;
    Decision (*exists)(const Site&, const Site&, const Site&, const Ranks<3>&) noexcept;
    Decision (*exists_twice)(const Site&, const Site&, const Site&, const Ranks<3>&) noexcept;
    Decision (*precedes_on_bisector)(const Site&, const Site&, const Site&, const Site&,
                                     const Ranks<4>&) noexcept;
    Decision (*in_order_at_infinity)(const Site&, const Site&, const Site&, const Site&, bool,
                                     const Ranks<4>&) noexcept;
    Decision (*in_circle_of_visible)(const Site&, const Site&, const Site&, const Site&,
                                     const Ranks<4>&) noexcept;
    Decision (*in_circle)(const Site&, const Site&, const Site&, const Site&,
                          const Ranks<4>&) noexcept;
    Decision (*in_circle_infinite)(const Site&, const Site&, const Site&, const Ranks<3>&) noexcept;
    Decision (*holds_first_direction)(const Site&, const Site&, const Site&,
                                      const Ranks<3>&) noexcept;
    Decision (*nearer)(const Point&, const Site&, const Site&, const Ranks<2>&) noexcept;
    additive::Distance (*distance)(const Point&, const Site&) noexcept;
};
template <class Predicates>
constexpr PointedPredicates pointed_predicates = {&Predicates::hides,
                                                  &Predicates::exists,
                                                  &Predicates::exists_twice,
                                                  &Predicates::precedes_on_bisector,
                                                  &Predicates::in_order_at_infinity,
                                                  &Predicates::in_circle_of_visible,
                                                  &Predicates::in_circle,
                                                  &Predicates::in_circle_infinite,
                                                  &Predicates::holds_first_direction,
                                                  &Predicates::nearer,
                                                  &Predicates::distance};

}  // namespace

Tessellation construct_in_any_arithmetic(Metric metric, const StridedSites& input,
                                         const Options& options) {
    using AnyKernel = AdditiveKernel<PointedPredicates, filters::Tally>;
    return construct_by_metric(
        metric, input,
        [&]<class S>() {
            const PointedSigns<S> signs = predicates::with_arithmetic(
                options.arithmetic, []<Arithmetic a>() { return pointed_signs<PowerSigns<S, a>>; });
            return construct_with_kernel<PowerKernel<PointedSigns<S>, filters::Tally>>(
                metric, input, options, signs);
        },
        [&]<class M>() {
            const PointedPredicates predicates =
                predicates::with_arithmetic(options.arithmetic, []<Arithmetic a>() {
                    return pointed_predicates<typename PredicatesOf<M>::template Perturbed<a>>;
                });
            if constexpr (M::traits.has_sweep)
                if (options.method == Method::sweep)
                    return predicates::with_arithmetic(options.arithmetic, [&]<Arithmetic a>() {
                        return construct_by_sweep_with_kernel<typename PredicatesOf<M>::Directions,
                                                              a, AnyKernel>(metric, input, options,
                                                                            predicates);
                    });
            return construct_additive_with_kernel<M, AnyKernel>(input, options, predicates);
        });
}

}  // namespace signum::triangulation
