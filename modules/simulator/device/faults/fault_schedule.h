#pragma once

#include <optional>
#include <vector>

#include "modules/simulator/device/faults/fault.h"

namespace scanway::simulator {

/// Which faults come and go when.
class FaultSchedule {
 public:
  /// From `begin` on the kind has that value; at `end`, and with a value of 0, all is well again.
  struct Change {
    FaultKind kind{};
    double value = 0.0;
  };

  /// Of two faults of a kind the one that begins later counts from then on.
  void add(const Fault& fault);
  /// What changes up to now, in the order of its times.
  std::optional<Change> next(Utime now);

 private:
  struct Event {
    Utime time;
    Change change;
  };
  void insert(const Event& event);

  std::vector<Event> events_;  // By time.
};

}  // namespace scanway::simulator
