#include "fluid.hpp"

#include <cmath>

#include "../../exact/elementary.hpp"

namespace signum::motion {
template <int D>
Kicks<D>::Kicks(const Effects<D>& effects, double time)
    : gravity_(effects.gravity), fluid_(effects.fluid), time_(time) {}

template <int D>
double Kicks<D>::decay(double rate) {
    if (rate != rate_) {
        rate_ = rate;
        decay_ = exact::exponential(-0.5 * rate * time_);
    }
    return decay_;
}

template <int D>
Vector<D> Kicks<D>::kicked(const Vector<D>& x, const Vector<D>& v, double radius, double mass) {
    Vector<D> result;
    for (int k = 0; k < D; ++k) result[k] = v[k] + 0.5 * time_ * gravity_[k];
    if (fluid_) {
        const double slowing = decay(fluid_->linear * radius / mass);
        const double area = D == 2 ? radius : radius * radius;
        Vector<D> u;
        Vector<D> w;
        for (int k = 0; k < D; ++k) {
            u[k] = fluid_->velocity[k] + dot(fluid_->gradient[k], x);
            w[k] = slowing * (result[k] - u[k]);
        }
        // dw/dt = -c |w| w: w / (1 + c |w| t).
        const double c = fluid_->quadratic * area / mass;
        const double factor = slowing / (1.0 + c * std::sqrt(dot(w, w)) * time_);
        for (int k = 0; k < D; ++k) result[k] = u[k] + factor * w[k];
    }
    for (int k = 0; k < D; ++k) result[k] += 0.5 * time_ * gravity_[k];
    return result;
}

template class Kicks<2>;
template class Kicks<3>;

}  // namespace signum::motion
