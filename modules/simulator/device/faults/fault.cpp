#include "modules/simulator/device/faults/fault.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "common/files/input_error.h"
#include "common/files/printable.h"

namespace scanway::simulator {
namespace {

using enum FaultKind;

constexpr double kMostSeconds = 1e6;

// In the order of FaultKind.
constexpr std::array<FaultForm, 15> kForms = {{
    {lms_loss, "lms-loss", 1e-4, 1.0, "share of the laser's bytes that are lost"},
    {tracker_loss, "tracker-loss", 0.01, 1.0, "share of the tracker's bytes that are lost"},
    {base_loss, "base-loss", 0.01, 1.0, "share of the base's bytes that are lost"},
    {pan_stuck, "pan-stuck", 1, 1, "the pan cannot turn: error TOW"},
    {tilt_stuck, "tilt-stuck", 1, 1, "the tilt cannot turn: error TOW"},
    {dirty_window, "dirty-window", 0.7, 1.0, "share of the light that the laser's window keeps back"},
    {lms_reboot, "lms-reboot", 5.0, 600, "the laser restarts and is gone for so many seconds"},
    {pan_tilt_reboot, "pan-tilt-reboot", 2.5, 600, "both modules of the pan-tilt restart, the same"},
    {tracker_reboot, "tracker-reboot", 2.0, 600, "the tracker restarts, the same"},
    {base_reboot, "base-reboot", 3.0, 600, "the base restarts and counts from zero, the same"},
    {heading_bias, "heading-bias", 5.0, 180, "degrees by which the tracker's heading is off"},
    {tilt_bias, "tilt-bias", 1.0, 90, "degrees by which the tracker's roll is off"},
    {range_bias, "range-bias", 0.05, 10, "metres by which the laser measures too far"},
    {slip, "slip", 0.1, 1.0, "share of the wheels' way that gets lost, on average"},
    {people, "people", 3, 50, "how many walk about near where the robot stands"},
}};

bool has_sign(FaultKind kind) { return kind == heading_bias || kind == tilt_bias || kind == range_bias; }

[[noreturn]] void refuse(std::string_view text, const std::string& why) {
  throw InputError("fault " + in_quotes(std::string(text)) + ": " + why);
}

/// Takes what follows `mark` off the end of `text`; nothing if it is not there.
std::optional<double> take_number(std::string_view whole, std::string_view& text, char mark) {
  const std::size_t at = text.find(mark);
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view digits = text.substr(at + 1);
  double number = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(number)) {
    refuse(whole, "a number has to follow '" + std::string(1, mark) + "', as in pan-stuck@10+5");
  }
  text = text.substr(0, at);
  return number;
}

Utime microseconds(std::string_view whole, double seconds) {
  if (!(seconds >= 0.0 && seconds <= kMostSeconds)) refuse(whole, "give its times in seconds, from 0 to 1000000");
  return std::llround(seconds * 1e6);
}

}  // namespace

std::span<const FaultForm> fault_forms() { return kForms; }

const FaultForm& form_of(FaultKind kind) { return kForms.at(static_cast<std::size_t>(kind)); }

Fault parse_fault(std::string_view text, Utime now) {
  const std::size_t at = std::min(text.find('@'), text.size());
  std::string_view head = text.substr(0, at), times = text.substr(at);
  const auto lasts = take_number(text, times, '+'), after = take_number(text, times, '@');
  if (!times.empty()) refuse(text, "NAME[=VALUE][@SECONDS[+SECONDS]], as in pan-stuck@10+5");
  const auto value = take_number(text, head, '=');
  const auto form = std::find_if(kForms.begin(), kForms.end(), [&](const FaultForm& one) { return one.name == head; });
  if (form == kForms.end()) refuse(text, "there is no such fault; see scanway-simulator --help");
  Fault fault{form->kind, value.value_or(form->value), now, Fault::kNever};
  if (std::fabs(fault.value) > form->most || (fault.value < 0.0 && !has_sign(fault.kind))) {
    refuse(text, "its value is beyond its limit (" + std::string(form->what) + ")");
  }
  fault.begin += microseconds(text, after.value_or(0.0));
  if (lasts) fault.end = fault.begin + microseconds(text, *lasts);
  return fault;
}

}  // namespace scanway::simulator
