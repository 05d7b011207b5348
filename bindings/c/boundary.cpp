#include "boundary.hpp"

#include <limits>

#include "../../core/parallel.hpp"

namespace signum::c {

static_assert(sizeof(signum_error) == 256 && sizeof(signum_validation) == 256);

Asked asked(const signum_options* given) {
    const signum_options options = read(given, signum_options SIGNUM_OPTIONS, "options");
    if (options.threads < 0 || options.threads > most_threads)
        throw Refused("there are no " + std::to_string(options.threads) +
                      " threads to be had: 0 to " + std::to_string(most_threads));
    Asked asked;
    asked.weight_is = weight_of(options.weight_is);
    asked.options.arithmetic =
        enumerator(options.arithmetic, Arithmetic::multiprecision, "arithmetic");
    asked.options.method = enumerator(options.method, Method::sweep, "method");
    asked.options.seed = options.seed;
    asked.options.threads = options.threads;
    if (options.progress != nullptr)
        asked.options.progress = [progress = options.progress, user = options.user](double done) {
            if (progress(done, user) != 0) throw Stopped();
        };
    return asked;
}

ValidationOptions for_validation(const Asked& asked) {
    return {.stop = {}, .progress = asked.options.progress, .threads = asked.options.threads};
}

void expect_sites(const double* sites, std::int64_t count, std::int64_t stride,
                  std::int64_t least_stride, double largest, std::int64_t most) {
    expect_array(sites, count, "sites");
    if (count > most)
        throw Refused(std::to_string(count) + " sites are more than " + std::to_string(most));
    if (stride < least_stride || stride > std::numeric_limits<std::int32_t>::max())
        throw Refused("a stride of " + std::to_string(stride) + " doubles, where a site has " +
                      std::to_string(least_stride));
    const std::int64_t numbers = std::min(stride, least_stride + 1);
    for (std::int64_t i = 0; i < count; ++i)
        for (std::int64_t k = 0; k < numbers; ++k) {
            const double number = sites[i * stride + k];
            if (!std::isfinite(number))
                throw Refused("site " + std::to_string(i) + " is not finite", i);
            if (std::fabs(number) > largest)
                throw Refused("site " + std::to_string(i) + " is beyond single precision, 3.4e38",
                              i);
        }
}

}  // namespace signum::c

const char* signum_version(void) {
    return SIGNUM_VERSION;
}
int32_t signum_abi(void) {
    return SIGNUM_ABI;
}
