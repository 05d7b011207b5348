#include "plugin.hpp"

#include <dlfcn.h>

#include <fmt/format.h>

#include "../io/errors.hpp"

namespace signum::torture {
namespace {

/// A copy of the points, for some functions take them as double*.
template <class Result>
double call(void* function, const Question& question) {
    Question copy = question;
    std::array<double*, 5> p;
    for (std::size_t m = 0; m < p.size(); ++m) p[m] = &copy.numbers[m * dimension_of(copy.asked)];
    using Three = Result(double*, double*, double*);
    using Four = Result(double*, double*, double*, double*);
    using Five = Result(double*, double*, double*, double*, double*);
    switch (points_of(copy.asked)) {
        case 3:
            return static_cast<double>(reinterpret_cast<Three*>(function)(p[0], p[1], p[2]));
        case 4:
            return static_cast<double>(reinterpret_cast<Four*>(function)(p[0], p[1], p[2], p[3]));
        default:
            return static_cast<double>(
                reinterpret_cast<Five*>(function)(p[0], p[1], p[2], p[3], p[4]));
    }
}

}  // namespace

Plugin::Plugin(const std::string& path, const std::array<std::string, functions>& names,
               const std::string& init, bool returns_int)
    : returns_int_(returns_int) {
    // Without a slash it would be looked for where the system has its libraries.
    const std::string file = path.find('/') == std::string::npos ? "./" + path : path;
    void* const library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr)
        throw InputError(path, fmt::format("is no shared library: {}", ::dlerror()));
    library_ = std::shared_ptr<void>(library, ::dlclose);
    bool has_any = false;
    for (const Asked asked : all_asked) {
        const std::string& given = names[place_of(asked)];
        const std::string name = given.empty() ? std::string(name_of(asked)) : given;
        calls_[place_of(asked)] = ::dlsym(library, name.c_str());
        if (!given.empty() && !has(asked))
            throw InputError(path, fmt::format("has no function {}", given));
        has_any |= has(asked);
    }
    if (!has_any)
        throw InputError(path,
                         "has none of the C functions orient2d, incircle, orient3d and insphere: "
                         "--orient2d NAME and so on say what they are called");
    // Shewchuk's wants no arguments, TetGen's these: no messages, exact, no static filter.
    void* const start = ::dlsym(library, init.empty() ? "exactinit" : init.c_str());
    if (start == nullptr && !init.empty())
        throw InputError(path, fmt::format("has no function {}", init));
    if (start != nullptr)
        reinterpret_cast<void (*)(int, int, int, double, double, double)>(start)(0, 0, 1, 1, 1, 1);
}

double Plugin::ask(const Question& question) const {
    void* const function = calls_[place_of(question.asked)];
    return returns_int_ ? call<int>(function, question) : call<double>(function, question);
}

}  // namespace signum::torture
