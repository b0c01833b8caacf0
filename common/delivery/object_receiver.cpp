#include "common/delivery/object_receiver.h"

#include <algorithm>

#include "common/bus/channels.h"
#include "common/messages/objects.h"

namespace scanway {
namespace {

// Keeps a request below kMaxPieceBytes with the longest channel and key.
constexpr std::size_t kMaxRanges = 100;

void add_range(piece_request_t& request, std::int32_t first, std::int32_t end) {
  if (first >= end) return;
  if (!request.end_piece.empty() && request.end_piece.back() == first) {
    request.end_piece.back() = end;
  } else if (request.first_piece.size() < kMaxRanges) {
    request.first_piece.push_back(first);
    request.end_piece.push_back(end);
  }
}

}  // namespace

void ObjectReceiver::add(std::string_view channel, const piece_t& piece, SteadyTime now) {
  ObjectAssembler& assembler = assemblers_.try_emplace(std::string(channel), limits_.assembler).first->second;
  const AssemblerCounters before = assembler.counters();
  const bool whole = assembler.add(piece).has_value();
  const AssemblerCounters& after = assembler.counters();
  if (after.bad_pieces != before.bad_pieces) return;
  const Name name{std::string(channel), piece.key};
  const auto found = wanted_.find(name);
  const bool repeated = after.repeated_pieces != before.repeated_pieces;
  if (found != wanted_.end() && found->second.digest == piece.digest && found->second.asked && !repeated) {
    ++counters_.repaired;
  }
  if (whole || assembler.has(piece.key, piece.version)) {
    if (found != wanted_.end() && assembler.has(piece.key, found->second.version)) wanted_.erase(found);
    return;
  }
  Wanted* const wanted = want(name, piece.version, piece.digest, piece.npieces, now);
  if (wanted == nullptr || repeated) return;
  wanted->interval = limits_.first_interval;
  wanted->due = now + limits_.quiet;
}

void ObjectReceiver::hear(const object_index_t& index, SteadyTime now) {
  const Channel* const channel = find_channel(index.channel);
  if (channel == nullptr || !channel->cut) return;
  const ObjectAssembler& assembler = assemblers_.try_emplace(index.channel, limits_.assembler).first->second;
  for (const object_entry_t& entry : index.objects) {
    if (entry.npieces <= 0 || entry.key.size() > kMaxKeyBytes || assembler.has(entry.key, entry.version)) continue;
    want({index.channel, entry.key}, entry.version, entry.digest, entry.npieces, now);
  }
}

// The entry of that object, made when it is newer than what was wanted; nullptr when it is older, or there are too
// many.
ObjectReceiver::Wanted* ObjectReceiver::want(const Name& name, std::int64_t version, std::int64_t digest,
                                             std::int32_t npieces, SteadyTime now) {
  auto found = wanted_.find(name);
  if (found == wanted_.end() && wanted_.size() >= limits_.max_wanted) return nullptr;
  if (found != wanted_.end() && found->second.version > version) return nullptr;
  if (found == wanted_.end() || found->second.version != version || found->second.digest != digest) {
    const Wanted fresh{version, digest, npieces, now, now, limits_.first_interval, false};
    found = wanted_.insert_or_assign(name, fresh).first;
  }
  // Whoever was silent for long and is heard again will answer.
  if (now - found->second.heard > 3 * limits_.longest_interval) found->second.due = now;
  found->second.heard = now;
  return &found->second;
}

void ObjectReceiver::ask(SteadyTime now) {
  std::map<std::string, std::vector<IncompleteObject>, std::less<>> incomplete;
  std::size_t requests = 0;
  for (const auto entry : in_order()) {
    if (requests >= limits_.requests_a_turn) return;
    auto& [name, wanted] = *entry;
    if (now - wanted.heard > limits_.give_up_after) {
      ++counters_.given_up;
      assemblers_.at(name.first).give_up(name.second, wanted.version, static_cast<std::uint64_t>(wanted.digest));
      wanted_.erase(entry);
      continue;
    }
    if (now >= wanted.due) {
      if (!incomplete.contains(name.first)) incomplete[name.first] = assemblers_.at(name.first).incomplete();
      const auto& waiting = incomplete[name.first];
      const auto known = std::find_if(waiting.begin(), waiting.end(), [&](const IncompleteObject& object) {
        return object.key == name.second && object.version == wanted.version &&
               static_cast<std::int64_t>(object.digest) == wanted.digest;
      });
      request(name, wanted, known == waiting.end() ? nullptr : &*known, now);
      ++requests;
    }
  }
}

std::vector<std::map<ObjectReceiver::Name, ObjectReceiver::Wanted>::iterator> ObjectReceiver::in_order() {
  std::vector<std::map<Name, Wanted>::iterator> order;
  order.reserve(wanted_.size());
  for (auto entry = wanted_.begin(); entry != wanted_.end(); ++entry) order.push_back(entry);
  std::stable_partition(order.begin(), order.end(),
                        [this](const auto& entry) { return limits_.first.contains(entry->first.first); });
  return order;
}

void ObjectReceiver::request(const Name& name, Wanted& wanted, const IncompleteObject* known, SteadyTime now) {
  piece_request_t request{};
  request.channel = name.first;
  request.key = name.second;
  request.version = wanted.version;
  request.digest = wanted.digest;
  if (known == nullptr) {
    add_range(request, 0, wanted.npieces);
  } else {
    request.utime = known->utime;
    for (const std::int32_t piece : known->missing) add_range(request, piece, piece + 1);
  }
  request.nranges = static_cast<std::int32_t>(request.first_piece.size());
  if (!wanted.asked) ++counters_.gaps;
  wanted.asked = true;
  wanted.due = now + wanted.interval;
  wanted.interval = std::min(2 * wanted.interval, limits_.longest_interval);
  ++counters_.requests;
  send_(request);
}

std::set<std::string, std::less<>> ObjectReceiver::lacking() const {
  std::set<std::string, std::less<>> channels;
  for (const auto& [name, wanted] : wanted_) channels.insert(name.first);
  return channels;
}

AssemblerCounters ObjectReceiver::pieces() const {
  AssemblerCounters sum;
  for (const auto& [channel, assembler] : assemblers_) {
    const AssemblerCounters& one = assembler.counters();
    sum.pieces += one.pieces;
    sum.kept_pieces += one.kept_pieces;
    sum.objects += one.objects;
    sum.repeated_pieces += one.repeated_pieces;
    sum.bad_pieces += one.bad_pieces;
    sum.bad_objects += one.bad_objects;
    sum.conflicting_pieces += one.conflicting_pieces;
    sum.superseded_pieces += one.superseded_pieces;
    sum.superseded_objects += one.superseded_objects;
    sum.crowded_out += one.crowded_out;
  }
  return sum;
}

}  // namespace scanway
