/// Writes the proofs of the filters' error bounds down, as scripts for gappa, and a table of their
/// margins. docs/proofs.md says what is proved and how.
///
///     proofs DIRECTORY

#include <cstdio>
#include <exception>

#include "conflict.hpp"
#include "filters.hpp"
#include "laws.hpp"
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
        prove_double_doubles(scripts);
        std::puts("filter                     roundings   bound / what is proved");
        const auto print = [](const char* name, const Margin& margin) {
            std::printf("%-28s %7.2f   %.4f\n", name, margin.roundings, margin.spare);
        };
        for (const Filter& filter : all_filters()) print(filter.name, prove(scripts, filter));
        for (const auto evaluate : {euclidean_in_circle, euclidean_in_circle_infinite}) {
            Notes notes;
            notes.size_of_atom = size_in_euclidean;
            const RootedConflict conflict = evaluated(scripts, notes, evaluate);
            print(conflict.name, prove(scripts, conflict));
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "proofs: %s\n", error.what());
        return 1;
    }
}
