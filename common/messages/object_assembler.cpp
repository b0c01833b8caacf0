#include "common/messages/object_assembler.h"

#include <limits>
#include <utility>

#include <zstd.h>

#include "common/messages/digest.h"
#include "common/messages/object_coding.h"

namespace scanway {

namespace {

// What a waiting object and a waiting piece cost beside their data: nodes of maps, and headers of allocations.
constexpr std::size_t kObjectOverhead = 512;
constexpr std::size_t kBookkeeping = 128;

enum HeaderField { kKey, kVersion, kDigest, kUtime, kTotalBytes, kCoding, kNpieces };

}  // namespace

std::optional<Object> ObjectAssembler::add(const piece_t& piece) {
  ++counters_.pieces;
  if (!acceptable(piece)) {
    ++counters_.bad_pieces;
    return std::nullopt;
  }
  if (settled(piece)) return std::nullopt;
  const auto waiting = keep(piece);
  const bool all_there = waiting->second.pieces.size() == static_cast<std::size_t>(piece.npieces);
  if (all_there) return complete(waiting);
  while (waiting_bytes_ > limits_.max_waiting_bytes && !by_touch_.empty()) {
    ++counters_.crowded_out;
    drop(by_touch_.begin()->second);
  }
  return std::nullopt;
}

bool ObjectAssembler::acceptable(const piece_t& piece) const {
  const bool sizes = piece.total_bytes > 0 && static_cast<std::size_t>(piece.total_bytes) <= limits_.max_object_bytes &&
                     piece.nbytes > 0 && static_cast<std::size_t>(piece.nbytes) <= kMaxPieceBytes &&
                     static_cast<std::size_t>(piece.nbytes) == piece.data.size() && piece.key.size() <= kMaxKeyBytes;
  const bool coding = piece.coding == piece_t::ZSTD || piece.coding == piece_t::ZSTD_SHUFFLED_BY_FOUR;
  if (!sizes || !coding || piece.piece < 0 || piece.piece >= piece.npieces) return false;
  const auto total = static_cast<std::size_t>(piece.total_bytes), pieces = static_cast<std::size_t>(piece.npieces);
  return pieces <= ZSTD_compressBound(total) && total <= pieces * kMaxUnpackedBytesAPiece;
}

// Whether nothing can come of the piece, because its key has a complete object of the same or a newer version.
bool ObjectAssembler::settled(const piece_t& piece) {
  const auto done = done_.find(piece.key);
  if (done == done_.end() || done->second.version < piece.version) return false;
  if (done->second.version > piece.version) {
    ++counters_.superseded_pieces;
  } else if (done->second.digest != piece.digest) {
    ++counters_.conflicting_pieces;
  } else {
    ++counters_.repeated_pieces;
  }
  return true;
}

bool ObjectAssembler::has(const std::string& key, std::int64_t version) const {
  const auto done = done_.find(key);
  return done != done_.end() && done->second.version >= version;
}

ObjectAssembler::Waiting::iterator ObjectAssembler::keep(const piece_t& piece) {
  const auto [waiting, founded] = waiting_.try_emplace(
      Header(piece.key, piece.version, piece.digest, piece.utime, piece.total_bytes, piece.coding, piece.npieces));
  Parts& parts = waiting->second;
  std::size_t added = founded ? kObjectOverhead + piece.key.size() : 0;
  if (parts.pieces.try_emplace(piece.piece, piece.data).second) {
    added += kBookkeeping + piece.data.size();
    ++counters_.kept_pieces;
  } else {
    ++counters_.repeated_pieces;
  }
  parts.bytes += added;
  waiting_bytes_ += added;
  by_touch_.erase(parts.touched);
  parts.touched = counters_.pieces;
  by_touch_.emplace(parts.touched, waiting);
  return waiting;
}

std::optional<Object> ObjectAssembler::complete(Waiting::iterator waiting) {
  const Header header = waiting->first;
  Packed packed;
  packed.coding = std::get<kCoding>(header);
  for (const auto& [number, data] : waiting->second.pieces) {
    packed.bytes.insert(packed.bytes.end(), data.begin(), data.end());
  }
  drop(waiting);
  auto bytes = unpack(packed, static_cast<std::size_t>(std::get<kTotalBytes>(header)));
  if (!bytes || digest(*bytes) != static_cast<std::uint64_t>(std::get<kDigest>(header))) {
    ++counters_.bad_objects;
    return std::nullopt;
  }
  Object object{std::get<kKey>(header), std::get<kVersion>(header), std::get<kUtime>(header),
                static_cast<std::uint64_t>(std::get<kDigest>(header)), std::move(*bytes)};
  ++counters_.objects;
  remember(object);
  drop_superseded(object.key, object.version);
  return object;
}

void ObjectAssembler::remember(const Object& object) {
  if (const auto old = done_.find(object.key); old != done_.end()) done_since_.erase(old->second.since);
  done_[object.key] = {object.version, static_cast<std::int64_t>(object.digest), counters_.pieces};
  done_since_[counters_.pieces] = object.key;
  while (done_.size() > limits_.max_keys_remembered) {
    done_.erase(done_since_.begin()->second);
    done_since_.erase(done_since_.begin());
  }
}

void ObjectAssembler::drop(Waiting::iterator waiting) {
  waiting_bytes_ -= waiting->second.bytes;
  by_touch_.erase(waiting->second.touched);
  waiting_.erase(waiting);
}

ObjectAssembler::Waiting::iterator ObjectAssembler::first_of(const std::string& key) {
  const std::int64_t first = std::numeric_limits<std::int64_t>::min();
  return waiting_.lower_bound(Header(key, first, first, first, std::numeric_limits<std::int32_t>::min(),
                                     std::numeric_limits<std::int8_t>::min(),
                                     std::numeric_limits<std::int32_t>::min()));
}

// Whatever waits of this key with this version or an older one.
void ObjectAssembler::drop_superseded(const std::string& key, std::int64_t version) {
  for (auto waiting = first_of(key); waiting != waiting_.end() && std::get<kKey>(waiting->first) == key &&
                                     std::get<kVersion>(waiting->first) <= version;) {
    ++counters_.superseded_objects;
    drop(waiting++);
  }
}

void ObjectAssembler::give_up(const std::string& key, std::int64_t version, std::uint64_t digest) {
  for (auto waiting = first_of(key); waiting != waiting_.end() && std::get<kKey>(waiting->first) == key;) {
    const auto one = waiting++;
    if (std::get<kVersion>(one->first) != version) continue;
    if (std::get<kDigest>(one->first) != static_cast<std::int64_t>(digest)) continue;
    ++counters_.given_up;
    drop(one);
  }
}

void ObjectAssembler::give_up_all() {
  counters_.given_up += waiting_.size();
  while (!waiting_.empty()) drop(waiting_.begin());
}

std::vector<IncompleteObject> ObjectAssembler::incomplete() const {
  std::vector<IncompleteObject> all;
  for (const auto& [header, parts] : waiting_) {
    IncompleteObject object;
    object.key = std::get<kKey>(header);
    object.version = std::get<kVersion>(header);
    object.digest = static_cast<std::uint64_t>(std::get<kDigest>(header));
    object.utime = std::get<kUtime>(header);
    object.npieces = std::get<kNpieces>(header);
    object.missing_count = object.npieces - static_cast<std::int32_t>(parts.pieces.size());
    std::int32_t expected = 0;
    const auto list_up_to = [&](std::int32_t end) {
      for (; expected < end && object.missing.size() < IncompleteObject::kMissingListed; ++expected) {
        object.missing.push_back(expected);
      }
      expected = end + 1;
    };
    for (const auto& [number, data] : parts.pieces) list_up_to(number);
    list_up_to(object.npieces);
    all.push_back(std::move(object));
  }
  return all;
}

}  // namespace scanway
