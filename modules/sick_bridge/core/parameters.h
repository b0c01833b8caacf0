#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "modules/sick_bridge/core/cola.h"

namespace scanway::sick {

/// Reads the parameters of a telegram, one after the other, the same way in both dialects: big endian bytes in CoLa-B;
/// words between single blanks in CoLa-A, hexadecimal, or decimal where they begin with a sign. Everything throws
/// BadTelegram when the next parameter is missing or does not fit its type.
class ParameterReader {
 public:
  ParameterReader(Dialect dialect, std::string_view parameters) : dialect_(dialect), rest_(parameters) {}
  explicit ParameterReader(const Telegram& telegram) : ParameterReader(telegram.dialect, telegram.parameters) {}

  std::uint8_t u8() { return static_cast<std::uint8_t>(number(1)); }
  std::uint16_t u16() { return static_cast<std::uint16_t>(number(2)); }
  std::uint32_t u32() { return number(4); }
  std::int16_t i16() { return static_cast<std::int16_t>(u16()); }
  std::int32_t i32() { return static_cast<std::int32_t>(u32()); }
  float f32();
  /// Two bytes that stand for one bit field, the low byte first.
  std::uint16_t bits();
  /// `length` characters (CoLa-B), or a word of as many (CoLa-A).
  std::string word(std::size_t length);
  /// A string after its length, which takes `length_size` bytes in CoLa-B.
  std::string text(int length_size);

  bool at_end() const { return rest_.empty(); }
  std::string_view rest() const { return rest_; }
  Dialect dialect() const { return dialect_; }
  /// Whether `count` more values of `size` bytes can possibly follow.
  bool can_hold(std::size_t count, std::size_t size) const;

 private:
  std::uint32_t number(int size);
  std::string_view take(std::size_t length);
  std::string_view next_word();

  Dialect dialect_;
  std::string_view rest_;
};

/// Writes the parameters of a request in one dialect.
class ParameterWriter {
 public:
  explicit ParameterWriter(Dialect dialect) : dialect_(dialect) {}

  /// A number of `size` bytes; hexadecimal without leading zeros in CoLa-A.
  ParameterWriter& hex(std::int64_t value, int size);
  /// The same with two digits in CoLa-A, as SICK writes levels and the bytes of bit fields.
  ParameterWriter& byte(std::uint8_t value);
  /// The same, decimal with a sign in CoLa-A.
  ParameterWriter& decimal(std::int64_t value, int size);
  ParameterWriter& f32(float value);
  ParameterWriter& bits(std::uint16_t value);

  Dialect dialect() const { return dialect_; }
  const std::string& str() const { return text_; }

 private:
  ParameterWriter& put(std::int64_t value, int size, const std::string& ascii);

  Dialect dialect_;
  std::string text_;
};

}  // namespace scanway::sick
