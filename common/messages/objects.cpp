#include "common/messages/objects.h"

#include <algorithm>
#include <stdexcept>

#include "common/messages/digest.h"
#include "common/messages/object_coding.h"

namespace scanway {

namespace {

// Of an encoded piece without its key and data: fingerprint, utime, the key's length and end, version, digest,
// total_bytes, coding, piece, npieces, nbytes.
constexpr std::size_t kPieceOverhead = 8 + 8 + 4 + 1 + 8 + 8 + 4 + 1 + 4 + 4 + 4;

}  // namespace

std::vector<piece_t> cut(std::span<const std::uint8_t> object_bytes, std::string_view key, std::int64_t version,
                         Utime utime) {
  if (key.size() > kMaxKeyBytes || object_bytes.empty() || object_bytes.size() > INT32_MAX) {
    throw std::invalid_argument("cannot cut an object of " + std::to_string(object_bytes.size()) +
                                " bytes with a key of " + std::to_string(key.size()));
  }
  const Packed packed = pack(object_bytes);
  const std::size_t fewest = (object_bytes.size() + kMaxUnpackedBytesAPiece - 1) / kMaxUnpackedBytesAPiece;
  const std::size_t step = std::min(kMaxPieceBytes - kPieceOverhead - key.size(), packed.bytes.size() / fewest);
  piece_t piece{};
  piece.utime = utime;
  piece.key = key;
  piece.version = version;
  piece.digest = static_cast<std::int64_t>(digest(object_bytes));
  piece.total_bytes = static_cast<std::int32_t>(object_bytes.size());
  piece.coding = packed.coding;
  piece.npieces = static_cast<std::int32_t>((packed.bytes.size() + step - 1) / step);
  std::vector<piece_t> pieces;
  pieces.reserve(static_cast<std::size_t>(piece.npieces));
  for (auto rest = std::span(packed.bytes); !rest.empty(); rest = rest.subspan(piece.data.size())) {
    const auto part = rest.first(std::min(step, rest.size()));
    piece.data.assign(part.begin(), part.end());
    piece.nbytes = static_cast<std::int32_t>(part.size());
    pieces.push_back(piece);
    ++piece.piece;
  }
  return pieces;
}

std::uint64_t publish_object(Bus& bus, const Channel& channel, std::span<const std::uint8_t> object_bytes,
                             std::string_view key, std::int64_t version, Utime utime, Utime spacing_us) {
  Utime at = utime;
  for (const piece_t& piece : cut(object_bytes, key, version, utime)) {
    bus.publish(channel.name, encode(piece), at);
    at += spacing_us;
  }
  return digest(object_bytes);
}

}  // namespace scanway
