#include "write_motion.hpp"

#include <ostream>

namespace signum {

LogWriter::LogWriter(std::ostream& out) : text_(out) {
    text_.put("time,kind,a,b,impulse\n");
}

void LogWriter::put(const motion::Strike& strike) {
    text_.put(FMT_COMPILE("{},{},{},{},{}\n"), strike.time, strike.wall ? "wall" : "ball", strike.a,
              strike.b, strike.impulse);
}

void write_closest(std::ostream& out, std::span<const motion::ClosestPair> list) {
    TextWriter text(out);
    text.put("time,a,b,gap\n");
    for (const motion::ClosestPair& pair : list)
        text.put(FMT_COMPILE("{},{},{},{}\n"), pair.time, pair.a, pair.b, pair.gap);
    text.flush();
}

void write_xyz(std::ostream& out, const MotionFrame& frame) {
    TextWriter text(out);
    const std::array<double, 3>& low = frame.low;
    const std::array<double, 3>& high = frame.high;
    const char* const goes_around = frame.periodic ? "T" : "F";
    // A cell needs a height, in the plane too.
    const double height = frame.dimension == 3 ? high[2] - low[2] : 1.0;
    text.put(
        FMT_COMPILE("{}\nLattice=\"{} 0 0 0 {} 0 0 0 {}\" Origin=\"{} {} {}\" pbc=\"{} {} {}\" "
                    "Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1:id:I:1 Time={}\n"),
        frame.balls.size(), high[0] - low[0], high[1] - low[1], height, low[0], low[1], low[2],
        goes_around, goes_around, frame.dimension == 3 ? goes_around : "F", frame.time);
    std::size_t number = 0;
    for (const MotionFrame::Ball& ball : frame.balls) {
        text.put(FMT_COMPILE("A {} {} {} {} {} {} {} {}\n"), ball.x[0], ball.x[1], ball.x[2],
                 ball.v[0], ball.v[1], ball.v[2], ball.radius, number++);
    }
    text.flush();
}

}  // namespace signum
