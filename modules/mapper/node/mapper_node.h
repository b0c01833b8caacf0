#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Geometry>

#include "common/bus/bus.h"
#include "common/bus/ordered_merge.h"
#include "common/cloud/sweep.h"
#include "common/messages/object_assembler.h"
#include "common/progress/stages.h"
#include "modules/mapper/core/mapper.h"
#include "modules/mapper/node/map_publisher.h"
#include "scanway/sweep_inputs_t.hpp"

namespace scanway {

/// The mapper on the bus: SWEEP and IMU in, merged by their own time; SWEEP_INPUTS, REGISTRATION, POSE and the map's
/// products out.
class MapperNode {
 public:
  /// `bus` and `stages` must outlive this.
  MapperNode(Bus& bus, const Robot& robot, StageListener* stages = nullptr);

  /// No more input will come: what still waits for data with a later time is worked on now.
  void finish() { inputs_.flush(); }

  const Mapper& mapper() const { return mapper_; }
  const MapPublisher& published() const { return publisher_; }
  /// What was bad, late or incomplete so far, by name.
  std::map<std::string, std::int64_t> counters() const;

 private:
  struct Orientation {
    Utime utime = 0;
    Eigen::Quaterniond R_world_sweep;
    std::uint64_t digest = 0;
  };
  struct ArrivedSweep {
    Sweep sweep;
    std::uint64_t digest = 0;
  };
  using Input = std::variant<Orientation, ArrivedSweep>;

  void take_imu(const BusMessage& message);
  void take_piece(const BusMessage& message);
  void work_on(Input&& input);
  void add_sweep(ArrivedSweep&& arrived);
  sweep_inputs_t inputs_of(const ArrivedSweep& arrived) const;
  void publish_result(const SweepResult& result, const Sweep& sweep);

  Bus& bus_;
  StageListener* stages_;
  Mapper mapper_;
  MapPublisher publisher_;
  ObjectAssembler sweeps_;
  OrderedMerge<Input> inputs_;
  std::optional<Orientation> orientation_;  // The newest that the merge let go.
  std::int64_t bad_messages_ = 0;
};

}  // namespace scanway
