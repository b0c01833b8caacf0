#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "common/bus/inbox.h"
#include "common/bus/lcm_bus.h"
#include "common/bus/subscriptions.h"
#include "common/delivery/object_receiver.h"
#include "common/delivery/object_sender.h"
#include "common/delivery/spacing.h"
#include "common/delivery/traffic.h"
#include "common/health/health.h"

namespace scanway {

struct LiveBusOptions {
  SenderLimits sender;
  ReceiverLimits receiver;
  /// Channels whose last own message is said again once a second, for those who missed it or came later. A goal always
  /// is: it comes from an operator, who may be at the far end of a bad link.
  std::vector<std::string> repeated = {"GOAL"};
  /// Gets every good message of the node's channels in the bus's own thread, before the node does.
  Bus::Handler tap;
};

/// A node's end of a bus that loses, repeats and disorders messages. Its own thread checks what comes, hands it to the
/// node's thread, asks for missing pieces, paces and repeats what the node publishes, and says once a second on HEALTH
/// how all that goes: however long the node works on something.
class LiveBus : public Bus {
 public:
  /// `lcm` must outlive this.
  LiveBus(LcmBus& lcm, Identity who, LiveBusOptions options = {});
  ~LiveBus() override;
  LiveBus(const LiveBus&) = delete;
  LiveBus& operator=(const LiveBus&) = delete;

  /// Before start().
  void subscribe(std::string_view channel, Handler handler) override;
  void start();
  /// What the bus's own thread does, once; for whom has no thread to spare (instead of start()). Waits up to `wait`.
  void turn(std::chrono::milliseconds wait);
  /// Throws InputError if, within `wait`, an elder process of the same name is heard. After start().
  void refuse_twins(std::chrono::milliseconds wait);

  void publish(std::string_view channel, std::span<const std::uint8_t> bytes, Utime utime) override;
  /// While held, what is published goes to nobody; objects are kept and announced for those who lack them.
  void hold(bool held) { held_ = held; }
  /// Delivers to the node what has come; waits up to `wait` when nothing has. Returns the number delivered.
  std::size_t dispatch(std::chrono::milliseconds wait);

  /// How the node fares, for HEALTH.
  void report(std::map<std::string, std::int64_t> counters, std::string summary);
  /// An elder process of the same name that was heard, if any.
  std::optional<Identity> elder_twin() const;
  /// Whether objects of a channel are not whole yet, and still asked for.
  bool lacks(std::string_view channel) const;
  /// Waits until what was published has gone, up to `wait`.
  void drain(std::chrono::milliseconds wait) const;

 private:
  struct Input {
    SteadyTime heard = 0;
    std::int64_t received = 0;  // Good or bad.
    std::int64_t bad = 0;
    Spacing spacing;  // Of what is not cut in pieces.
  };

  void send(std::string_view channel, std::span<const std::uint8_t> bytes);
  void every_second();
  void forward(const BusMessage& message);
  bool is_good(const BusMessage& message, Input& input);
  void listen();
  void note_lacking();
  Health health();
  void count_inputs(Health& health) const;

  LcmBus& lcm_;
  const Identity who_;
  LiveBusOptions options_;
  ObjectSender sender_;
  ObjectReceiver receiver_;  // Of the bus's own thread.
  Inbox inbox_;
  Subscriptions subscriptions_;  // Of the node.
  std::map<std::string, Input, std::less<>> inputs_;
  Traffic sent_;
  std::string last_fault_;
  SteadyTime next_ask_ = 0, next_second_ = 0;
  std::int64_t drops_before_;
  std::atomic<bool> held_ = false;
  std::atomic<bool> ending_ = false;
  mutable std::mutex mutex_;                                            // Of what follows.
  std::map<std::string, std::vector<std::uint8_t>, std::less<>> said_;  // What is repeated, by channel.
  std::map<std::string, std::int64_t> node_counters_;
  std::string node_summary_;
  std::optional<Identity> elder_;
  std::set<std::string, std::less<>> lacking_;  // Channels.
  std::thread thread_;
};

}  // namespace scanway
