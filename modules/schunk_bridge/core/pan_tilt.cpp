#include "modules/schunk_bridge/core/pan_tilt.h"

#include <iterator>
#include <stdexcept>
#include <utility>

namespace scanway::schunk {
namespace {

/// Modules are said to lose frames that follow each other faster.
constexpr Utime kBetweenFrames = 1'000;

constexpr const char* kSweepUnderWay = "a sweep is under way: stop it first";

}  // namespace

PanTilt::PanTilt(const PanTiltConfig& config)
    : pan_(config.pan), tilt_(config.tilt), sweep_(config.sweep, pan_, tilt_) {
  if (config.pan.module == config.tilt.module || config.pan.module == 0 || config.tilt.module == 0) {
    throw std::invalid_argument("the module ids of pan and tilt must differ, and be 1 to 255");
  }
}

void PanTilt::receive(const CanFrame& frame, Utime now) {
  pan_.receive(frame, now);
  tilt_.receive(frame, now);
}

void PanTilt::watch_clock(Utime now) {
  if (now < ticked_) {
    // Measured by it, everything under way would take however long it was set back.
    stop(now);
    pan_.clock_was_set(now);
    tilt_.clock_was_set(now);
  }
  ticked_ = now;
}

void PanTilt::tick(Utime now) {
  watch_clock(now);
  pan_.tick(now);
  tilt_.tick(now);
  if (reference_pan_next_ && !tilt_.motion().under_way()) {
    reference_pan_next_ = false;
    if (tilt_.referenced()) pan_.reference(now);
  }
  sweep_.advance(now);
}

std::optional<CanFrame> PanTilt::next_frame(Utime now) {
  if (sent_ && now - *sent_ < kBetweenFrames && now >= *sent_) return std::nullopt;
  if (pan_.urgent() != tilt_.urgent()) pan_turn_ = pan_.urgent();
  auto frame = pan_turn_ ? pan_.next_frame(now) : tilt_.next_frame(now);
  if (!frame) frame = pan_turn_ ? tilt_.next_frame(now) : pan_.next_frame(now);
  pan_turn_ = !pan_turn_;
  if (frame) sent_ = now;
  return frame;
}

void PanTilt::frames_lost() {
  pan_.frames_lost();
  tilt_.frames_lost();
}

std::string PanTilt::move_pan(double position, double speed, Utime now) {
  return busy() ? kSweepUnderWay : pan_.move_to(position, speed, now);
}

std::string PanTilt::move_tilt(double position, double speed, Utime now) {
  return busy() ? kSweepUnderWay : tilt_.move_to(position, speed, now);
}

std::string PanTilt::turn_pan(double speed, Utime now) { return busy() ? kSweepUnderWay : pan_.move_at(speed, now); }

std::string PanTilt::turn_tilt(double speed, Utime now) { return busy() ? kSweepUnderWay : tilt_.move_at(speed, now); }

std::string PanTilt::reference(Utime now) {
  if (busy()) return kSweepUnderWay;
  if (tilt_.referenced()) return pan_.reference(now);
  std::string refusal = tilt_.reference(now);
  reference_pan_next_ = refusal.empty();
  return refusal;
}

void PanTilt::stop(Utime now) {
  reference_pan_next_ = false;
  sweep_.cancel("stopped by command", now);
  pan_.stop();
  tilt_.stop();
}

void PanTilt::fast_stop(Utime now) {
  reference_pan_next_ = false;
  sweep_.cancel("fast stop by command", now);
  pan_.fast_stop();
  tilt_.fast_stop();
}

std::string PanTilt::acknowledge() {
  std::string refusal = pan_.acknowledge();
  std::string tilts = tilt_.acknowledge();
  return refusal.empty() ? tilts : refusal;
}

std::vector<Event> PanTilt::take_events() {
  std::vector<Event> events = pan_.take_events();
  for (auto more : {tilt_.take_events(), sweep_.take_events()}) {
    events.insert(events.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  }
  return events;
}

}  // namespace scanway::schunk
