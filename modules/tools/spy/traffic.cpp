#include "modules/tools/spy/traffic.h"

#include "common/bus/channels.h"
#include "common/messages/codec.h"
#include "common/messages/digest.h"

namespace scanway::tools {
namespace {

using Kind = Sighting::Kind;

/// LCM sends to itself when it starts.
constexpr std::string_view kSelfTest = "LCM_SELF_TEST";

AssemblerLimits limits() {
  AssemblerLimits limits;
  limits.max_waiting_bytes = std::size_t{128} << 20;
  return limits;
}

/// Of what `message` should be: its channel's type, else what it says itself; nullptr if nobody knows.
const Layout* layout_of(const BusMessage& message) {
  const Channel* const known = find_channel(message.channel);
  if (known == nullptr) return find_layout(fingerprint(message.bytes));
  return find_layout(known->cut ? std::string_view("scanway.piece_t") : known->type);
}

std::string fault_of(const BusMessage& message, const Layout* layout) {
  if (message.bytes.size() < sizeof layout->hash) return "too short to have a type";
  return layout == nullptr ? std::string() : find_fault(*layout, message.bytes);
}

}  // namespace

void Traffic::tell(const Sighting& sighting) const {
  if (listener_) listener_(sighting);
}

ChannelTraffic* Traffic::channel(std::string_view name) {
  const auto found = channels_.find(name);
  if (found != channels_.end()) return &found->second;
  if (channels_.size() >= kMostChannels) return nullptr;
  return &channels_.try_emplace(std::string(name), window_).first->second;
}

void Traffic::take(const BusMessage& message, SteadyTime now) {
  if (message.channel == kSelfTest) return;
  ChannelTraffic* const seen = channel(message.channel);
  if (seen == nullptr) {
    ++ignored_;
    return;
  }
  ++seen->messages;
  seen->bytes += message.bytes.size();
  seen->arrivals.add(now, message.bytes.size());
  const Layout* const layout = layout_of(message);
  if (std::string fault = fault_of(message, layout); !fault.empty()) return refuse(*seen, message, std::move(fault));
  if (layout == nullptr) {
    seen->type = hex(static_cast<std::uint64_t>(fingerprint(message.bytes)));
    return tell({Kind::foreign, message.channel, message.bytes});
  }
  if (layout->hash == piece_t::getHash()) return take_piece(*seen, message, *layout);
  seen->type = layout->name;
  seen->gaps.add(*layout, message.bytes);
  tell({Kind::message, message.channel, message.bytes, layout});
}

void Traffic::take_piece(ChannelTraffic& channel, const BusMessage& message, const Layout& layout) {
  channel.cut = true;
  const piece_t piece = decode<piece_t>(message.bytes);
  const Sighting sighting{Kind::piece, message.channel, message.bytes, &layout, &piece};
  if (!channel.assembler && assemblers_ < kMostAssemblers) {
    channel.assembler.emplace(limits());
    ++assemblers_;
  }
  if (!channel.assembler) return tell(sighting);
  const AssemblerCounters before = channel.assembler->counters();
  const auto object = channel.assembler->add(piece);
  const AssemblerCounters& after = channel.assembler->counters();
  if (after.bad_pieces > before.bad_pieces) {
    return refuse(channel, message, "a piece of '" + piece.key + "' contradicts itself");
  }
  tell(sighting);
  if (after.bad_objects > before.bad_objects) {
    refuse(channel, message, "object '" + piece.key + "' is not what its digest says");
  } else if (object) {
    take_object(channel, *object, sighting);
  }
}

void Traffic::take_object(ChannelTraffic& channel, const Object& object, const Sighting& last_piece) {
  const BusMessage whole{last_piece.channel, object.bytes};
  const Channel* const known = find_channel(whole.channel);
  const Layout* const layout =
      known != nullptr ? layout_on(*known, whole.bytes) : find_layout(fingerprint(whole.bytes));
  if (layout == nullptr) {
    channel.type = hex(static_cast<std::uint64_t>(fingerprint(whole.bytes)));
    return;
  }
  if (const std::string fault = find_fault(*layout, whole.bytes); !fault.empty()) {
    return refuse(channel, whole, "object '" + object.key + "': " + fault);
  }
  channel.type = layout->name;
  ++channel.objects;
  tell({Kind::object, whole.channel, whole.bytes, layout, last_piece.piece});
}

void Traffic::refuse(ChannelTraffic& channel, const BusMessage& message, std::string reason) {
  ++channel.bad;
  channel.last_fault = reason;
  tell({Kind::bad, message.channel, message.bytes, nullptr, nullptr, std::move(reason)});
}

}  // namespace scanway::tools
