#pragma once
/// Somebody's predicates in a shared library, under Shewchuk's names or others.

#include <array>
#include <memory>
#include <string>

#include "questions.hpp"

namespace signum::torture {

/// Loads the library; a function that it does not have is not asked.
class Plugin {
 public:
    /// `names`: of the four functions, empty for Shewchuk's own. `returns_int`: they return int and
    /// not double. Throws InputError where the library does not load, lacks a name that was given,
    /// or has none of the four.
    /// `init` is called first, where it is there; empty for exactinit.
    Plugin(const std::string& path, const std::array<std::string, functions>& names,
           const std::string& init, bool returns_int);

    [[nodiscard]] bool has(Asked asked) const noexcept {
        return calls_[place_of(asked)] != nullptr;
    }
    /// May do whatever the plugin does: crash, or never return.
    [[nodiscard]] double ask(const Question& question) const;

 private:
    std::shared_ptr<void> library_;
    std::array<void*, functions> calls_ = {};
    bool returns_int_;
};

}  // namespace signum::torture
