/// signum: the tool. Parses the call, runs a subcommand, and turns every way to fail into one line
/// on standard error and an exit code.

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <string_view>

#include "../../exact/floating_environment.hpp"
#include "../io/errors.hpp"
#include "../io/number.hpp"
#include "../io/output_file.hpp"

#include "commands.hpp"
#include "interrupt.hpp"
#include "outputs.hpp"

namespace signum::cli {
namespace {

extern "C" void die_clean(int signal) {
    remove_unfinished_files();
    // The handler is reset (SA_RESETHAND), so that the shell sees the signal.
    ::raise(signal);
}

/// A signal that ends the program takes its unfinished files along; a file that grows beyond the
/// limit of the shell is an error of writing, not a signal.
void install_handlers() {
    struct sigaction before = {};
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE})
        handle_once(signal, die_clean, before);
    ::signal(SIGXFSZ, SIG_IGN);
}

/// A standard stream that is closed must not become the next file that is opened. The null devices
/// are opened the wrong way round: using them fails, as it would without them.
void occupy_standard_streams() {
    for (int descriptor = 0; descriptor < 3; ++descriptor) {
        if (::fcntl(descriptor, F_GETFD) < 0) {
            // The lowest free number is this one.
            static_cast<void>(::open("/dev/null", descriptor == 0 ? O_WRONLY : O_RDONLY));
        }
    }
}

int report(const char* message, ExitCode code) noexcept {
    std::fprintf(stderr, "signum: %s\n", message);
    return code;
}

/// Help and version are no errors.
int report_parse_error(const CLI::App& tool, const CLI::ParseError& error, const char* first_word) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
        const bool is_version = error.get_name() == "CallForVersion";
        const std::string text = is_version ? error.what() : tool.help();
        print(is_version || !text.ends_with('\n') ? text + "\n" : text);
        return done;
    }
    if (first_word == nullptr) {
        std::fputs(tool.help().c_str(), stderr);
        return wrong_input;
    }
    return report(explain_parse_error(tool, error, first_word).c_str(), wrong_input);
}

/// --quiet=no would be taken for a number of times that --quiet stands there.
void refuse_values_of_flags(CLI::App& tool) {
    for (CLI::App* command : tool.get_subcommands([](CLI::App*) { return true; })) {
        for (CLI::Option* option : command->get_options()) {
            if (option->get_items_expected_max() == 0) option->disable_flag_override();
        }
    }
}

bool is_meant_as_number(std::string_view word) {
    const NumberFault fault = parse_number(word).fault;
    return fault == NumberFault::not_finite || fault == NumberFault::out_of_range;
}

/// An option of several numbers takes as many words as numbers follow it, if they can be its own,
/// so that it does not take FILE, too. What is meant as a number and is none, as nan is, counts:
/// its check refuses it. Between the numbers of the plane and those of space, a word is taken for
/// one that was meant to follow.
void expect_given_numbers(CLI::App& tool, int count, char** words) {
    const CLI::Validator number = finite_number();
    for (CLI::App* command : tool.get_subcommands([](CLI::App*) { return true; })) {
        for (CLI::Option* option : command->get_options()) {
            const int least = option->get_items_expected_min();
            const int most = option->get_items_expected_max();
            if (least < 2) continue;
            char** const end = words + count;
            char** const first = std::find(words, end, option->get_name());
            int numbers = 0;
            while (first != end && first + 1 + numbers != end &&
                   number(std::string(first[1 + numbers])).empty())
                ++numbers;
            const bool is_number_meant = numbers < most && first != end &&
                                         first + 1 + numbers != end &&
                                         is_meant_as_number(first[1 + numbers]);
            if (is_number_meant) ++numbers;
            const bool is_whole = numbers == least || numbers == most || is_number_meant;
            if (least <= numbers && is_whole) option->expected(numbers)->allow_extra_args(false);
        }
    }
}

int run(int count, char** words) {
    CLI::App tool("Signs that are right, and the tessellations built on them", "signum");
    tool.set_version_flag("--version", "signum " SIGNUM_VERSION);
    tool.require_subcommand(1);
    tool.footer(
        "signum SUBCOMMAND --help says more.\n\n"
        "Example:\n"
        "  signum generate random -n 100 --radius 1:30 -o sites.txt\n"
        "  signum triangulate sites.txt --metric supremum -o out.svg");
    add_triangulate(tool);
    add_voronoi(tool);
    add_compare(tool);
    add_sign(tool);
    add_generate(tool);
    add_validate(tool);
    add_study(tool);
    add_simulate(tool);
    add_torture(tool);
    refuse_values_of_flags(tool);
    expect_given_numbers(tool, count, words);
    try {
        tool.parse(count, words);
        return done;
    } catch (const CLI::ParseError& error) {
        return report_parse_error(tool, error, count > 1 ? words[1] : nullptr);
    }
}

int run_and_report(int count, char** words) noexcept {
    try {
        return run(count, words);
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return wrong_input;
    } catch (const CallError& error) {
        return report(error.what(), wrong_input);
    } catch (const NameError& error) {
        return report(error.what(), wrong_input);
    } catch (const CheckFailure& error) {
        return report(error.what(), check_failed);
    } catch (const MachineError& error) {
        return report(error.what(), machine_failed);
    } catch (const std::bad_alloc&) {
        return report("not enough memory", machine_failed);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "signum: this should not happen, please report it: %s\n",
                     error.what());
        return machine_failed;
    }
}

}  // namespace
}  // namespace signum::cli

int main(int count, char** words) {
    // A library that is loaded before, and was linked with fast-math, has denormals flushed.
    const signum::exact::IeeeEnvironment environment;
    signum::cli::occupy_standard_streams();
    signum::cli::install_handlers();
    return signum::cli::run_and_report(count, words);
}
