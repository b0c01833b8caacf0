#include "modules/simulator/node/raw_log.h"

#include <algorithm>

#include "common/bus/channels.h"
#include "common/messages/codec.h"

namespace scanway::simulator {
namespace {

constexpr Utime kBefore = kMicrosecondsPerSecond;
constexpr Utime kAfter = kMicrosecondsPerSecond / 2;
constexpr Utime kTrackerPeriod = 10'000;
constexpr Utime kPanTiltPeriod = 20'000;
constexpr Utime kOnTheWay = 1'000;  // From a measurement to its message.

/// What is still to be said, by the time at which it will be.
enum class Kind { tracker, pan_tilt, mark, line };
struct Event {
  Utime utime;
  Kind kind;
  int index;
};

std::vector<Event> events_of(const RawSweep& raw) {
  const ScanPattern& pattern = raw.pattern;
  std::vector<Event> events;
  const auto every = [&](Utime period, Kind kind) {
    int index = 0;
    for (Utime utime = pattern.start() - kBefore; utime <= pattern.end() + kAfter; utime += period) {
      events.push_back({utime + kOnTheWay, kind, index++});
    }
  };
  every(kTrackerPeriod, Kind::tracker);
  every(kPanTiltPeriod, Kind::pan_tilt);
  events.push_back({pattern.start() + kOnTheWay, Kind::mark, 0});
  events.push_back({pattern.end() + kOnTheWay, Kind::mark, 1});
  const auto line_takes = static_cast<Utime>(pattern.beams() * pattern.beam_period_us());
  for (int row = 0; row < raw.lines; ++row) {
    events.push_back({pattern.line_utime(raw.line_of(row)) + line_takes + kOnTheWay, Kind::line, row});
  }
  std::stable_sort(events.begin(), events.end(), [](const Event& a, const Event& b) { return a.utime < b.utime; });
  return events;
}

}  // namespace

void publish_raw_sweep(Bus& bus, const RawSweep& raw, const Tracker& tracker, const SweepNumbers& numbers) {
  const auto say = [&](const Channel& channel, const auto& message, Utime utime) {
    bus.publish(channel.name, encode(message), utime);
  };
  for (const Event& event : events_of(raw)) {
    const Utime measured = event.utime - kOnTheWay;
    switch (event.kind) {
      case Kind::tracker:
        say(channel::kImu, tracker_message(tracker.read(event.index), event.index, measured), event.utime);
        break;
      case Kind::pan_tilt:
        say(channel::kPanTiltState, joint_message(raw.pattern, measured), event.utime);
        break;
      case Kind::mark: {
        const std::int8_t mark = event.index == 0 ? sweep_mark_t::STARTED : sweep_mark_t::ENDED;
        say(channel::kSweepMark, mark_message(raw.pattern, mark, numbers), event.utime);
        break;
      }
      case Kind::line:
        for (const laser_line_t& piece : line_messages(raw, event.index, numbers)) {
          say(channel::kLaserLine, piece, event.utime);
        }
        break;
    }
  }
}

}  // namespace scanway::simulator
