#include "common/delivery/object_sender.h"

#include <algorithm>
#include <tuple>

#include "common/messages/codec.h"
#include "common/messages/objects.h"

namespace scanway {
namespace {

constexpr SteadyTime kFreshFor = 5'000'000;
// Of an encoded index without its entries, and of an entry without its key.
constexpr std::size_t kIndexOverhead = 8 + 8 + 4 + 64 + 4;
constexpr std::size_t kEntryOverhead = 4 + 1 + 8 + 8 + 4;

}  // namespace

ObjectSender::ObjectSender(Send send, const SenderLimits& limits)
    : send_(std::move(send)), limits_(limits), bucket_(limits.bytes_per_second, limits.burst_bytes) {}

void ObjectSender::add(std::string_view channel, const piece_t& piece, std::span<const std::uint8_t> encoded,
                       bool at_once) {
  const std::lock_guard lock(mutex_);
  Held& held = hold(channel, piece);
  if (piece.piece != static_cast<std::int32_t>(held.pieces.size())) return;  // It is held already.
  held.pieces.emplace_back(encoded.begin(), encoded.end());
  held.queued.push_back(at_once);
  held.bytes += encoded.size();
  held_bytes_ += encoded.size();
  const Piece piece_held{held_.at({held.channel, held.key}), held.pieces.size() - 1};
  if (at_once && limits_.first.contains(channel)) asked_.push_front(piece_held);
  if (at_once && !limits_.first.contains(channel)) fresh_.push_back(piece_held);
  while (held_bytes_ > limits_.max_held_bytes && held_.size() > 1) drop_oldest();
}

ObjectSender::Held& ObjectSender::hold(std::string_view channel, const piece_t& piece) {
  std::shared_ptr<Held>& held = held_[{std::string(channel), piece.key}];
  if (held && held->version == piece.version && held->digest == piece.digest) return *held;
  if (held) held_bytes_ -= held->bytes;
  held = std::make_shared<Held>();
  held->channel = channel;
  held->key = piece.key;
  held->version = piece.version;
  held->digest = piece.digest;
  held->utime = piece.utime;
  held->number = ++objects_;
  return *held;
}

void ObjectSender::drop_oldest() {
  const auto oldest = std::min_element(
      held_.begin(), held_.end(), [](const auto& a, const auto& b) { return a.second->number < b.second->number; });
  held_bytes_ -= oldest->second->bytes;
  held_.erase(oldest);
  ++counters_.objects_dropped;
}

void ObjectSender::answer(const piece_request_t& request) {
  const std::lock_guard lock(mutex_);
  ++counters_.requests;
  const auto found = held_.find({request.channel, request.key});
  if (found == held_.end() || found->second->version != request.version || found->second->digest != request.digest) {
    ++counters_.requests_unmet;
    return;
  }
  Held& held = *found->second;
  const auto pieces = static_cast<std::int64_t>(held.pieces.size());
  for (std::size_t range = 0; range < request.first_piece.size(); ++range) {
    const std::int64_t end = std::min<std::int64_t>(request.end_piece[range], pieces);
    for (std::int64_t i = std::max(request.first_piece[range], 0); i < end; ++i) {
      const auto piece = static_cast<std::size_t>(i);
      if (held.queued[piece]) continue;  // Somebody else asked, or it has not gone yet.
      held.queued[piece] = true;
      limits_.first.contains(held.channel) ? asked_.emplace_front(found->second, piece)
                                           : asked_.emplace_back(found->second, piece);
    }
  }
}

void ObjectSender::pump(SteadyTime now) {
  const std::lock_guard lock(mutex_);
  bucket_.refill(now);
  while (!asked_.empty() || !fresh_.empty()) {
    std::deque<Piece>& queue = asked_.empty() ? fresh_ : asked_;
    if (limits_.drop_superseded && is_superseded(queue.front())) {
      queue.pop_front();
      continue;
    }
    const auto& [held, piece] = queue.front();
    if (!bucket_.take(static_cast<double>(held->pieces[piece].size()))) return;
    send_front(queue, asked_.empty() ? counters_.pieces_sent : counters_.pieces_resent);
  }
}

bool ObjectSender::is_superseded(const Piece& piece) const {
  const auto newest = held_.find({piece.first->channel, piece.first->key});
  return newest != held_.end() && newest->second != piece.first;
}

void ObjectSender::send_front(std::deque<Piece>& queue, std::uint64_t& counter) {
  const auto [held, piece] = std::move(queue.front());
  queue.pop_front();
  held->queued[piece] = false;
  ++counter;
  send_(held->channel, held->pieces[piece]);
}

void ObjectSender::announce(SteadyTime now) {
  const std::lock_guard lock(mutex_);
  for (const object_index_t& index : next_indices(now)) send_("OBJECT_INDEX", encode(index));
}

// What is new, and then what has waited longest since its last turn. Objects that are not sent whole yet are held back:
// nobody can lack them.
std::vector<object_index_t> ObjectSender::next_indices(SteadyTime now) {
  std::vector<Held*> all;
  for (const auto& [name, held] : held_) {
    if (std::find(held->queued.begin(), held->queued.end(), true) == held->queued.end()) all.push_back(held.get());
  }
  const auto fresh = [now](const Held* held) { return held->since == 0 || now - held->since < kFreshFor; };
  const auto turn = [&](const Held* held) {
    return std::tuple(!limits_.first.contains(held->channel), !fresh(held), held->announced_at);
  };
  std::stable_sort(all.begin(), all.end(), [&](const Held* a, const Held* b) { return turn(a) < turn(b); });
  std::map<std::string, object_index_t> open;  // By channel, not full yet.
  std::vector<object_index_t> full;
  const auto size = [](const object_index_t& index) {
    std::size_t bytes = kIndexOverhead;
    for (const object_entry_t& entry : index.objects) bytes += kEntryOverhead + entry.key.size();
    return bytes;
  };
  for (Held* held : all) {
    object_index_t& index = open[held->channel];
    if (size(index) + kEntryOverhead + held->key.size() > kMaxPieceBytes) full.push_back(std::exchange(index, {}));
    if (full.size() + open.size() > limits_.indices_a_turn) break;
    index.channel = held->channel;
    index.utime = std::max(index.utime, held->utime);
    index.objects.push_back({held->key, held->version, held->digest, static_cast<std::int32_t>(held->pieces.size())});
    if (held->since == 0) held->since = now;
    held->announced_at = now;
  }
  for (auto& [channel, index] : open) {
    if (!index.objects.empty()) full.push_back(std::move(index));
  }
  for (object_index_t& index : full) index.nobjects = static_cast<std::int32_t>(index.objects.size());
  return full;
}

std::size_t ObjectSender::waiting() const {
  const std::lock_guard lock(mutex_);
  return asked_.size() + fresh_.size();
}

SenderCounters ObjectSender::counters() const {
  const std::lock_guard lock(mutex_);
  return counters_;
}

}  // namespace scanway
