#include "run_record.hpp"

#include <cmath>

#include "arrangement.hpp"
#include "energy.hpp"

namespace signum {

template <int D>
void RunRecord<D>::add(const motion::State<D>& state, double time, const motion::Counts& counts) {
    Moment moment;
    moment.time = time;
    const Energy<D> energy(state, effects_, time);
    moment.kinetic = energy.kinetic;
    moment.spin = energy.spin;
    moment.total = energy.total;
    moment.terms_of_total = energy.kinetic + energy.spin;
    double filled = 0.0;
    for (std::size_t i = 0; i < state.balls.size(); ++i) {
        const motion::Ball<D>& ball = state.balls[i];
        const motion::Vector<D> v = velocity(ball, time, effects_);
        for (int k = 0; k < D; ++k) {
            moment.momentum[static_cast<std::size_t>(k)] += state.masses[i] * v[k];
            moment.terms_of_total += std::fabs(state.masses[i] * effects_.gravity[k] *
                                               coordinate(ball, k, time, effects_));
        }
        const double fast = norm(v);
        moment.terms_of_momentum += state.masses[i] * fast;
        moment.fastest = larger(moment.fastest, fast);
        filled += motion::ball_volume<D>(1.0) * std::pow(radius_at(ball, time, effects_), D);
    }
    if (effects_.box) {
        moment.packing = filled;
        for (const double length : effects_.box->lengths()) moment.packing /= length;
    }
    moment.strikes = counts.strikes;
    moment.virial = counts.virial;
    moment.overlaps = deepest_overlaps(state, effects_, time);

    if (moments_.size() % every_ == 0) {
        if (looks_.size() == most_looks) {
            std::size_t kept = 0;
            for (std::size_t i = 0; i < looks_.size(); i += 2)
                looks_[kept++] = std::move(looks_[i]);
            looks_.resize(kept);
            every_ *= 2;
        }
        if (moments_.size() % every_ == 0) looks_.push_back({time, counts.strikes, state});
    }
    moments_.push_back(moment);
    end_ = state;
}

template class RunRecord<2>;
template class RunRecord<3>;

}  // namespace signum
