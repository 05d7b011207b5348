/// Writes what is expected of hard cases, from the oracles alone.
///
///     make_hard_cases FILE...            writes it into each file, in place of what stands there
///     make_hard_cases --check FILE...    says where a file has something else; exit code 1

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>

#include "oracle_of_motion.hpp"
#include "oracle_of_plane.hpp"
#include "oracle_of_space.hpp"

namespace signum::hard {
namespace {

Lines expected_of(const Case& given) {
    if (given.kind == "plane")
        return plane_answers(
            given,
            [](const char* metric, const std::vector<Site>& sites) {
                return std::make_unique<OracleOfPlane>(metric, sites);
            },
            exact_turn);
    if (given.kind == "space")
        return space_answers(given, [](const std::vector<Site3>& sites) {
            return std::make_unique<OracleOfSpace>(sites);
        });
    if (given.kind == "motion")
        return motion_answers<2>(given,
                                 [](const auto&... all) { return OracleOfMotion<2>(all...); });
    return motion_answers<3>(given, [](const auto&... all) { return OracleOfMotion<3>(all...); });
}

/// Beside the file first, then in its place.
void write(const Case& given, const Lines& expected, const std::string& path) {
    const std::string beside = path + ".new";
    {
        std::ofstream file(beside);
        file << given.given;
        for (const std::string& line : expected) file << line << "\n";
        if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
    }
    std::filesystem::rename(beside, path);
}

}  // namespace
}  // namespace signum::hard

int main(int count, char** words) {
    using namespace signum::hard;
    const bool is_check = count > 1 && std::string(words[1]) == "--check";
    bool agree = true;
    try {
        for (int i = is_check ? 2 : 1; i < count; ++i) {
            const Case given = read_case(words[i]);
            const Lines expected = expected_of(given);
            if (!is_check) {
                write(given, expected, words[i]);
            } else if (expected != given.expected) {
                std::cerr << words[i] << ": the oracles say otherwise\n";
                agree = false;
            }
        }
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 2;
    }
    return agree ? 0 : 1;
}
