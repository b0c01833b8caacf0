#include "common/delivery/live_bus.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "common/bus/channels.h"
#include "common/delivery/kernel_drops.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "common/messages/codec.h"
#include "common/messages/layout.h"
#include "common/messages/objects.h"

namespace scanway {
namespace {

constexpr SteadyTime kSecond = 1'000'000;
constexpr SteadyTime kAskEvery = 50'000;
constexpr auto kPacingWait = std::chrono::milliseconds(2);
constexpr auto kIdleWait = std::chrono::milliseconds(20);

bool is_cut(std::string_view channel) {
  const Channel* const known = find_channel(channel);
  return known != nullptr && known->cut;
}

const Layout* layout_of(std::string_view channel) {
  const Channel* const known = find_channel(channel);
  if (known == nullptr) return nullptr;
  return find_layout(known->cut ? std::string_view("scanway.piece_t") : known->type);
}

// Pieces, announcements and requests are small, so that one of them can make this process do only so much.
bool is_of_one_frame(std::string_view channel) {
  return is_cut(channel) || channel == channel::kObjectIndex.name || channel == channel::kPieceRequest.name;
}

std::string fault_of(const BusMessage& message) {
  const Layout* const layout = layout_of(message.channel);
  if (layout == nullptr) return {};
  if (is_of_one_frame(message.channel) && message.bytes.size() > kMaxPieceBytes) return "longer than one frame";
  return find_fault(*layout, message.bytes);
}

// Of a good message: every type of a channel begins with it.
Utime utime_of(std::span<const std::uint8_t> message) { return fingerprint(message.subspan(sizeof(std::int64_t))); }

void add_to(std::string& summary, const std::string& sentence) {
  if (sentence.empty()) return;
  if (!summary.empty()) summary += "; ";
  summary += sentence;
}

std::int64_t count(std::uint64_t value) { return static_cast<std::int64_t>(value); }

}  // namespace

LiveBus::LiveBus(LcmBus& lcm, Identity who, LiveBusOptions options)
    : lcm_(lcm),
      who_(std::move(who)),
      options_(std::move(options)),
      sender_([this](std::string_view channel, auto bytes) { send(channel, bytes); }, options_.sender),
      receiver_([this](const piece_request_t& r) { send(channel::kPieceRequest.name, encode(r)); }, options_.receiver),
      drops_before_(kernel_drops()) {
  listen();
}

LiveBus::~LiveBus() {
  ending_ = true;
  if (thread_.joinable()) thread_.join();
}

void LiveBus::subscribe(std::string_view channel, Handler handler) {
  if (thread_.joinable()) throw std::logic_error("LiveBus: subscribe before start");
  subscriptions_.add(channel, std::move(handler));
  if (!inputs_.emplace(channel, Input{}).second) return;
  lcm_.subscribe(channel, [this](const BusMessage& message) { forward(message); });
}

// What the bus's own thread works on.
void LiveBus::listen() {
  const auto guarded = [this](auto handle) {
    return [this, handle](const BusMessage& message) {
      Input& input = inputs_.try_emplace(std::string(message.channel)).first->second;
      if (is_good(message, input)) handle(message.bytes);
    };
  };
  lcm_.subscribe(channel::kPieceRequest.name,
                 guarded([this](auto bytes) { sender_.answer(decode<piece_request_t>(bytes)); }));
  lcm_.subscribe(channel::kObjectIndex.name, guarded([this](auto bytes) {
                   const auto index = decode<object_index_t>(bytes);
                   if (inputs_.contains(index.channel)) receiver_.hear(index, steady_now());
                 }));
  lcm_.subscribe(channel::kHealth.name, guarded([this](auto bytes) {
                   const Identity other = identity_of(decode<health_t>(bytes));
                   const std::lock_guard lock(mutex_);
                   if (is_elder_twin(other, who_)) elder_ = other;
                 }));
}

void LiveBus::start() {
  thread_ = std::thread([this] {
    while (!ending_) turn(sender_.waiting() > 0 ? kPacingWait : kIdleWait);
  });
}

void LiveBus::send(std::string_view channel, std::span<const std::uint8_t> bytes) {
  sent_.count(channel);
  lcm_.publish(channel, bytes, 0);
}

void LiveBus::refuse_twins(std::chrono::milliseconds wait) {
  for (const SteadyTime end = steady_now() + wait.count() * 1000; steady_now() < end;) {
    std::this_thread::sleep_for(kIdleWait);
    if (const auto other = elder_twin()) {
      throw InputError("another " + other->text() + " runs on this bus; stop that one, or choose another --lcm-url");
    }
  }
}

void LiveBus::publish(std::string_view channel, std::span<const std::uint8_t> bytes, Utime) {
  if (is_cut(channel)) return sender_.add(channel, decode<piece_t>(bytes), bytes, !held_);
  if (!held_) send(channel, bytes);
  if (std::find(options_.repeated.begin(), options_.repeated.end(), channel) == options_.repeated.end()) return;
  const std::lock_guard lock(mutex_);
  said_[std::string(channel)].assign(bytes.begin(), bytes.end());
}

std::size_t LiveBus::dispatch(std::chrono::milliseconds wait) {
  const auto messages = inbox_.take(wait);
  for (const Inbox::Waiting& message : messages) subscriptions_.deliver({message.channel, message.bytes, 0});
  return messages.size();
}

void LiveBus::report(std::map<std::string, std::int64_t> counters, std::string summary) {
  const std::lock_guard lock(mutex_);
  node_counters_ = std::move(counters);
  node_summary_ = std::move(summary);
}

std::optional<Identity> LiveBus::elder_twin() const {
  const std::lock_guard lock(mutex_);
  return elder_;
}

bool LiveBus::lacks(std::string_view channel) const {
  const std::lock_guard lock(mutex_);
  return lacking_.contains(channel);
}

void LiveBus::note_lacking() {
  auto lacking = receiver_.lacking();
  const std::lock_guard lock(mutex_);
  lacking_ = std::move(lacking);
}

void LiveBus::drain(std::chrono::milliseconds wait) const {
  for (const SteadyTime end = steady_now() + wait.count() * 1000; sender_.waiting() > 0 && steady_now() < end;) {
    std::this_thread::sleep_for(kIdleWait);
  }
}

void LiveBus::turn(std::chrono::milliseconds wait) {
  lcm_.dispatch(wait);
  const SteadyTime now = steady_now();
  sender_.pump(now);
  if (now >= next_ask_) {
    receiver_.ask(now);
    note_lacking();
    next_ask_ = now + kAskEvery;
  }
  if (now >= next_second_) {
    every_second();
    next_second_ = std::max(next_second_ + kSecond, now);
  }
}

void LiveBus::every_second() {
  for (const health_t& message : to_messages(who_, health(), wall_clock()))
    send(channel::kHealth.name, encode(message));
  if (held_) return;
  sender_.announce(steady_now());
  const std::lock_guard lock(mutex_);
  for (const auto& [channel, bytes] : said_) send(channel, bytes);
}

void LiveBus::forward(const BusMessage& message) {
  Input& input = inputs_.find(message.channel)->second;
  if (!is_good(message, input)) return;
  if (is_cut(message.channel)) {
    receiver_.add(message.channel, decode<piece_t>(message.bytes), steady_now());
  } else {
    input.spacing.add(utime_of(message.bytes));
  }
  if (options_.tap) options_.tap(message);
  inbox_.push(message.channel, message.bytes);
}

bool LiveBus::is_good(const BusMessage& message, Input& input) {
  ++input.received;
  const std::string fault = fault_of(message);
  if (fault.empty()) {
    input.heard = steady_now();
    return true;
  }
  last_fault_ = std::string(message.channel) + ": " + fault;
  if (++input.bad == 1) {
    spdlog::warn("{}; refused. If its sender is Scanway, the two are of different versions: build both anew",
                 printable(last_fault_));
  }
  return false;
}

Health LiveBus::health() {
  Health health;
  const SenderCounters sent = sender_.counters();
  const ReceiverCounters asked = receiver_.counters();
  const AssemblerCounters pieces = receiver_.pieces();
  health.counters = {
      {"kernel_drops", kernel_drops() - drops_before_},
      {"failed_publications", count(lcm_.failed_publications())},
      {"pieces_received", count(pieces.pieces)},
      {"pieces_kept", count(pieces.kept_pieces)},
      {"pieces_repeated", count(pieces.repeated_pieces)},
      {"pieces_superseded", count(pieces.superseded_pieces)},
      {"pieces_bad", count(pieces.bad_pieces + pieces.conflicting_pieces)},
      {"objects_bad", count(pieces.bad_objects)},
      {"objects_crowded_out", count(pieces.crowded_out)},
      {"gaps", count(asked.gaps)},
      {"requests_sent", count(asked.requests)},
      {"repaired", count(asked.repaired)},
      {"given_up", count(asked.given_up)},
      {"lacking", count(receiver_.wanted())},
      {"pieces_sent", count(sent.pieces_sent)},
      {"pieces_resent", count(sent.pieces_resent)},
      {"pieces_waiting", count(sender_.waiting())},
      {"requests_heard", count(sent.requests)},
      {"requests_unmet", count(sent.requests_unmet)},
      {"inbox", count(inbox_.size())},
  };
  count_inputs(health);
  const std::int64_t bad = health.counters["bad_messages"];
  const std::lock_guard lock(mutex_);
  health.counters.insert(node_counters_.begin(), node_counters_.end());
  health.summary = node_summary_;
  add_to(health.summary, lcm_.advice());
  if (bad > 0) add_to(health.summary, "refused " + std::to_string(bad) + " messages, the last: " + last_fault_);
  if (!receiver_.up_to_date()) add_to(health.summary, std::to_string(receiver_.wanted()) + " objects not whole yet");
  if (asked.given_up > 0) add_to(health.summary, std::to_string(asked.given_up) + " objects never became whole");
  if (elder_) add_to(health.summary, "another " + elder_->text() + " runs on this bus");
  return health;
}

void LiveBus::count_inputs(Health& health) const {
  const SteadyTime now = steady_now();
  for (const auto& [channel, input] : inputs_) {
    health.counters["bad_messages"] += input.bad;
    health.counters["received_" + channel] = input.received;
    if (input.spacing.missing() > 0) health.counters["missing_" + channel] = input.spacing.missing();
    health.input_ages_s[channel] =
        input.heard == 0 ? std::numeric_limits<double>::quiet_NaN() : to_seconds(now - input.heard);
  }
  for (const auto& [channel, messages] : sent_.counts()) health.counters["sent_" + channel] = messages;
}

}  // namespace scanway
