#pragma once
/// What a reader says of a file that it refuses.

#include <algorithm>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "../../tool/io/errors.hpp"
#include "io_scratch.hpp"

namespace signum::test {

/// The message of read(path) for a file of these contents, without the path in front of it, which
/// must be there; "no error" where there is none.
template <class Read>
[[nodiscard]] std::string refusal(std::string_view contents, const Read& read) {
    const Scratch scratch;
    const std::string path = scratch.file("f", contents);
    try {
        static_cast<void>(read(path));
    } catch (const InputError& error) {
        const std::string message = error.what();
        EXPECT_TRUE(message.starts_with(path + ":")) << message;
        return message.substr(std::min(path.size() + 1, message.size()));
    }
    return "no error";
}

}  // namespace signum::test
