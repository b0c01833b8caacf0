#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/bus/bus.h"
#include "common/bus/channels.h"
#include "common/messages/codec.h"
#include "common/time/utime.h"
#include "scanway/piece_t.hpp"

namespace scanway {

/// An encoded message that travels in pieces. On its channel it is named by key, version and digest.
struct Object {
  std::string key;
  std::int64_t version = 0;
  Utime utime = 0;
  std::uint64_t digest = 0;  ///< XXH3-64 of the bytes.
  std::vector<std::uint8_t> bytes;
};

/// An encoded piece is at most this long: one network frame.
constexpr std::size_t kMaxPieceBytes = 1300;
/// An object has at least a piece for so many of its unpacked bytes: what few pieces can make a receiver allocate is
/// bounded, however well they are packed.
constexpr std::size_t kMaxUnpackedBytesAPiece = std::size_t{256} << 10;
/// A key is at most this long.
constexpr std::size_t kMaxKeyBytes = 200;

/// The pieces of an object. The same object gives the same pieces. Throws std::invalid_argument for a key that is too
/// long, and for an object that is empty or 2 GB or more.
std::vector<piece_t> cut(std::span<const std::uint8_t> object_bytes, std::string_view key, std::int64_t version,
                         Utime utime);

/// Cuts an object and publishes its pieces, the first at `utime` (the object's own), each `spacing_us` after the one
/// before. Returns the object's digest.
std::uint64_t publish_object(Bus& bus, const Channel& channel, std::span<const std::uint8_t> object_bytes,
                             std::string_view key, std::int64_t version, Utime utime, Utime spacing_us = 1000);

}  // namespace scanway
