#include <signum/draw/power_shapes.hpp>
#include <signum/draw/shapes.hpp>

namespace signum {

const Shapes& shapes_of(Metric /*metric*/) noexcept {
    static constexpr Shapes power_shapes = {
        {"circle", power::write_disc}, power::drawn_radius, power::cell_edges};
    return power_shapes;  // the other metrics have no tessellation yet
}

}  // namespace signum
