/// Writes the proofs of the filters' error bounds down, as scripts for gappa, and a table of their
/// margins. docs/proofs.md says what is proved and how.
///
///     proofs DIRECTORY

#include <cstdio>
#include <exception>

#include "filters.hpp"
#include "rounding.hpp"

int main(int argc, char** argv) {
    using namespace signum::proofs;
    if (argc != 2) {
        std::fputs("proofs DIRECTORY\n", stderr);
        return 2;
    }
    try {
        Scripts scripts(argv[1]);
        prove_rounding(scripts);
        std::puts("filter                     roundings   bound / what is proved");
        for (const Filter& filter : all_filters()) {
            const Margin margin = prove(scripts, filter);
            std::printf("%-28s %7.2f   %.4f\n", filter.name, margin.roundings, margin.spare);
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "proofs: %s\n", error.what());
        return 1;
    }
}
