// What goes wrong with the robot, and when.

#include <cmath>

#include <fmt/format.h>

#include "common/math/angle.h"
#include "modules/simulator/device/robot/robot_in_world.h"

namespace scanway::simulator {
namespace {

// With less than this light the scanner warns, and with less than that it reports an error.
constexpr double kDirtWarning = 0.7, kDirtError = 0.4;

std::string news_of(const FaultSchedule::Change& change) {
  const FaultForm& form = form_of(change.kind);
  if (change.value == 0.0) return fmt::format("{} has ended", form.name);
  return fmt::format("{}={}: {}", form.name, change.value, form.what);
}

Utime microseconds(double seconds) { return std::llround(seconds * 1e6); }

}  // namespace

void RobotInWorld::begin_faults(Utime now) {
  while (const auto change = faults_.next(now)) {
    news_.push_back(news_of(*change));
    set(*change, now);
  }
}

void RobotInWorld::set(const FaultSchedule::Change& change, Utime now) {
  const double value = change.value;
  switch (change.kind) {
    case FaultKind::lms_loss:
      return lms_loss_.set_share(value);
    case FaultKind::tracker_loss:
      return tracker_loss_.set_share(value);
    case FaultKind::base_loss:
      return base_loss_.set_share(value);
    case FaultKind::pan_stuck:
      return pan_.jam(value != 0.0);
    case FaultKind::tilt_stuck:
      return tilt_.jam(value != 0.0);
    case FaultKind::dirty_window:
      return set_window(value);
    case FaultKind::lms_reboot:
      if (value == 0.0) return;
      lms_.reboot();
      lms_end_.shut();
      lms_power_.on = now + microseconds(value);
      return;
    case FaultKind::pan_tilt_reboot:
      if (value == 0.0) return;
      pan_.reboot(now, microseconds(value));
      return tilt_.reboot(now, microseconds(value));
    case FaultKind::tracker_reboot:
      if (value == 0.0) return;
      tracker_.reboot();
      tracker_power_.on = now + microseconds(value);
      return;
    case FaultKind::base_reboot:
      if (value == 0.0) return;
      base_.reboot();
      driven_.count_anew();
      base_power_.on = now + microseconds(value);
      return;
    case FaultKind::heading_bias:
      heading_bias_ = radians(value);
      return;
    case FaultKind::tilt_bias:
      tilt_bias_ = radians(value);
      return;
    case FaultKind::range_bias:
      return laser_.set_range_bias(value);
    case FaultKind::slip:
      return driven_.set_slip(value);
    case FaultKind::people:
      return laser_.put_people(static_cast<int>(value));
  }
}

void RobotInWorld::set_window(double kept_back) {
  using Window = LmsEmulator::Window;
  constexpr double kLeast = 1e-3;
  const double light = std::max(kLeast, 1.0 - kept_back);
  laser_.set_window(light);
  lms_.set_window(light < kDirtError     ? Window::dirt_error
                  : light < kDirtWarning ? Window::dirt_warning
                                         : Window::clean);
}

}  // namespace scanway::simulator
