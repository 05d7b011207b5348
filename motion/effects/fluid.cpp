#include "fluid.hpp"

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
    const Vector<D> half = 0.5 * time_ * gravity_;
    Vector<D> result = v + half;
    if (fluid_) {
        const double slowing = decay(fluid_->linear * radius / mass);
        const double area = D == 2 ? radius : radius * radius;
        Vector<D> u = fluid_->velocity;
        for (int k = 0; k < D; ++k) u[k] += dot(fluid_->gradient[k], x);
        const Vector<D> w = slowing * (result - u);
        // dw/dt = -c |w| w: w / (1 + c |w| t).
        const double c = fluid_->quadratic * area / mass;
        result = u + slowing / (1.0 + c * norm(w) * time_) * w;
    }
    return result + half;
}

template class Kicks<2>;
template class Kicks<3>;

}  // namespace signum::motion
