#pragma once
/// The ways in which a file fails us: its contents are wrong, or its name, or the machine is.

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace signum {

/// A place in a text file, both numbers from 1; columns count bytes, a byte order mark not
/// included.
struct Position {
    std::int64_t line = 1;
    std::int64_t column = 1;
};

/// What people are told. what() is the message as a terminal may show it: control characters, which
/// names of files and what a parser quotes may have, as \xNN, and of more than 1600 bytes, which a
/// name may have alone, the middle as "...".
class ShownError : public std::runtime_error {
 public:
    explicit ShownError(std::string_view message);
};

/// The input is wrong. what() is "FILE:LINE:COLUMN: what is wrong, and what would be right", or
/// "FILE: ..." where no line of it is wrong: it is not there, or it is a state that cannot be.
class InputError : public ShownError {
 public:
    InputError(std::string_view file, Position position, std::string_view message);
    InputError(std::string_view file, std::string_view message);
};

/// A result cannot have this name: there is no such directory, or the name is a directory's own.
class NameError : public ShownError {
 public:
    using ShownError::ShownError;
};

/// The machine failed: a full disk, a directory that cannot be written.
class MachineError : public ShownError {
 public:
    using ShownError::ShownError;
};

/// Whether a terminal may take some of the text for orders: bytes below a blank, DEL, and those
/// from 0x80 to 0x9F in UTF-8.
[[nodiscard]] bool has_control_character(std::string_view text);

/// Text from a file as an error message shows it: between quotes, unprintable bytes as \xNN, and
/// cut after 40 bytes.
[[nodiscard]] std::string in_quotes(std::string_view text);

}  // namespace signum
