#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace scanway {

/// Walks over the lines of a text and counts them. Line ends are \n or \r\n.
class TextLines {
 public:
  /// `lines_before`: lines of the file that stand before `text`.
  explicit TextLines(std::string_view text, std::size_t lines_before = 0) : rest_(text), number_(lines_before) {}

  /// The next line without its end; nothing at the end of the text.
  std::optional<std::string_view> next();
  /// Number in the file of the line that next() gave last, from 1.
  std::size_t number() const { return number_; }
  /// What follows the line that next() gave last.
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
  std::size_t number_;
};

/// Takes the first token off `line`, ended by blanks; empty when there is none.
std::string_view take_token(std::string_view& line);

bool is_blank(std::string_view line);

/// How many tokens `line` has.
std::size_t count_tokens(std::string_view line);

/// A number, in the notation of C whatever the locale; nan and inf are numbers. Nothing if `token` is anything else.
std::optional<double> parse_number(std::string_view token);

/// A count: digits alone, below 2^64.
std::optional<std::uint64_t> parse_count(std::string_view token);

}  // namespace scanway
