#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// Xsens' messages as a tracker writes them.
namespace scanway::simulator {

using XbusBytes = std::vector<std::uint8_t>;

/// A whole message: preamble, FF for the only device, number, length, data, checksum.
XbusBytes xbus_message(std::uint8_t number, std::span<const std::uint8_t> data = {});

/// One item of an MTData2 message; numbers in the format of the identifier's two lowest bits: float32, fp12.20,
/// fp16.32, float64.
void append_numbers(XbusBytes& data, std::uint16_t id, std::span<const double> numbers);
/// The numbers alone, as MTData has them; `format`: 0 to 3, in the same order.
void append_bare_numbers(XbusBytes& data, int format, std::span<const double> numbers);
/// One item that is an integer of `size` bytes.
void append_integer(XbusBytes& data, std::uint16_t id, std::uint32_t value, int size);

struct XbusRequest {
  std::uint8_t number = 0;
  XbusBytes data;
};

/// Finds the requests in what the host sends; what is none is passed over.
class XbusRequests {
 public:
  void push(std::span<const std::uint8_t> bytes) { waiting_.insert(waiting_.end(), bytes.begin(), bytes.end()); }
  std::optional<XbusRequest> next();

 private:
  XbusBytes waiting_;
};

}  // namespace scanway::simulator
