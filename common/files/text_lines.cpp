#include "common/files/text_lines.h"

#include <charconv>
#include <limits>
#include <system_error>

namespace scanway {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f'; }

/// from_chars does not say on which side a number is out of range.
double out_of_range(std::string_view token) {
  const bool tiny = token.find("e-") != token.npos || token.find("E-") != token.npos;
  const double magnitude = tiny ? 0.0 : std::numeric_limits<double>::infinity();
  return token.front() == '-' ? -magnitude : magnitude;
}

}  // namespace

std::optional<std::string_view> TextLines::next() {
  if (rest_.empty()) return std::nullopt;
  const std::size_t end = rest_.find('\n');
  std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(end == rest_.npos ? rest_.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  ++number_;
  return line;
}

std::string_view take_token(std::string_view& line) {
  std::size_t begin = 0;
  while (begin < line.size() && is_blank(line[begin])) ++begin;
  std::size_t end = begin;
  while (end < line.size() && !is_blank(line[end])) ++end;
  const std::string_view token = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return token;
}

bool is_blank(std::string_view line) { return take_token(line).empty(); }

std::size_t count_tokens(std::string_view line) {
  std::size_t count = 0;
  while (!take_token(line).empty()) ++count;
  return count;
}

std::optional<double> parse_number(std::string_view token) {
  if (token.starts_with('+') && !token.starts_with("+-")) token.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (end != token.data() + token.size() || token.empty()) return std::nullopt;
  if (error == std::errc::result_out_of_range) return out_of_range(token);
  return error == std::errc() ? std::optional(value) : std::nullopt;
}

std::optional<std::uint64_t> parse_count(std::string_view token) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  const bool good = error == std::errc() && !token.empty() && end == token.data() + token.size();
  return good ? std::optional(value) : std::nullopt;
}

}  // namespace scanway
