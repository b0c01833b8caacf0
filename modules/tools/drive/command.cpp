#include "modules/tools/drive/command.h"

#include <cstdio>
#include <functional>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "common/bus/channels.h"
#include "common/clock/host_time.h"
#include "common/files/printable.h"
#include "common/math/angle.h"
#include "common/messages/codec.h"
#include "modules/tools/drive/dialogue.h"
#include "scanway/health_t.hpp"
#include "scanway/pan_tilt_command_t.hpp"
#include "scanway/registration_t.hpp"
#include "scanway/sweep_mark_t.hpp"

namespace scanway::tools {
namespace {

constexpr int kRefused = 1;
constexpr const char* kBridge = "schunk_bridge";
constexpr SteadyTime kSayAgain = 200'000;
/// The bridge is on HEALTH once a second.
constexpr SteadyTime kLongestSilence = 5'000'000;

using Command = pan_tilt_command_t;

Command message_of(const CommandOptions& options) {
  static const std::map<std::string, std::int8_t> kCommands = {{"sweep", Command::SWEEP},
                                                               {"move", Command::MOVE},
                                                               {"turn", Command::VELOCITY},
                                                               {"reference", Command::REFERENCE},
                                                               {"stop", Command::STOP},
                                                               {"fast-stop", Command::FAST_STOP},
                                                               {"acknowledge", Command::ACKNOWLEDGE}};
  const auto to_radians = [](const std::optional<double>& degrees) {
    return degrees ? *degrees * radians(1.0L) : std::numeric_limits<double>::quiet_NaN();
  };
  Command message{};
  message.utime = host_now();
  message.command = kCommands.at(options.what);
  message.pan_rad = to_radians(options.pan_deg);
  message.tilt_rad = to_radians(options.tilt_deg);
  message.pan_speed_rad_s = to_radians(options.pan_speed_deg_s);
  message.tilt_speed_rad_s = to_radians(options.tilt_speed_deg_s);
  return message;
}

/// What the bridge says.
class Bridge {
 public:
  explicit Bridge(const std::string& lcm_url) : talk_(lcm_url, {"scanway-schunk", kLongestSilence}) {
    talk_.hear<health_t>(channel::kHealth, [this](const health_t& message) {
      if (message.process_name == kBridge) take(message);
    });
    talk_.hear<sweep_mark_t>(channel::kSweepMark, [this](const sweep_mark_t& mark) {
      marks_[{mark.numbered_since, mark.sweep}] = mark;
    });
    talk_.hear<registration_t>(channel::kRegistration,
                               [this](const registration_t& verdict) { verdicts_[verdict.utime] = verdict; });
  }

  /// Returns when it says what became of the command.
  void tell(const Command& command) {
    talk_.say_until([&] { return answers(command.utime); }, kSayAgain, channel::kPanTiltCommand, encode(command));
  }
  void listen() { talk_.listen(); }
  /// As it said last; below 0: it did not say yet.
  std::int64_t counter(const std::string& name) const {
    const auto found = counters_.find("schunk_" + name);
    return found == counters_.end() ? -1 : found->second;
  }
  const std::string& summary() const { return summary_; }
  /// The newest mark of that sweep, if there is one.
  std::optional<sweep_mark_t> mark_of(std::int64_t sweep) const {
    const auto found = marks_.find({start_, sweep});
    return found == marks_.end() ? std::nullopt : std::optional(found->second);
  }
  /// What became of the sweep that began then.
  const registration_t* verdict_since(Utime begun) const {
    const auto found = verdicts_.upper_bound(begun);
    return found == verdicts_.end() ? nullptr : &found->second;
  }

 private:
  /// Whether it says what became of the command of that time; then what it says of all is of that moment.
  bool answers(Utime command) const {
    return counter("last_command") == command && counter("last_command_refused") >= 0 && counter("sweep") >= 0;
  }

  /// HEALTH comes in several messages of one time, each with its share of the counters.
  void take(const health_t& message) {
    if (message.utime != said_) counters_.clear();
    said_ = message.utime;
    start_ = message.start_utime;
    summary_ = message.summary;
    for (const counter_t& one : message.counters) counters_[one.counter_name] = one.count;
    talk_.note_partner();
  }

  Dialogue talk_;
  Utime said_ = 0, start_ = 0;
  std::string summary_;
  std::map<std::string, std::int64_t> counters_;
  std::map<std::pair<Utime, std::int64_t>, sweep_mark_t> marks_;
  std::map<Utime, registration_t> verdicts_;  // By the sweep's last point.
};

int follow_registration(Bridge& bridge, Utime begun) {
  const registration_t* verdict = nullptr;
  while ((verdict = bridge.verdict_since(begun)) == nullptr) bridge.listen();
  const char* what = verdict->accepted != 0 ? "accepted" : "refused";
  const std::string line = fmt::format("{} is {}, probability {:.2f}", verdict->scan_name, what, verdict->probability);
  std::puts(printable(verdict->accepted != 0 ? line : line + ": " + verdict->reason).c_str());
  return verdict->accepted != 0 ? 0 : kRefused;
}

int follow_sweep(Bridge& bridge, bool registered) {
  const std::int64_t sweep = bridge.counter("sweep");
  bool begun = false;
  Utime begun_at = 0;
  for (;; bridge.listen()) {
    const auto mark = bridge.mark_of(sweep);
    if (!mark) continue;
    if (!begun && mark->mark != sweep_mark_t::ABORTED) {
      const double seconds = mark->sweep_angle_rad / mark->pan_speed_rad_s;
      std::puts(fmt::format("sweep {} has begun; it takes {:.0f} s", sweep, seconds).c_str());
      std::fflush(stdout);
      begun = true;
    }
    if (mark->mark == sweep_mark_t::STARTED) begun_at = mark->utime;
    if (mark->mark == sweep_mark_t::ENDED) {
      if (begun_at == 0) begun_at = mark->utime - kSteadySecond;  // Its start was not heard; its last points were then.
      std::puts(fmt::format("sweep {} has ended", sweep).c_str());
      std::fflush(stdout);
      return registered ? follow_registration(bridge, begun_at) : 0;
    }
    if (mark->mark == sweep_mark_t::ABORTED) {
      std::puts(fmt::format("sweep {} was given up: {}", sweep, printable(mark->reason)).c_str());
      return kRefused;
    }
  }
}

}  // namespace

int run_command(const CommandOptions& options) {
  const Command message = message_of(options);
  Bridge bridge(options.lcm_url);
  bridge.tell(message);
  if (bridge.counter("last_command_refused") != 0) {
    std::puts(printable(bridge.summary()).c_str());
    return kRefused;
  }
  if (message.command == Command::SWEEP) return follow_sweep(bridge, options.registered);
  std::puts("taken");
  return 0;
}

}  // namespace scanway::tools
