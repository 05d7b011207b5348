#pragma once
/// JSON as a stream of events that know their place: no document is built, and every error has a
/// line and a column.
///
/// Laws:
///  1. Memory is bounded: a token longer than InputFile::longest_line is an InputError.
///  2. An event that a reader does not expect is an InputError at its place.

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "input_file.hpp"

namespace signum {

/// Hands out the bytes of a file one by one and remembers where the last token started.
class JsonCursor {
 public:
    explicit JsonCursor(InputFile& file) : file_(file), block_(file.next_block()) {}

    [[nodiscard]] bool at_end() const noexcept { return next_ == block_.size(); }
    /// Precondition: !at_end().
    [[nodiscard]] char current() const noexcept { return block_[next_]; }
    /// Precondition: !at_end().
    void advance();

    [[nodiscard]] InputFile& file() const noexcept { return file_; }
    /// Of the byte that comes next.
    [[nodiscard]] Position position() const noexcept { return position_; }
    /// Of the last of []{},: that was read.
    [[nodiscard]] Position structure() const noexcept { return structure_; }
    /// Of the first byte of the last string, number or word that was read, or is being read.
    [[nodiscard]] Position value() const noexcept { return value_; }
    /// The first bytes of it.
    [[nodiscard]] const std::string& value_text() const noexcept { return value_text_; }
    [[nodiscard]] bool is_in_value() const noexcept { return value_size_ > 0; }
    [[nodiscard]] bool is_in_string() const noexcept { return in_string_; }

 private:
    InputFile& file_;
    std::string_view block_;
    std::size_t next_ = 0;
    Position position_;
    Position structure_;
    Position value_;
    std::string value_text_;
    std::size_t value_size_ = 0;  ///< bytes read of the value that is being read; 0 between values
    bool in_string_ = false;
    bool escaped_ = false;
};

/// The iterator over a cursor that the parser wants.
class JsonIterator {
 public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = char;

    JsonIterator() = default;  ///< the end
    explicit JsonIterator(JsonCursor& cursor) : cursor_(&cursor) {}
    char operator*() const noexcept { return cursor_->current(); }
    JsonIterator& operator++() {
        cursor_->advance();
        return *this;
    }
    void operator++(int) { cursor_->advance(); }
    friend bool operator==(const JsonIterator& a, const JsonIterator& b) noexcept {
        return a.is_at_end() == b.is_at_end();
    }

 private:
    [[nodiscard]] bool is_at_end() const noexcept {
        return cursor_ == nullptr || cursor_->at_end();
    }
    JsonCursor* cursor_ = nullptr;
};

/// What a reader of JSON overrides; each event stops with an error unless it is expected.
class JsonEvents : public nlohmann::json_sax<nlohmann::json> {
 public:
    /// `expected` says what the file should hold, as the end of an error message.
    JsonEvents(InputFile& file, std::string expected)
        : cursor_(file), expected_(std::move(expected)) {}

    /// Reads the whole file.
    void parse();

    bool null() override { fail_at_value("null cannot stand here"); }
    bool boolean(bool value) override {
        fail_at_value(value ? "true cannot stand here" : "false cannot stand here");
    }
    bool number_integer(std::int64_t /*value*/) override {
        fail_at_value("a number cannot stand here");
    }
    bool number_unsigned(std::uint64_t /*value*/) override {
        fail_at_value("a number cannot stand here");
    }
    bool number_float(double /*value*/, const std::string& /*text*/) override {
        fail_at_value("a number");
    }
    bool string(std::string& /*text*/) override { fail_at_value("a string cannot stand here"); }
    bool binary(nlohmann::json::binary_t& /*value*/) override {
        fail_at_value("binary data cannot stand here");
    }
    bool start_object(std::size_t /*size*/) override {
        fail_at_structure("an object cannot stand here");
    }
    bool key(std::string& /*text*/) override { fail_at_value("a key cannot stand here"); }
    bool end_object() override { fail_at_structure("the end of an object cannot stand here"); }
    bool start_array(std::size_t /*size*/) override {
        fail_at_structure("an array cannot stand here");
    }
    bool end_array() override { fail_at_structure("the end of an array cannot stand here"); }
    bool parse_error(std::size_t position, const std::string& last_token,
                     const nlohmann::detail::exception& error) final;

 protected:
    [[nodiscard]] const JsonCursor& cursor() const noexcept { return cursor_; }
    /// "`what` is wrong; `expected`" at a place of the file.
    [[noreturn]] void fail(Position position, std::string_view what) const;
    [[noreturn]] void fail_at_value(std::string_view what) const { fail(cursor_.value(), what); }
    [[noreturn]] void fail_at_structure(std::string_view what) const {
        fail(cursor_.structure(), what);
    }

 private:
    JsonCursor cursor_;
    std::string expected_;
};

}  // namespace signum
