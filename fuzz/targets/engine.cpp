/// One target, as libFuzzer and AFL++ call it.

#include <cstddef>
#include <cstdint>

#include "target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const signum::fuzz::Target& target = signum::fuzz::target_named(SIGNUM_FUZZ_TARGET);
    signum::fuzz::run_in_time(target, {data, size});
    return 0;
}
