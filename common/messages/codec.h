#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include "common/messages/bad_message.h"
#include "common/messages/layout.h"

namespace scanway {

/// Throws BadMessage unless `bytes` is exactly one message of the type with that fingerprint.
void check_message(std::int64_t hash, std::span<const std::uint8_t> bytes);

/// The message of LCM type T that `bytes` hold. Throws BadMessage with the reason if they hold anything else. The
/// generated decoder trusts every length that it meets, so it sees only what check_message() let pass.
template <class T>
T decode(std::span<const std::uint8_t> bytes) {
  check_message(T::getHash(), bytes);
  T message{};
  if (message.decode(bytes.data(), 0, static_cast<int>(bytes.size())) != static_cast<int>(bytes.size())) {
    throw BadMessage(std::string(T::getTypeName()) + ": its decoder disagrees with its layout");
  }
  return message;
}

/// The bytes of a message. Each array must be as long as its length member says: LCM's encoder reads that many, and
/// cannot tell. Throws std::invalid_argument for a string with a zero byte and for a message of 2 GB or more.
template <class T>
std::vector<std::uint8_t> encode(const T& message) {
  const int size = message.getEncodedSize();
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size < 0 ? 0 : size));
  if (message.encode(bytes.data(), 0, size) != size) {
    throw std::invalid_argument(std::string(T::getTypeName()) + ": the message contradicts itself");
  }
  return bytes;
}

}  // namespace scanway
