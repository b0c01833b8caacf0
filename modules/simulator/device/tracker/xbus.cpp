#include "modules/simulator/device/tracker/xbus.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "common/bytes/big_endian.h"

namespace scanway::simulator {
namespace {

constexpr std::uint8_t kPreamble = 0xFA, kOnlyDevice = 0xFF, kExtended = 0xFF;
constexpr int kSizes[] = {4, 4, 6, 8};

std::uint8_t checksum(std::span<const std::uint8_t> after_preamble) {
  return static_cast<std::uint8_t>(-std::accumulate(after_preamble.begin(), after_preamble.end(), 0));
}

void append_number(XbusBytes& data, int format, double number) {
  if (format == 0) return append_big_endian(data, std::bit_cast<std::uint32_t>(static_cast<float>(number)), 4);
  if (format == 1) return append_big_endian(data, static_cast<std::uint64_t>(std::llround(std::ldexp(number, 20))), 4);
  if (format == 3) return append_big_endian(data, std::bit_cast<std::uint64_t>(number), 8);
  const auto fixed = static_cast<std::uint64_t>(std::llround(std::ldexp(number, 32)));
  append_big_endian(data, fixed & 0xFFFFFFFF, 4);  // The fraction comes first.
  append_big_endian(data, fixed >> 32 & 0xFFFF, 2);
}

}  // namespace

XbusBytes xbus_message(std::uint8_t number, std::span<const std::uint8_t> data) {
  XbusBytes message;
  message.reserve(data.size() + 7);
  for (const std::uint8_t byte : {kPreamble, kOnlyDevice, number}) message.push_back(byte);
  if (data.size() < kExtended) {
    message.push_back(static_cast<std::uint8_t>(data.size()));
  } else {
    message.push_back(kExtended);
    append_big_endian(message, data.size(), 2);
  }
  message.insert(message.end(), data.begin(), data.end());
  message.push_back(checksum(std::span(message).subspan(1)));
  return message;
}

void append_numbers(XbusBytes& data, std::uint16_t id, std::span<const double> numbers) {
  const int format = id & 3;
  append_big_endian(data, id, 2);
  append_big_endian(data, static_cast<std::size_t>(kSizes[format]) * numbers.size(), 1);
  append_bare_numbers(data, format, numbers);
}

void append_bare_numbers(XbusBytes& data, int format, std::span<const double> numbers) {
  for (const double number : numbers) append_number(data, format, number);
}

void append_integer(XbusBytes& data, std::uint16_t id, std::uint32_t value, int size) {
  append_big_endian(data, id, 2);
  append_big_endian(data, static_cast<std::uint64_t>(size), 1);
  append_big_endian(data, value, size);
}

std::optional<XbusRequest> XbusRequests::next() {
  constexpr std::size_t kHead = 4;
  for (;; waiting_.erase(waiting_.begin())) {
    waiting_.erase(waiting_.begin(), std::find(waiting_.begin(), waiting_.end(), kPreamble));
    if (waiting_.size() < kHead) return std::nullopt;
    const std::size_t length = waiting_[3];
    if (waiting_[1] != kOnlyDevice || length == kExtended) continue;
    if (waiting_.size() < kHead + length + 1) return std::nullopt;
    if (checksum(std::span(waiting_).subspan(1, kHead - 1 + length)) != waiting_[kHead + length]) continue;
    const auto begin = waiting_.begin(), data = begin + kHead, end = data + static_cast<std::ptrdiff_t>(length);
    XbusRequest request{waiting_[2], {data, end}};
    waiting_.erase(begin, end + 1);
    return request;
  }
}

}  // namespace scanway::simulator
