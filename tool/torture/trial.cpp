#include "trial.hpp"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <new>
#include <numeric>
#include <optional>
#include <span>
#include <thread>

#include <fmt/format.h>

#include "../../core/contract.hpp"
#include "../../exact/floating_environment.hpp"
#include "../io/errors.hpp"

namespace signum::torture {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t most_families = 16;
constexpr std::size_t pixels = std::size_t{picture_side} * picture_side;

struct Smallest {
    int cost = 0;  ///< 0 where there is none
    Example example{};
};

/// What the processes share.
struct Shared {
    std::atomic<std::uint64_t> beats = 0;  ///< rises before each call
    std::atomic<bool> is_done = false;
    Question current{};
    std::size_t family = 0;
    std::uint64_t turn = 0;
    std::array<Convention, functions> conventions{};
    std::array<std::array<Count, most_families>, functions> counts{};
    std::array<Smallest, functions> smallest{};
    std::array<std::array<std::int8_t, pixels>, functions> said{};
};

class Memory {
 public:
    Memory() {
        void* const pages = ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE,
                                   MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        if (pages == MAP_FAILED)
            throw MachineError(fmt::format("no memory: {}", std::strerror(errno)));
        shared_ = new (pages) Shared;
    }
    Memory(const Memory&) = delete;
    Memory& operator=(const Memory&) = delete;
    ~Memory() { ::munmap(shared_, sizeof(Shared)); }
    [[nodiscard]] Shared& operator*() const noexcept { return *shared_; }

 private:
    Shared* shared_;
};

/// How a process ended.
struct End {
    bool is_done;
    int signal;  ///< where it is not: 0 for one that was stopped, as a call took too long
};

/// Work in a process of its own, which calls watched() before each call of the plugin.
template <class Work>
End guarded(Shared& shared, double patience, const Work& work) {
    shared.is_done = false;
    const pid_t child = ::fork();
    if (child < 0) throw MachineError(fmt::format("no process: {}", std::strerror(errno)));
    if (child == 0) {
        // What the tool does at such signals is not the plugin's.
        for (const int signal : {SIGINT, SIGTERM, SIGSEGV, SIGFPE, SIGABRT, SIGBUS, SIGILL})
            std::signal(signal, SIG_DFL);
        // What a plugin prints is no part of a report.
        ::dup2(STDERR_FILENO, STDOUT_FILENO);
        work();
        shared.is_done = true;
        ::_exit(0);
    }
    std::uint64_t beats = shared.beats;
    auto since = Clock::now();
    int status = 0;
    while (::waitpid(child, &status, WNOHANG) == 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        if (const std::uint64_t now = shared.beats; now != beats) {
            beats = now;
            since = Clock::now();
        } else if (std::chrono::duration<double>(Clock::now() - since).count() > patience) {
            ::kill(child, SIGKILL);
            ::waitpid(child, &status, 0);
            return {false, 0};
        }
    }
    if (shared.is_done) return {true, 0};
    // One that ends itself, by exit(), has no signal; that is as bad as abort().
    return {false, WIFSIGNALED(status) ? WTERMSIG(status) : SIGABRT};
}

double watched(const Plugin& plugin, Shared& shared, const Question& question) {
    shared.current = question;
    ++shared.beats;
    return plugin.ask(question);
}

/// In the default environment, whatever the plugin has left behind. Nothing where it is asked for
/// the inside of points on a line (in a plane).
std::optional<Sign> right_in(Convention convention, const Question& question) {
    const exact::IeeeEnvironment environment;
    Sign sign = exact_sign(question);
    if (convention == Convention::bounded || convention == Convention::bounded_opposite) {
        const Sign turn = exact_turn(question);
        if (turn == 0) return std::nullopt;
        sign *= turn;
    }
    const bool is_opposite =
        convention == Convention::opposite || convention == Convention::bounded_opposite;
    return is_opposite ? -sign : sign;
}
bool is_right(double said, std::optional<Sign> right) {
    return !right || (!std::isnan(said) && sign_of(said) == *right);
}

/// The convention in which all answers to clear questions are right.
Convention found_convention(const Plugin& plugin, Shared& shared, Asked asked) {
    Maker maker(1);
    std::vector<std::pair<Question, double>> answers;
    for (int k = 0; k < 64; ++k) {
        const Question question = maker.make_clear(asked);
        answers.emplace_back(question, watched(plugin, shared, question));
    }
    constexpr std::array all = {Convention::shewchuk, Convention::opposite, Convention::bounded,
                                Convention::bounded_opposite};
    // A turn has no inside.
    const bool has_inside = points_of(asked) == dimension_of(asked) + 2;
    for (const Convention each : std::span(all).first(has_inside ? 4 : 2))
        if (std::ranges::all_of(answers, [&](const auto& answer) {
                return is_right(answer.second, right_in(each, answer.first));
            }))
            return each;
    return Convention::unknown;
}

void ask(const Plugin& plugin, Shared& shared, const Question& question, std::size_t family) {
    const std::size_t function = place_of(question.asked);
    const Convention convention = shared.conventions[function];
    const double said = watched(plugin, shared, question);
    const std::optional<Sign> right = right_in(convention, question);
    if (!right) return;
    Count& count = shared.counts[function][family];
    ++count.asked;
    if (is_right(said, right)) return;
    ++count.wrong;
    count.not_a_number += std::isnan(said) ? 1 : 0;
    Smallest& smallest = shared.smallest[function];
    const int cost = cost_of(question);
    if (smallest.cost == 0 || cost < smallest.cost) smallest = {cost, {question, said, *right}};
}

/// Makes the example simpler as long as the plugin is wrong about it: numbers become 0, or lose
/// their last bits.
void simplify(const Plugin& plugin, Shared& shared, Asked asked) {
    Smallest& smallest = shared.smallest[place_of(asked)];
    if (smallest.cost == 0) return;
    const auto try_instead = [&](const Question& question) {
        const int cost = cost_of(question);
        if (cost >= smallest.cost) return false;
        const double said = watched(plugin, shared, question);
        const auto right = right_in(shared.conventions[place_of(asked)], question);
        if (is_right(said, right)) return false;
        smallest = {cost, {question, said, *right}};
        return true;
    };
    for (bool is_changed = true; is_changed;) {
        is_changed = false;
        for (std::size_t k = 0; k < smallest.example.question.size(); ++k) {
            for (int bits = 0; bits <= 53; ++bits) {
                Question question = smallest.example.question;
                double& number = question.numbers[k];
                int exponent = 0;
                const double fraction = std::frexp(number, &exponent);
                number = std::ldexp(std::nearbyint(std::ldexp(fraction, bits)), exponent - bits);
                if (!std::isfinite(number)) continue;
                if (try_instead(question)) {
                    is_changed = true;
                    break;
                }
            }
        }
    }
}

}  // namespace

std::string_view name_of(Convention convention) noexcept {
    constexpr std::array<std::string_view, 5> names = {
        "none that is known", "Shewchuk's", "Shewchuk's with the opposite sign",
        "positive inside, whichever way the points turn",
        "negative inside, whichever way the points turn"};
    return names[static_cast<std::size_t>(convention)];
}

std::uint64_t Trial::asked() const noexcept {
    return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0},
                           [](std::uint64_t sum, const Count& each) { return sum + each.asked; });
}
std::uint64_t Trial::wrong() const noexcept {
    return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0},
                           [](std::uint64_t sum, const Count& each) { return sum + each.wrong; });
}
bool Trial::is_faultless() const noexcept {
    return !is_there || (convention != Convention::unknown && wrong() == 0 && lost.empty());
}

Question question_of_picture(Asked asked, int column, int row) {
    const double x = 0.5 + 0x1p-53 * column;
    const double y = 0.5 + 0x1p-53 * row;
    Question question{asked, {}};
    if (asked == Asked::orient2d) {
        question.numbers = {x, y, 12.0, 12.0, 24.0, 24.0};
    } else {
        // The middle of the picture is the corner of a square.
        const double o = 0.5 + 0x1p-46;
        question.numbers = {24.5, o, 24.5, 24.5, o, 24.5, x, y};
    }
    return question;
}

std::array<Trial, functions> torture(const Plugin& plugin, const Options& options) {
    const Memory memory;
    Shared& shared = *memory;
    const std::size_t all_of_them = families().size();
    SIGNUM_EXPECTS(all_of_them <= most_families);
    std::array<Trial, functions> trials;
    // Families in which a call was lost are not asked again.
    std::array<std::array<bool, most_families>, functions> is_lost{};
    const auto lose = [&](const End& end, std::size_t family) {
        const std::size_t function = place_of(shared.current.asked);
        trials[function].lost.push_back({shared.current, family, end.signal});
        is_lost[function][family] = true;
    };
    for (const Asked asked : all_asked) {
        Trial& trial = trials[place_of(asked)];
        trial.is_there = plugin.has(asked);
        if (!trial.is_there) continue;
        const End end = guarded(shared, options.patience, [&] {
            shared.conventions[place_of(asked)] = found_convention(plugin, shared, asked);
        });
        if (!end.is_done) lose(end, 0);
        trial.convention = shared.conventions[place_of(asked)];
    }
    auto start = Clock::now();
    const auto share = [&] {
        return std::chrono::duration<double>(Clock::now() - start).count() / options.seconds;
    };
    while (share() < 1.0) {
        // As long as nothing is lost one process does it all.
        const auto rest = Clock::now() + std::chrono::duration<double>(
                                             std::min(1.0, options.seconds * (1.0 - share())));
        const End end = guarded(shared, options.patience, [&] {
            while (Clock::now() < rest) {
                const std::uint64_t turn = shared.turn++;
                const Asked asked = all_asked[turn % functions];
                const std::size_t family = turn / functions % all_of_them;
                if (!plugin.has(asked) || is_lost[place_of(asked)][family]) continue;
                Maker maker(options.seed + turn * 0x9E3779B97F4A7C15U, options.own);
                if (!maker.has(asked, family)) continue;
                shared.family = family;
                for (int k = 0; k < families()[family].in_a_row; ++k)
                    ask(plugin, shared, maker.make(asked, family), family);
            }
        });
        if (!end.is_done) {
            lose(end, shared.family);
            // What was waited in vain does not count.
            if (end.signal == 0)
                start += std::chrono::duration_cast<Clock::duration>(
                    std::chrono::duration<double>(options.patience));
        }
        if (options.progress) options.progress(std::min(1.0, share()));
    }
    for (const Asked asked : all_asked) {
        Trial& trial = trials[place_of(asked)];
        if (!trial.is_there) continue;
        static_cast<void>(
            guarded(shared, options.patience, [&] { simplify(plugin, shared, asked); }));
        const std::size_t function = place_of(asked);
        trial.counts.assign(
            shared.counts[function].begin(),
            shared.counts[function].begin() + static_cast<std::ptrdiff_t>(all_of_them));
        if (const Smallest& smallest = shared.smallest[function]; smallest.cost != 0)
            trial.smallest = smallest.example;
        if (dimension_of(asked) != 2) continue;
        const auto for_pixels = [&](const auto& put) {
            for (int row = 0; row < picture_side; ++row)
                for (int column = 0; column < picture_side; ++column)
                    put(question_of_picture(asked, column, row),
                        static_cast<std::size_t>(row * picture_side + column));
        };
        const End end = guarded(shared, options.patience, [&] {
            for_pixels([&](const Question& question, std::size_t at) {
                shared.said[function][at] =
                    static_cast<std::int8_t>(sign_of(watched(plugin, shared, question)));
            });
        });
        if (!end.is_done) continue;
        trial.said.assign(shared.said[function].begin(), shared.said[function].end());
        trial.right.resize(pixels);
        for_pixels([&](const Question& question, std::size_t at) {
            trial.right[at] = static_cast<std::int8_t>(right_in(trial.convention, question).value_or(0));
        });
    }
    return trials;
}

}  // namespace signum::torture
