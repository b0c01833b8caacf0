#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/messages/layout.h"
#include "common/time/utime.h"
#include "scanway/piece_t.hpp"

namespace scanway {

/// What is compared has a name: its channel, key, version and digest. A message that is not cut in pieces has no key,
/// its time for a version, and the digest of its bytes.
struct RecordedName {
  std::string channel;
  std::string key;
  std::int64_t version = 0;
  std::int64_t digest = 0;
  auto operator<=>(const RecordedName&) const = default;
};

/// "COST_MAP_TILE 3,4 version 2", "POSE at 946684801000000".
std::string text_of(const RecordedName& name);

/// What a log's pieces of one name say.
class RecordedObject {
 public:
  using Bytes = std::span<const std::uint8_t>;

  /// `encoded` is the piece as it was logged; it is borrowed.
  void add(const piece_t& piece, Bytes encoded);
  /// After the last piece: whether they are what they say, a message of that channel.
  void check(const Channel& channel);

  Utime utime() const { return utime_; }
  bool whole() const { return static_cast<std::size_t>(npieces_) == pieces_.size(); }
  /// Why this cannot be what was sent; empty: nothing speaks against it.
  const std::string& fault() const { return fault_; }
  /// "4 of 171 pieces (17, 41-42, 90)".
  std::string lacking() const;
  /// The object's bytes; nothing if it is not whole or not what its digest says.
  std::optional<std::vector<std::uint8_t>> bytes() const;
  /// By number, as logged.
  const std::map<std::int32_t, Bytes>& pieces() const { return pieces_; }

 private:
  Utime utime_ = 0;
  std::int32_t total_bytes_ = 0;
  std::int32_t npieces_ = 0;
  std::int8_t coding_ = 0;
  std::map<std::int32_t, Bytes> pieces_;
  std::string fault_;
};

/// The time that a message of ours says first; 0 if it is too short to say one.
Utime utime_of(std::span<const std::uint8_t> message);

}  // namespace scanway
