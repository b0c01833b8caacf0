#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/bytes/counter_gap.h"
#include "modules/sick_bridge/core/start_up.h"

namespace scanway::sick {

/// A telegram that came, and the scan in it if it holds one.
struct Received {
  std::vector<std::uint8_t> frame;
  std::optional<Scan> scan;
  Utime arrival = 0;
};

/// All that happened, since the start of the dialogue.
struct DialogueCounters {
  std::uint64_t telegrams = 0;
  std::uint64_t scans = 0;
  std::uint64_t missed_scans = 0;      ///< Not sent by the device, or lost: by the scan counter.
  std::uint64_t missed_telegrams = 0;  ///< Lost on the way or bad: by the telegram counter.
  std::uint64_t bad_telegrams = 0;     ///< Whole, and not what their name promises.
  std::uint64_t bad_bytes = 0;         ///< That belong to no telegram.
  std::uint64_t errors = 0;            ///< sFA answers.
  std::uint64_t unanswered = 0;        ///< Requests.
};

/// The talk with a scanner over one connection, from the first byte to the stream of scans: bytes in, bytes out, the
/// time as an argument. What the device refuses is said in a note, and the dialogue goes on: each scan says itself what
/// it is.
class Dialogue {
 public:
  enum class State : std::uint8_t { finding_dialect, starting, measuring, failed };

  Dialogue(const LmsConfig& config, Utime now);

  void receive(std::span<const std::uint8_t> bytes, Utime now);
  /// Time goes by; to be called at least every 100 ms.
  void tick(Utime now);

  /// What to send to the device.
  std::string take_output();
  std::vector<Received> take_received();
  /// What a person should know, a line each.
  std::vector<std::string> take_notes();

  State state() const { return state_; }
  /// Why the dialogue failed, one line; the connection is of no use any more.
  const std::string& failure() const { return failure_; }
  std::optional<Dialect> dialect() const { return dialect_; }
  const DeviceInfo& info() const { return info_; }
  DialogueCounters counters() const;

 private:
  void try_dialect(Dialect dialect, Utime now);
  void start(Dialect dialect, Utime now);
  void send_step(Utime now);
  void finish_step(const std::string& trouble, Utime now);
  void ask_for_status(Utime now);
  void handle(const Stretch& stretch, Utime now);
  void handle_scan(Received& received, Utime now);
  void handle_answer(const Telegram& telegram, Utime now);
  void check_mode(const Scan& scan);
  void check_counters(const Scan& scan);
  void check_model();
  Utime patience_for_scans() const;
  void fail(const std::string& reason);

  LmsConfig config_;
  State state_ = State::finding_dialect;
  std::string failure_;
  FrameFinder finder_ = make_frame_finder();

  Dialect tried_;
  std::optional<Dialect> dialect_;
  Utime began_;
  Utime deadline_ = 0;  // Of the answer that is waited for.

  std::vector<Step> steps_;
  std::size_t step_ = 0;
  bool waiting_ = false;  // For the answer to steps_[step_].
  bool slowed_down_ = false;

  Utime next_status_ = 0;
  Utime last_scan_ = 0;
  CounterGap telegram_gap_, scan_gap_;
  bool first_scan_seen_ = false;

  DeviceInfo info_;
  DialogueCounters counters_;
  std::string output_;
  std::vector<Received> received_;
  std::vector<std::string> notes_;
};

}  // namespace scanway::sick
