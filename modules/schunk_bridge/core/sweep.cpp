#include "modules/schunk_bridge/core/sweep.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace scanway::schunk {
namespace {

/// The mount swings a little after the axes stand.
constexpr Utime kSettleTime = 300'000;
/// A tilt that is off by more does not hold its angle.
constexpr double kTiltTolerance = radians(0.5L);

bool ended_badly(const Axis& axis) {
  const Motion::Outcome outcome = axis.motion().outcome();
  return outcome == Motion::Outcome::blocked || outcome == Motion::Outcome::failed;
}

bool moves_tilt(auto phase) {
  using Phase = decltype(phase);
  return phase == Phase::referencing_tilt || phase == Phase::placing;
}

bool moves_pan(auto phase) {
  using Phase = decltype(phase);
  return phase != Phase::idle && phase != Phase::referencing_tilt && phase != Phase::settling;
}

}  // namespace

std::string Sweep::why_not(const Axis& axis) const {
  if (axis.phase() != Axis::Phase::ready) return axis.config().name + " does not answer";
  if (axis.error() != 0) {
    return axis.config().name + " has error " + describe_code(axis.error()) + ": mend its cause and acknowledge it";
  }
  if (axis.motion().under_way() || (axis.state()->bits & state_bit::kMoving) != 0) {
    return axis.config().name + " is moving: stop it first";
  }
  if (!axis.referenced() && !config_.reference_if_needed) {
    return axis.config().name + " is not referenced: send it to its reference first";
  }
  return {};
}

std::string Sweep::start(Utime now) {
  if (active()) return "a sweep is under way: stop it first";
  for (const Axis* axis : {&tilt_, &pan_}) {
    if (std::string why = why_not(*axis); !why.empty()) return why;
  }
  const auto [low, high] = std::minmax({config_.start, config_.start + config_.angle});
  if (low < pan_.low() || high > pan_.high()) return "the sweep goes beyond the limits of the pan axis";
  if (!(config_.speed > 0 && config_.speed <= pan_.max_speed())) {
    return "the sweep's speed is none that the pan axis can go at";
  }
  if (!(config_.tilt >= tilt_.low() && config_.tilt <= tilt_.high()))
    return "the sweep's tilt is beyond the tilt's limits";
  active_config_ = config_;
  ++number_;
  started_ = false;
  enter(Phase::referencing_tilt, now);
  return {};
}

void Sweep::enter(Phase phase, Utime now) {
  phase_ = phase;
  since_ = now;
  std::string refusal;
  switch (phase) {
    case Phase::idle:
    case Phase::settling:
      break;
    case Phase::referencing_tilt:
      if (tilt_.referenced()) return enter(Phase::referencing_pan, now);
      refusal = tilt_.reference(now);
      break;
    case Phase::referencing_pan:
      if (pan_.referenced()) return enter(Phase::placing, now);
      refusal = pan_.reference(now);
      break;
    case Phase::placing:
      refusal = tilt_.move_to(active_config_.tilt, travel_speed(tilt_), now);
      if (refusal.empty()) refusal = pan_.move_to(active_config_.start, travel_speed(pan_), now);
      break;
    case Phase::scanning:
      refusal = pan_.move_to(end(), active_config_.speed, now);
      break;
    case Phase::returning:
      refusal = pan_.move_to(active_config_.start, travel_speed(pan_), now);
      break;
  }
  if (!refusal.empty()) abort(refusal, now);
}

void Sweep::advance(Utime now) {
  if (!active()) return;
  for (const Axis* axis : {&tilt_, &pan_}) {
    const std::string& name = axis->config().name;
    if (axis->phase() != Axis::Phase::ready) return abort(name + " does not answer any more", now);
    if (axis->error() != 0) return abort(name + " has error " + describe_code(axis->error()), now);
    const bool concerned = axis == &tilt_ ? moves_tilt(phase_) : moves_pan(phase_);
    if (concerned && ended_badly(*axis)) return abort(name + " did not get where it was sent", now);
  }
  if (phase_ == Phase::scanning) follow_scan(now);
  if (active() && !tilt_.motion().under_way() && !pan_.motion().under_way()) go_on(now);
}

void Sweep::go_on(Utime now) {
  switch (phase_) {
    case Phase::idle:
      return;
    case Phase::referencing_tilt:
      return enter(Phase::referencing_pan, now);
    case Phase::referencing_pan:
      return enter(Phase::placing, now);
    case Phase::placing:
      return enter(Phase::settling, now);
    case Phase::settling:
      if (now - since_ >= kSettleTime) enter(Phase::scanning, now);
      return;
    case Phase::scanning:
      tell(Event::Kind::sweep_ended, pan_.state()->utime, "ends");
      return enter(Phase::returning, now);
    case Phase::returning:
      tell(Event::Kind::sweep_done, now, "is done");
      return enter(Phase::idle, now);
  }
}

void Sweep::follow_scan(Utime now) {
  if (!started_ && pan_.motion().accepted()) {
    started_ = true;
    tell(Event::Kind::sweep_started, pan_.state()->utime, "begins");
  }
  if (std::fabs(tilt_.state()->position - active_config_.tilt) > kTiltTolerance) {
    abort("the tilt does not hold its angle", now);
  }
}

void Sweep::abort(const std::string& reason, Utime now) {
  cancel(reason, now);
  for (Axis* axis : {&pan_, &tilt_}) {
    if (axis->motion().under_way()) axis->stop();
  }
}

void Sweep::cancel(const std::string& reason, Utime now) {
  if (!active()) return;
  // What it scanned is whole once it is on its way back.
  const bool whole = phase_ == Phase::returning;
  phase_ = Phase::idle;
  if (whole) {
    tell(Event::Kind::sweep_done, now, "is done, and its way back is given up: " + reason);
  } else {
    tell(Event::Kind::sweep_aborted, now, "is given up: " + reason, reason);
  }
}

double Sweep::travel_speed(const Axis& axis) const { return std::min(active_config_.travel_speed, axis.max_speed()); }

void Sweep::tell(Event::Kind kind, Utime utime, const std::string& text, const std::string& reason) {
  Event event;
  event.kind = kind;
  event.utime = utime;
  event.sweep = number_;
  if (pan_.state()) event.position = pan_.state()->position;
  event.reason = reason;
  event.text = "sweep " + std::to_string(number_) + " " + text;
  events_.push_back(std::move(event));
}

std::vector<Event> Sweep::take_events() { return std::exchange(events_, {}); }

}  // namespace scanway::schunk
