#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

/// SICK's CoLa as the device speaks it (SICK telegram listing 8014631, and recorded bytes where that contradicts them).
namespace scanway::simulator {

/// How numbers are written: A as text, B as bytes, most significant first.
enum class Cola : std::uint8_t { a, b };

/// A telegram from the device, value after value.
class TelegramWriter {
 public:
  /// "sRA", "LMDscandata".
  TelegramWriter(Cola cola, std::string_view command, std::string_view name);

  TelegramWriter& u8(unsigned value) { return number(value, 1); }
  TelegramWriter& u16(unsigned value) { return number(value, 2); }
  TelegramWriter& u32(std::uint32_t value) { return number(value, 4); }
  TelegramWriter& i32(std::int32_t value) { return number(static_cast<std::uint32_t>(value), 4); }
  TelegramWriter& f32(float value);
  /// Two bytes of bits, the low one first.
  TelegramWriter& bits(unsigned value) { return u8(value & 0xFF).u8(value >> 8 & 0xFF); }
  /// Characters whose number both sides know.
  TelegramWriter& characters(std::string_view text);
  /// Characters after their number.
  TelegramWriter& text(std::string_view text) { return u16(static_cast<unsigned>(text.size())).characters(text); }

  std::string frame() const;

 private:
  TelegramWriter& number(std::uint32_t value, int size);

  Cola cola_;
  std::string body_;
};

/// sFA: what was asked for was not done.
std::string error_telegram(Cola cola, unsigned code);

/// What the host asks.
struct HostRequest {
  Cola cola = Cola::b;
  std::string command;  ///< sRN, sWN, sMN or sEN.
  std::string name;
  std::string values;  ///< Of CoLa-A: text, blanks between them.
};

/// The host wrote fewer values than the request needs, or a value that is none.
class ValueMissing : public std::runtime_error {
 public:
  ValueMissing() : std::runtime_error("a value is missing") {}
};

/// The values of a request, one after the other. Throws ValueMissing.
class HostValues {
 public:
  explicit HostValues(const HostRequest& request) : cola_(request.cola), left_(request.values) {}

  unsigned u8() { return number(1); }
  unsigned u16() { return number(2); }
  std::uint32_t u32() { return number(4); }
  std::int32_t i32() { return static_cast<std::int32_t>(number(4)); }
  unsigned bits() {
    const unsigned low = u8();
    return low | u8() << 8;
  }

 private:
  std::uint32_t number(std::size_t size);
  std::uint32_t text_number();

  Cola cola_;
  std::string_view left_;
};

/// Finds the requests in what the host sends, in either dialect and any pieces. What is none is passed over.
class HostRequests {
 public:
  void push(std::string_view bytes) { waiting_ += bytes; }
  std::optional<HostRequest> next();

 private:
  std::optional<std::string> next_body(Cola& cola);

  std::string waiting_;
};

}  // namespace scanway::simulator
