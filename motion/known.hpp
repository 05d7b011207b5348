#pragma once
/// Which effects a loop is compiled for. The library's loops know all of them, and ask once a
/// strike whether any is on; a test compiles loops that do not know one, to see what asking costs.

namespace signum::motion {

struct Known {
    bool walls = true;  ///< but sides of a box at rest
    bool speed_law = true;
    bool contact_duration = true;
    bool friction = true;
    bool growth = true;
    bool time_steps = true;
    bool contacts = true;  ///< that stand; only where there are time steps
};

}  // namespace signum::motion
