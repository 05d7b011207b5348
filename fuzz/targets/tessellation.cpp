#include <sstream>
#include <stdexcept>
#include <vector>

#include "../../tool/io/read_sites.hpp"
#include "../../tool/io/read_tessellation.hpp"
#include "../../tool/io/write_tessellation.hpp"
#include "../../triangulation/space/validate.hpp"
#include "../../triangulation/validate.hpp"

#include "memory_file.hpp"
#include "parsers.hpp"
#include "reading.hpp"

namespace signum::fuzz {
namespace {

constexpr std::int64_t most_judged = 64;

/// Of a grid, so that many a tessellation is right about ties.
template <class S>
std::vector<S> grid_sites(std::int64_t count) {
    std::vector<S> sites;
    for (std::int64_t i = 0; i < count; ++i) {
        S site;
        site.x = static_cast<double>(i % 3);
        site.y = static_cast<double>(i / 3 % 3);
        if constexpr (requires { site.z; }) site.z = static_cast<double>(i / 9);
        site.r = i % 7 == 3 ? 1.5 : 0.0;
        sites.push_back(site);
    }
    return sites;
}

void judge_verdict(const Validation& verdict) {
    must(verdict.canonical <= verdict.valid, "canonical and not valid");
    must(verdict.canonical == verdict.message.empty(), "a verdict without a reason");
}

/// What names no site or face cannot be a Tessellation, nor be written.
void judge_writing(const TessellationArrays& arrays, const std::vector<Site>& sites) {
    std::ostringstream text;
    try {
        write_json(text, Tessellation(arrays, sites, {}));
    } catch (const std::invalid_argument&) {
        return;
    }
    const MemoryFile copy(text.str());
    must(read_tessellation(copy.path()).arrays == arrays,
         "a tessellation of the plane that does not read back to the same");
}

/// Whatever the arrays hold, they are judged.
void judge_arrays(const TessellationArrays& arrays) {
    if (arrays.sites > most_judged) return;
    const std::vector<Site> sites = grid_sites<Site>(arrays.sites);
    judge_writing(arrays, sites);
    if (arrays.weight_is == WeightIs::weight && arrays.metric != Metric::power) return;
    judge_verdict(validate(arrays, strided_view(sites, arrays.weight_is)));
}

void judge_in_space(const ReadTessellation& read) {
    std::ostringstream text;
    write_json(text, *read.in_space, read.arrays.metric, read.arrays.weight_is);
    const MemoryFile copy(text.str());
    const ReadTessellation again = read_tessellation(copy.path());
    must(again.in_space == read.in_space && again.arrays == read.arrays,
         "a tessellation of space that does not read back to the same");
    if (read.in_space->sites > most_judged) return;
    const std::vector<Site3> sites = grid_sites<Site3>(read.in_space->sites);
    judge_verdict(validate(*read.in_space, sites));
}

}  // namespace

void read_tessellation_target(Bytes bytes) {
    const MemoryFile file(bytes);
    const auto read = result_of(file.path(), read_tessellation);
    if (!read) return;
    if (read->in_space)
        judge_in_space(*read);
    else
        judge_arrays(read->arrays);
}

}  // namespace signum::fuzz
