#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/bus/bus.h"
#include "common/messages/object_assembler.h"
#include "common/time/utime.h"
#include "modules/mapper/node/sweep_store.h"

namespace scanway {

/// Keeps each sweep as soon as it has arrived whole, while the mapper may still be at work on the one before: a sweep
/// is not sent again to a mapper that dies. Of its own thread; the mapper keeps the sweep anew when it closes it.
class ArrivalKeeper {
 public:
  /// `store` must outlive this.
  explicit ArrivalKeeper(const SweepStore& store) : store_(store) {}

  /// IMU and SWEEP, before the mapper gets them. Others are left alone.
  void take(const BusMessage& message);

 private:
  void keep(Object sweep);

  const SweepStore& store_;
  ObjectAssembler sweeps_;
  Utime imu_utime_ = 0;
  std::vector<std::uint8_t> imu_;  // The newest that came; empty: none.
};

}  // namespace scanway
