#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/time/utime.h"
#include "modules/xsens_bridge/core/message.h"
#include "modules/xsens_bridge/core/replies.h"

namespace scanway::xsens {

/// What the bridge wants of the tracker.
struct TrackerConfig {
  std::uint16_t rate_hz = 100;
};

/// What the tracker said of itself; what it did not say is empty.
struct TrackerInfo {
  std::optional<std::uint32_t> device_id;
  std::string product_code;
  std::optional<Firmware> firmware;
  /// MTData, of an MTi, MTx or MTi-G; else MTData2.
  bool legacy = false;
  OutputLayout layout;  ///< Of MTData.
};

/// All that happened, since the start of the dialogue.
struct TrackerCounters {
  std::uint64_t messages = 0;
  std::uint64_t data_messages = 0;
  std::uint64_t bad_bytes = 0;   ///< That belong to no message.
  std::uint64_t errors = 0;      ///< Error messages.
  std::uint64_t unanswered = 0;  ///< Requests, each time that they were sent.
  std::uint64_t wake_ups = 0;    ///< The tracker started anew.
};

/// A message with measurements, in the order in which they came.
struct DataMessage {
  Message message;
  std::size_t frame_bytes = 0;  ///< On the line: how long it took to come.
  Utime arrival = 0;
};

/// The talk with a tracker on one serial line, from the first byte to the stream of measurements: bytes in, bytes out,
/// the time as an argument. It finds out itself whether the tracker is of the older kind. What the tracker refuses is
/// said in a note; without an answer to GoToConfig or without measurements the dialogue fails.
class Dialogue {
 public:
  enum class State : std::uint8_t { configuring, measuring, failed };

  Dialogue(const TrackerConfig& config, Utime now);
  Dialogue(const Dialogue&) = delete;
  Dialogue& operator=(const Dialogue&) = delete;

  void receive(std::span<const std::uint8_t> bytes, Utime now);
  /// Time goes by; to be called at least every 50 ms.
  void tick(Utime now);

  /// What to send to the tracker.
  std::vector<std::uint8_t> take_output();
  /// Measurements; only of state `measuring`: what was under way before belongs to other settings.
  std::vector<DataMessage> take_data();
  /// What a person should know, a line each.
  std::vector<std::string> take_notes();

  State state() const { return state_; }
  /// Why the dialogue failed, one line.
  const std::string& failure() const { return failure_; }
  const TrackerInfo& info() const { return info_; }
  TrackerCounters counters() const;

 private:
  struct Step {
    std::string purpose;  ///< "go to configuration": ends the sentence "the tracker does not ...".
    std::vector<std::uint8_t> request;
    std::uint8_t answer = 0;
    int tries = 3;
    bool required = false;
    std::function<std::string(const Message&)> accept;  ///< What is wrong with the answer, or empty.
  };

  void begin(Utime now);
  void add_questions();
  void add_current_settings();
  void add_legacy_settings();
  void add_start();
  void send_step(Utime now);
  void finish_step(const std::string& trouble, Utime now);
  void handle(const Stretch& stretch, Utime now);
  void handle_answer(const Message& message, Utime now);
  std::string accept_output_configuration(const Message& answer);
  std::string accept_configuration(const Message& answer);
  std::vector<OutputEntry> wanted_output() const;
  void fail(const std::string& reason);

  TrackerConfig config_;
  State state_ = State::configuring;
  std::string failure_;
  FrameFinder finder_ = make_frame_finder();
  std::vector<Step> steps_;
  std::size_t step_ = 0;
  int tries_left_ = 0;
  Utime deadline_ = 0;
  Utime last_data_ = 0;
  TrackerInfo info_;
  TrackerCounters counters_;
  std::vector<std::uint8_t> output_;
  std::vector<DataMessage> data_;
  std::vector<std::string> notes_;
};

}  // namespace scanway::xsens
