#include "peer_run.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <fstream>
#include <set>
#include <utility>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include "../predicates/ccw.hpp"

namespace signum::benchmarks {
namespace {

/// Triangles in any orientation turned counterclockwise, those at infinity added.
std::vector<Face> closed(std::vector<Face> triangles, const std::vector<Site>& sites) {
    std::set<std::pair<Index, Index>> sides;
    for (Face& face : triangles) {
        const auto site = [&](std::size_t k) { return sites[static_cast<std::size_t>(face[k])]; };
        if (ccw(site(0), site(1), site(2)) < 0) std::swap(face[1], face[2]);
        for (std::size_t k = 0; k < 3; ++k) sides.emplace(face[k], face[(k + 1) % 3]);
    }
    for (const auto& [a, b] : sides)
        if (!sides.contains({b, a})) triangles.push_back({infinite, b, a});
    return triangles;
}

/// The peak of this program alone; getrusage() would count what was there before exec().
double peak_resident_bytes() {
    std::ifstream status("/proc/self/status");
    double kilobytes = 0.0;
    for (std::string word; status >> word;)
        if (word == "VmHWM:") status >> kilobytes;
    return 1024.0 * kilobytes;
}

/// All of it, through a pipe.
bool put(std::FILE* end, const void* data, std::size_t size) {
    return std::fwrite(data, 1, size, end) == size;
}
bool take(std::FILE* end, void* data, std::size_t size) {
    return std::fread(data, 1, size, end) == size;
}
bool put_faces(std::FILE* end, const std::vector<Face>& faces) {
    const auto count = static_cast<double>(faces.size());
    return put(end, &count, sizeof count) && put(end, faces.data(), faces.size() * sizeof(Face));
}
bool take_faces(std::FILE* end, std::vector<Face>& faces) {
    double count = 0.0;
    if (!take(end, &count, sizeof count) || !(count >= 0.0 && count < 1e9)) return false;
    faces.resize(static_cast<std::size_t>(count));
    return take(end, faces.data(), faces.size() * sizeof(Face));
}

}  // namespace

int attempt(const Prepare& prepare) {
    std::vector<Site> sites;
    for (Site site; take(stdin, &site, sizeof site);) sites.push_back(site);
    try {
        const Construction construct = prepare(sites);
        const double before = peak_resident_bytes();
        const auto start = std::chrono::steady_clock::now();
        const Built built = construct();
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        const double peak = peak_resident_bytes() - before;
        std::vector<Face> faces;
        std::vector<Face> neighbours;
        built.write(faces, neighbours);
        const bool sent = put(stdout, &seconds, sizeof seconds) &&
                          put(stdout, &peak, sizeof peak) && put_faces(stdout, faces) &&
                          put_faces(stdout, neighbours) && std::fflush(stdout) == 0;
        return sent ? 0 : 1;
    } catch (const std::exception& failure) {
        fmt::print(stderr, "{}\n", failure.what());
        return 1;
    }
}

std::optional<Outcome> run(const std::vector<std::string>& command,
                           const std::vector<Site>& sites) {
    int input[2];
    int output[2];
    if (pipe(input) != 0 || pipe(output) != 0) return std::nullopt;
    const pid_t child = fork();
    if (child < 0) return std::nullopt;
    if (child == 0) {
        dup2(input[0], 0);
        dup2(output[1], 1);
        for (const int end : {input[0], input[1], output[0], output[1]}) close(end);
        std::vector<char*> words;
        for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
        words.push_back(nullptr);
        // Both outlive exec(): no peer runs on when this one is stopped, or without end.
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        alarm(most_seconds);
        execv(words[0], words.data());
        _exit(1);
    }
    close(input[0]);
    close(output[1]);
    static_assert(sizeof(Site) == 3 * sizeof(double));
    std::FILE* const to = fdopen(input[1], "w");
    std::FILE* const from = fdopen(output[0], "r");
    bool complete = put(to, sites.data(), sites.size() * sizeof(Site));
    complete &= std::fclose(to) == 0;
    Outcome outcome;
    complete = complete && take(from, &outcome.seconds, sizeof outcome.seconds) &&
               take(from, &outcome.peak_bytes, sizeof outcome.peak_bytes) &&
               take_faces(from, outcome.faces) && take_faces(from, outcome.neighbours);
    std::fclose(from);
    waitpid(child, nullptr, 0);
    if (!complete) return std::nullopt;
    const bool has_infinite =
        std::any_of(outcome.faces.begin(), outcome.faces.end(), [](const Face& face) {
            return std::find(face.begin(), face.end(), infinite) != face.end();
        });
    if (!has_infinite) outcome.faces = closed(std::move(outcome.faces), sites);
    return outcome;
}

}  // namespace signum::benchmarks
