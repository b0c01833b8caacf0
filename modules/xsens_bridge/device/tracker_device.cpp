#include "modules/xsens_bridge/device/tracker_device.h"

#include <poll.h>

#include <algorithm>
#include <array>

#include "common/clock/host_time.h"
#include "common/files/input_error.h"
#include "modules/xsens_bridge/core/mtdata.h"
#include "modules/xsens_bridge/core/mtdata2.h"

namespace scanway::xsens {
namespace {

constexpr Utime kBaudPatience = 3 * kMicrosecondsPerSecond / 2;  // To hear anything at one rate.
constexpr int kBitsPerByte = 10;                                 // On the line: start bit, eight bits, stop bit.
// The factory's first, then what public drivers set.
constexpr std::array kBauds = {115200, 460800, 921600, 230400, 57600, 38400, 19200, 9600};

void add(TrackerCounters& sum, const TrackerCounters& more) {
  sum.messages += more.messages;
  sum.data_messages += more.data_messages;
  sum.bad_bytes += more.bad_bytes;
  sum.errors += more.errors;
  sum.unanswered += more.unanswered;
  sum.wake_ups += more.wake_ups;
}

}  // namespace

TrackerDevice::TrackerDevice(const TrackerAddress& address, const TrackerConfig& config,
                             const TrackerAccuracy& accuracy)
    : address_(address), config_(config), accuracy_(accuracy) {}

TrackerNews TrackerDevice::run(int timeout_ms) {
  TrackerNews news;
  try {
    open_if_due(steady_now());
    if (port_) talk(steady_now(), timeout_ms, news);
  } catch (const InputError& error) {
    give_up(error.what(), steady_now(), news);
  }
  if (!port_) poll(nullptr, 0, timeout_ms);
  return news;
}

TrackerCounters TrackerDevice::counters() const {
  TrackerCounters sum = earlier_;
  if (dialogue_) add(sum, dialogue_->counters());
  return sum;
}

int TrackerDevice::next_baud() { return address_.baud != 0 ? address_.baud : kBauds[baud_index_ % kBauds.size()]; }

void TrackerDevice::open_if_due(Utime now) {
  if (port_ || !back_off_.due(now)) return;
  port_.emplace(address_.port, next_baud());
  clock_.restart();
  dialogue_.emplace(config_, now);
  opened_ = now;
  ++openings_;
}

void TrackerDevice::talk(Utime now, int timeout_ms, TrackerNews& news) {
  std::array<std::uint8_t, 4096> buffer;
  const std::size_t count = port_->read(buffer, timeout_ms);
  dialogue_->receive(std::span(buffer).first(count), now);
  dialogue_->tick(now);
  port_->write(dialogue_->take_output());
  for (const DataMessage& data : dialogue_->take_data()) read(data, news);
  for (const std::string& note : dialogue_->take_notes()) news.notes.push_back(address_.port + ": " + note);
  if (dialogue_->state() == Dialogue::State::failed) {
    give_up(address_.port + ": " + dialogue_->failure() + advice(), now, news);
  } else if (now - opened_ > kBaudPatience && dialogue_->counters().messages == 0) {
    doubt_baud(now, news);
  }
}

/// Nothing that makes sense was heard for a while.
void TrackerDevice::doubt_baud(Utime now, TrackerNews& news) {
  if (address_.baud != 0) {
    if (dialogue_->counters().bad_bytes == 0) return;  // It may still be starting.
    give_up(address_.port + ": no tracker answers at " + std::to_string(address_.baud) + " baud" + advice(), now, news);
  } else if (++baud_index_ % kBauds.size() == 0) {
    // All rates were tried: what was heard, if anything, is no tracker's.
    give_up(address_.port + ": no tracker answers at any rate" + advice(), now, news);
  } else {
    close();  // And at once on to the next.
  }
}

void TrackerDevice::read(const DataMessage& data, TrackerNews& news) {
  try {
    const TrackerReading reading = make_reading(items_of(data.message), accuracy_);
    const Utime on_the_line = static_cast<Utime>(data.frame_bytes) * kBitsPerByte * kMicrosecondsPerSecond / baud();
    news.readings.push_back({reading, time_of(reading, host_now() - on_the_line)});
    back_off_.succeeded();
  } catch (const BadMessage&) {
    ++bad_messages_;
  }
}

std::vector<Item> TrackerDevice::items_of(const Message& message) const {
  return message.mid == kMtData ? parse_mtdata(message.data, dialogue_->info().layout) : parse_mtdata2(message.data);
}

/// By the device's own clock where it says it; older trackers only count their messages, one a period.
Utime TrackerDevice::time_of(const TrackerReading& reading, Utime arrival) {
  std::optional<std::int64_t> ticks;
  DeviceClockModel model{100, std::int64_t{1} << 32};
  if (reading.sample_time_fine) {
    ticks = *reading.sample_time_fine;
  } else if (reading.packet_counter && dialogue_->info().legacy) {
    ticks = *reading.packet_counter;
    model = {kMicrosecondsPerSecond / std::max<int>(1, config_.rate_hz), std::int64_t{1} << 16};
  }
  if (!ticks) return arrival;
  if (!(model == model_)) clock_ = DeviceClock(model_ = model);
  clock_.observe(*ticks, arrival);
  return clock_.to_host(*ticks).value_or(arrival);
}

void TrackerDevice::close() {
  if (dialogue_) add(earlier_, dialogue_->counters());
  dialogue_.reset();
  port_.reset();
}

std::string TrackerDevice::advice() const {
  const bool noise = dialogue_ && dialogue_->counters().messages == 0 && dialogue_->counters().bad_bytes > 0;
  if (noise) return "; bytes come, but none of a tracker: is the rate right, and is it a tracker on this port?";
  return "; check its power and cable, and that the port is the tracker's";
}

void TrackerDevice::give_up(const std::string& reason, Utime now, TrackerNews& news) {
  if (back_off_.failed(reason, now)) news.notes.push_back(reason);
  close();
}

}  // namespace scanway::xsens
