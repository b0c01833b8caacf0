#include "modules/sick_bridge/core/parameters.h"

#include <bit>
#include <charconv>
#include <cstdio>

#include "common/bytes/big_endian.h"

namespace scanway::sick {
namespace {

std::string printed(const char* format, long long value) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// The value of all of `digits` in that base; throws when there is anything else in it.
std::uint64_t parse(std::string_view digits, int base) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
  if (error != std::errc{} || end != digits.data() + digits.size()) throw BadTelegram("a parameter is no number");
  return value;
}

}  // namespace

std::string_view ParameterReader::take(std::size_t length) {
  if (length > rest_.size()) throw BadTelegram("its parameters end too early");
  const std::string_view taken = rest_.substr(0, length);
  rest_.remove_prefix(length);
  return taken;
}

std::string_view ParameterReader::next_word() {
  const std::string_view word = take(std::min(rest_.find(' '), rest_.size()));
  if (word.empty()) throw BadTelegram("its parameters end too early");
  if (!rest_.empty()) rest_.remove_prefix(1);
  return word;
}

std::uint32_t ParameterReader::number(int size) {
  if (dialect_ == Dialect::cola_b) {
    std::uint32_t value = 0;
    for (const char byte : take(static_cast<std::size_t>(size))) value = value << 8 | static_cast<std::uint8_t>(byte);
    return value;
  }
  const std::string_view word = next_word();
  const std::uint64_t limit = std::uint64_t{1} << (8 * size);
  const bool signed_decimal = word[0] == '+' || word[0] == '-';
  const std::uint64_t value = signed_decimal ? parse(word.substr(1), 10) : parse(word, 16);
  if (value >= limit || (word[0] == '-' && value > limit / 2)) throw BadTelegram("a parameter is too large");
  return static_cast<std::uint32_t>(word[0] == '-' ? (limit - value) % limit : value);
}

float ParameterReader::f32() { return std::bit_cast<float>(u32()); }

std::uint16_t ParameterReader::bits() {
  const std::uint8_t low = u8();
  return static_cast<std::uint16_t>(low | u8() << 8);
}

std::string ParameterReader::word(std::size_t length) {
  const std::string_view taken = dialect_ == Dialect::cola_b ? take(length) : next_word();
  if (taken.size() != length) throw BadTelegram("a word of its parameters has the wrong length");
  return std::string(taken);
}

std::string ParameterReader::text(int length_size) {
  const std::size_t length = number(length_size);
  std::string taken(take(length));
  if (dialect_ == Dialect::cola_a && !rest_.empty()) {
    if (rest_[0] != ' ') throw BadTelegram("a text of its parameters is longer than it says");
    rest_.remove_prefix(1);
  }
  return taken;
}

bool ParameterReader::can_hold(std::size_t count, std::size_t size) const {
  return dialect_ == Dialect::cola_b ? count * size <= rest_.size() : 2 * count <= rest_.size() + 1;
}

ParameterWriter& ParameterWriter::put(std::int64_t value, int size, const std::string& ascii) {
  if (dialect_ == Dialect::cola_b) {
    append_big_endian(text_, static_cast<std::uint64_t>(value), size);
  } else {
    if (!text_.empty()) text_ += ' ';
    text_ += ascii;
  }
  return *this;
}

ParameterWriter& ParameterWriter::hex(std::int64_t value, int size) {
  const std::int64_t mask = (std::int64_t{1} << (8 * size)) - 1;
  return put(value, size, printed("%llX", value & mask));
}

ParameterWriter& ParameterWriter::byte(std::uint8_t value) { return put(value, 1, printed("%02llX", value)); }

ParameterWriter& ParameterWriter::decimal(std::int64_t value, int size) {
  return put(value, size, printed("%+lld", value));
}

ParameterWriter& ParameterWriter::f32(float value) {
  const auto image = std::bit_cast<std::uint32_t>(value);
  return put(image, 4, printed("%08llX", image));
}

ParameterWriter& ParameterWriter::bits(std::uint16_t value) {
  return byte(static_cast<std::uint8_t>(value & 0xFF)).byte(static_cast<std::uint8_t>(value >> 8));
}

}  // namespace scanway::sick
