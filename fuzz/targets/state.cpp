#include <sstream>

#include "../../tool/io/motion_state.hpp"

#include "memory_file.hpp"
#include "parsers.hpp"
#include "reading.hpp"

namespace signum::fuzz {
namespace {

template <int D>
std::string state_text(const MotionState<D>& state) {
    std::ostringstream text;
    write_motion_state(text, state);
    return text.str();
}

/// A state that can be is written so that it reads back to the same; one that cannot is refused.
template <int D>
void read_state(const std::string& path) {
    static_cast<void>(result_of(path, read_motion_state<D>));
    const auto state = result_of(path, checked_motion_state<D>);
    if (!state) return;
    const std::string text = state_text(*state);
    const MemoryFile copy(text);
    must(state_text(checked_motion_state<D>(copy.path())) == text,
         "a state that does not read back to the same");
}

}  // namespace

void read_state_target(Bytes bytes) {
    const MemoryFile file(bytes);
    const auto dimension = result_of(file.path(), dimension_of_motion_state);
    // One who asks for the other dimension is refused, too.
    read_state<2>(file.path());
    read_state<3>(file.path());
    must(!dimension || *dimension == 2 || *dimension == 3, "a state of neither dimension");
}

}  // namespace signum::fuzz
