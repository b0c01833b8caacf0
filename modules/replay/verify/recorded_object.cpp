#include "modules/replay/verify/recorded_object.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "common/bus/log_format.h"
#include "common/files/printable.h"
#include "common/messages/codec.h"
#include "common/messages/object_assembler.h"

namespace scanway {
namespace {

constexpr std::size_t kFingerprintBytes = 8;

}  // namespace

std::string text_of(const RecordedName& name) {
  if (name.key.empty()) return fmt::format("{} at {}", name.channel, name.version);
  return fmt::format("{} {} version {}", name.channel, printable(name.key), name.version);
}

Utime utime_of(std::span<const std::uint8_t> message) {
  if (message.size() < kFingerprintBytes + sizeof(Utime)) return 0;
  return static_cast<Utime>(log_format::get<std::uint64_t>(message.data() + kFingerprintBytes));
}

void RecordedObject::add(const piece_t& piece, Bytes encoded) {
  if (pieces_.empty()) {
    utime_ = piece.utime;
    total_bytes_ = piece.total_bytes;
    npieces_ = piece.npieces;
    coding_ = piece.coding;
  }
  if (piece.utime != utime_ || piece.total_bytes != total_bytes_ || piece.npieces != npieces_ ||
      piece.coding != coding_ || piece.piece < 0 || piece.piece >= piece.npieces) {
    fault_ = "its pieces contradict each other";
    return;
  }
  const auto [place, is_new] = pieces_.try_emplace(piece.piece, encoded);
  if (!is_new && !std::ranges::equal(place->second, encoded)) {
    fault_ = fmt::format("piece {} is there twice, with different bytes", piece.piece);
  }
}

void RecordedObject::check(const Channel& channel) {
  if (!fault_.empty() || !whole()) return;
  const auto object = bytes();
  if (!object) {
    fault_ = "its bytes do not give its digest";
  } else if (utime_of(*object) != utime_) {
    fault_ = "its pieces say another time than its bytes";
  } else {
    fault_ = find_fault(*layout_on(channel, *object), *object);
  }
}

std::string RecordedObject::lacking() const {
  std::string ranges;
  std::int32_t expected = 0;
  const auto list_up_to = [&](std::int32_t end) {
    if (end > expected) ranges += ranges.empty() ? "" : ", ";
    if (end == expected + 1) ranges += fmt::format("{}", expected);
    if (end > expected + 1) ranges += fmt::format("{}-{}", expected, end - 1);
    expected = end + 1;
  };
  for (const auto& [number, piece] : pieces_) list_up_to(number);
  list_up_to(npieces_);
  return fmt::format("{} of {} pieces ({})", static_cast<std::size_t>(npieces_) - pieces_.size(), npieces_, ranges);
}

std::optional<std::vector<std::uint8_t>> RecordedObject::bytes() const {
  ObjectAssembler assembler;
  for (const auto& [number, piece] : pieces_) {
    if (auto object = assembler.add(decode<piece_t>(piece))) return std::move(object->bytes);
  }
  return std::nullopt;
}

}  // namespace scanway
