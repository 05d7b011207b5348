/// Runs targets on files: what fuzzers found once must hold for ever.
///
///   fuzz_replay CORPUS             every file of CORPUS/TARGET/ for every target
///   fuzz_replay TARGET FILE...     these files; a folder stands for the files in it
///   fuzz_replay --growth TARGET FILE...
///       the time of each file made longer, by parts of it that are repeated: a time that grows
///       faster than its bytes ends the program, too

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "target.hpp"

namespace signum::fuzz {
namespace {

namespace fs = std::filesystem;

std::vector<std::uint8_t> bytes_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    must(in.good(), "a file that cannot be read");
    return {std::istreambuf_iterator<char>(in), {}};
}

/// The files in a folder, sorted, or the file itself.
std::vector<fs::path> files_at(const fs::path& path) {
    if (!fs::is_directory(path)) return {path};
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(path))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

/// The part [begin, end) of the bytes so often that there are `size` of them in all, or a few less.
std::vector<std::uint8_t> repeated(Bytes bytes, std::size_t begin, std::size_t end,
                                   std::size_t size) {
    std::vector<std::uint8_t> result(bytes.begin(),
                                     bytes.begin() + static_cast<std::ptrdiff_t>(end));
    const Bytes part = bytes.subspan(begin, end - begin);
    while (result.size() + part.size() + (bytes.size() - end) <= size)
        result.insert(result.end(), part.begin(), part.end());
    const Bytes rest = bytes.subspan(end);
    result.insert(result.end(), rest.begin(), rest.end());
    return result;
}

double seconds_of(const Target& target, Bytes bytes) {
    const std::clock_t start = std::clock();
    target.run(bytes);
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Four times the bytes take four times the time, or somewhat more; a square would be sixteen.
void judge_growth(const Target& target, Bytes bytes, std::size_t begin, std::size_t end) {
    constexpr std::size_t size = std::size_t{1} << 16;
    constexpr double too_short_to_tell = 0.04;
    constexpr double most = 9.0;
    const std::vector<std::uint8_t> small = repeated(bytes, begin, end, size);
    const std::vector<std::uint8_t> large = repeated(bytes, begin, end, 4 * size);
    double growth = 0.0;
    // Whatever else the machine did meanwhile it will not do each time.
    for (int attempt = 0; attempt < 4; ++attempt) {
        const double longer = seconds_of(target, large);
        if (longer < too_short_to_tell) return;
        growth = longer / std::max(seconds_of(target, small), 1e-6);
        if (growth <= most) return;
    }
    std::ofstream("growth.input", std::ios::binary)
        .write(reinterpret_cast<const char*>(large.data()),
               static_cast<std::streamsize>(large.size()));
    std::printf("bytes %zu to %zu repeated: %.1f times the time (growth.input)\n", begin, end,
                growth);
    must(false, "it takes longer than is linear");
}

/// Each line, each two lines, and each eighth is repeated in turn.
void judge_growth(const Target& target, Bytes bytes) {
    constexpr std::size_t most_parts = 24;
    std::vector<std::size_t> cuts = {0};
    for (std::size_t i = 0; i < bytes.size(); ++i)
        if (bytes[i] == '\n' && cuts.size() < most_parts) cuts.push_back(i + 1);
    for (std::size_t i = 1; i <= 8; ++i) cuts.push_back(i * bytes.size() / 8);
    std::ranges::sort(cuts);
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        judge_growth(target, bytes, cuts[i], cuts[i + 1]);
        if (i + 2 < cuts.size()) judge_growth(target, bytes, cuts[i], cuts[i + 2]);
    }
}

void replay(const Target& target, const fs::path& path, bool of_growth) {
    for (const fs::path& file : files_at(path)) {
        // The last one that is named is the one at which the program ended.
        std::printf("%s %s\n", std::string(target.name).c_str(), file.c_str());
        std::fflush(stdout);
        const std::vector<std::uint8_t> bytes = bytes_of(file);
        if (of_growth && !bytes.empty())
            judge_growth(target, bytes);
        else
            run_in_time(target, bytes);
    }
}

/// Every target has a folder, and every folder a target.
void replay_corpus(const fs::path& corpus) {
    for (const Target& target : all_targets()) {
        const fs::path folder = corpus / target.name;
        must(fs::is_directory(folder) && !files_at(folder).empty(), "a target without a corpus");
        replay(target, folder, false);
    }
    for (const auto& entry : fs::directory_iterator(corpus))
        static_cast<void>(target_named(entry.path().filename().string()));
}

}  // namespace
}  // namespace signum::fuzz

int main(int count, char** words) {
    using namespace signum::fuzz;
    std::vector<std::string> rest(words + 1, words + count);
    const bool of_growth = !rest.empty() && rest.front() == "--growth";
    if (of_growth) rest.erase(rest.begin());
    if (rest.size() == 1 && !of_growth) {
        replay_corpus(rest.front());
        return 0;
    }
    must(rest.size() >= 2, "fuzz_replay CORPUS, or fuzz_replay [--growth] TARGET FILE...");
    const Target& target = target_named(rest.front());
    for (std::size_t i = 1; i < rest.size(); ++i) replay(target, rest[i], of_growth);
    return 0;
}
