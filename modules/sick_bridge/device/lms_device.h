#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/clock/back_off.h"
#include "common/time/device_clock.h"
#include "modules/sick_bridge/core/dialogue.h"
#include "modules/sick_bridge/device/tcp_client.h"

namespace scanway::sick {

struct LmsAddress {
  std::string host = "192.168.0.1";
  std::uint16_t port = 2112;
};

/// A scan, and when it was measured.
struct TimedScan {
  Scan scan;
  Utime utime = 0;  ///< Of its first beam, on the host's clock.
};

/// What came since the last call.
struct LmsNews {
  std::vector<TimedScan> scans;
  std::vector<std::vector<std::uint8_t>> frames;  ///< Every whole telegram as it came.
  std::vector<std::string> notes;                 ///< What a person should know, a line each.
};

/// A scanner that is kept running: connected, set up, and connected anew with growing pauses whenever it is gone,
/// absent, slow or silent. Never throws for what the device does.
class LmsDevice {
 public:
  LmsDevice(const LmsAddress& address, const LmsConfig& config);

  /// Waits at most `timeout_ms` for the device, and does what is due.
  LmsNews run(int timeout_ms);

  bool measuring() const { return dialogue_ && dialogue_->state() == Dialogue::State::measuring; }
  /// Of this connection, or nothing while there is none.
  const Dialogue* dialogue() const { return dialogue_ ? &*dialogue_ : nullptr; }
  /// Why there is no connection, or no scan since it was made anew, in one line; empty: it is not known to fail.
  const std::string& trouble() const { return back_off_.reason(); }
  std::string name() const { return client_.name(); }
  /// Of all connections.
  DialogueCounters counters() const;
  std::int64_t connections() const { return connections_; }
  std::int64_t clock_jumps() const { return clock_.jumps(); }

 private:
  void connect_if_due(Utime now);
  void talk(const std::vector<std::uint8_t>& bytes, Utime now, LmsNews& news);
  void collect(LmsNews& news);
  void give_up(const std::string& reason, Utime now, LmsNews& news);

  LmsConfig config_;
  TcpClient client_;
  BackOff back_off_{kMicrosecondsPerSecond / 2, 8 * kMicrosecondsPerSecond};
  Utime connecting_since_ = 0;
  std::optional<Dialogue> dialogue_;
  DialogueCounters earlier_;  // Of connections that are gone.
  DeviceClock clock_;
  std::int64_t connections_ = 0;
};

}  // namespace scanway::sick
