#include "modules/simulator/device/faults/fault_schedule.h"

#include <algorithm>

namespace scanway::simulator {

void FaultSchedule::add(const Fault& fault) {
  insert({fault.begin, {fault.kind, fault.value}});
  if (fault.end != Fault::kNever) insert({fault.end, {fault.kind, 0.0}});
}

void FaultSchedule::insert(const Event& event) {
  const auto later = [](const Event& a, const Event& b) { return a.time < b.time; };
  events_.insert(std::upper_bound(events_.begin(), events_.end(), event, later), event);
}

std::optional<FaultSchedule::Change> FaultSchedule::next(Utime now) {
  if (events_.empty() || events_.front().time > now) return std::nullopt;
  const Change change = events_.front().change;
  events_.erase(events_.begin());
  return change;
}

}  // namespace scanway::simulator
