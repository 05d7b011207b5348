/// All pairs. Nothing is missed, for nothing is left out.
///
/// In a periodic box a pair is seen shifted by the nearest image, so a ball is asked again when it
/// has flown an eighth of the box: in the meantime two balls come nearer by a quarter at most, and
/// those images that are not the nearest one, at least half a length away along some axis, stay
/// farther than a quarter, which is more than two radii.

#include "../loop.hpp"
#include "../simulation.hpp"
#include "../world.hpp"

namespace signum::motion {

template <int D>
class Pairs {
 public:
    explicit Pairs(const World<D>& world, Structure = Structure::pairs) : world_(world) {}

    template <class Propose>
    void near(Slot i, const Propose& propose) const {
        for (Slot j = 0; j < world_.balls.size(); ++j)
            if (j != i) propose(j);
    }
    [[nodiscard]] double next(Slot i, double now) const {
        return stride_ < infinity ? now + world_.time_for(i, now, stride_) : infinity;
    }
    template <class Propose, class Touch>
    void own_event(Slot i, double, const Propose& propose, const Touch&) {
        near(i, propose);
    }

    /// So that events may be told late, and lengths of the box be counted.
    [[nodiscard]] double margin() const noexcept { return 0x1p-22 * stride_; }

    /// All pairs are no picture.
    void sketch(double, Sketch<D>&) const {}

 private:
    const World<D>& world_;
    double stride_ = world_.stride();
};

SIGNUM_LOOPS_OVER(Pairs)

}  // namespace signum::motion
