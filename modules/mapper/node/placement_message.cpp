#include "modules/mapper/node/placement_message.h"

#include "common/messages/rigid.h"

namespace scanway {

registration_t registration_message(const SweepResult& result) {
  registration_t message{};
  message.utime = result.utime;
  message.scan_name = result.name;
  message.target_name = result.target;
  message.accepted = result.verdict == Verdict::accepted;
  message.reason = result.reason;
  message.probability = result.registration.probability;
  message.overlap = result.registration.overlap;
  message.inlier_rmse_m = result.registration.inlier_rmse_m;
  put_rows(result.X_map_sweep, message.T_map_scan);
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 6; ++column) {
      message.covariance[row * 6 + column] = result.registration.covariance(row, column);
    }
  }
  message.open_directions = result.registration.open_directions;
  message.nopen_directions = static_cast<std::int16_t>(message.open_directions.size());
  return message;
}

Pose base_pose(const SweepResult& result, const Sweep& sweep) {
  Pose X_map_base = result.X_map_sweep;
  if (result.change.ground.plane) {
    X_map_base.translation() = result.X_map_sweep * sweep.origin;
    X_map_base.translation().z() -= result.change.ground.sensor_height_m;
  }
  return X_map_base;
}

}  // namespace scanway
