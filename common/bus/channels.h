#pragma once

#include <string_view>

namespace scanway {

/// A channel of the bus: the type of its messages, and whether they are cut in pieces (scanway.piece_t carries them
/// then). lcmtypes/README.md says who publishes and who reads; a test compares the two.
struct Channel {
  std::string_view name;
  std::string_view type;  ///< package.struct
  bool cut = false;
  std::string_view also = {};  ///< Another type that its messages may have, which holds more; empty: none.

  constexpr bool carries(std::string_view message_type) const {
    return message_type == type || (!also.empty() && message_type == also);
  }
};

namespace channel {

inline constexpr Channel kParams{"PARAMS", "scanway.params_t", true};
inline constexpr Channel kImu{"IMU", "bot_core.ins_t", false};
inline constexpr Channel kPanTiltState{"PAN_TILT_STATE", "bot_core.joint_state_t", false};
inline constexpr Channel kOdometry{"ODOMETRY", "bot_core.pose_t", false};
inline constexpr Channel kLaserLine{"LASER_LINE", "scanway.laser_line_t", false};
inline constexpr Channel kSweepMark{"SWEEP_MARK", "scanway.sweep_mark_t", false};
inline constexpr Channel kSweep{"SWEEP", "scanway.sweep_t", true, "scanway.full_sweep_t"};
inline constexpr Channel kReferencePose{"REFERENCE_POSE", "scanway.reference_pose_t", false};
inline constexpr Channel kSweepInputs{"SWEEP_INPUTS", "scanway.sweep_inputs_t", false};
inline constexpr Channel kRegistration{"REGISTRATION", "scanway.registration_t", false};
inline constexpr Channel kPose{"POSE", "bot_core.pose_t", false};
inline constexpr Channel kCloudTile{"CLOUD_TILE", "scanway.cloud_tile_t", true};
inline constexpr Channel kOctomap{"OCTOMAP", "scanway.octomap_t", true};
inline constexpr Channel kMapCommand{"MAP_COMMAND", "scanway.map_command_t", false};
inline constexpr Channel kMapAnswer{"MAP_ANSWER", "scanway.map_answer_t", false};
inline constexpr Channel kMapRequest{"MAP_REQUEST", "scanway.map_request_t", false};
inline constexpr Channel kCloudLevel{"CLOUD_LEVEL", "scanway.cloud_tile_t", true};
inline constexpr Channel kOctomapLevel{"OCTOMAP_LEVEL", "scanway.octomap_t", true};
inline constexpr Channel kMapLevel{"MAP_LEVEL", "scanway.map_level_t", true};
inline constexpr Channel kCostMapTile{"COST_MAP_TILE", "scanway.cost_tile_t", true};
inline constexpr Channel kCostMapIndex{"COST_MAP_INDEX", "scanway.cost_map_index_t", true};
inline constexpr Channel kGoal{"GOAL", "scanway.goal_t", false};
inline constexpr Channel kPath{"PATH", "scanway.path_t", true};
inline constexpr Channel kMapState{"MAP_STATE", "scanway.map_state_t", false};
inline constexpr Channel kLaserScan{"LASER_SCAN", "bot_core.planar_lidar_t", false};
inline constexpr Channel kLaserRaw{"LASER_RAW", "bot_core.raw_t", false};
inline constexpr Channel kLineRequest{"LINE_REQUEST", "scanway.line_request_t", false};
inline constexpr Channel kPanTiltCommand{"PAN_TILT_COMMAND", "scanway.pan_tilt_command_t", false};
inline constexpr Channel kBaseCommand{"BASE_COMMAND", "scanway.base_command_t", false};
inline constexpr Channel kObjectIndex{"OBJECT_INDEX", "scanway.object_index_t", false};
inline constexpr Channel kPieceRequest{"PIECE_REQUEST", "scanway.piece_request_t", false};
inline constexpr Channel kHealth{"HEALTH", "scanway.health_t", false};
inline constexpr Channel kTiming{"TIMING", "scanway.timing_t", false};

}  // namespace channel

/// All of them. Of data with the same time, those of the channel that stands first here go first (ordered_merge.h).
inline constexpr Channel kChannels[] = {
    channel::kParams,         channel::kImu,           channel::kPanTiltState,
    channel::kOdometry,       channel::kLaserLine,     channel::kSweepMark,
    channel::kSweep,          channel::kReferencePose, channel::kSweepInputs,
    channel::kRegistration,   channel::kPose,          channel::kCloudTile,
    channel::kOctomap,        channel::kCostMapTile,   channel::kCostMapIndex,
    channel::kGoal,           channel::kPath,          channel::kMapState,
    channel::kLaserScan,      channel::kLaserRaw,      channel::kLineRequest,
    channel::kPanTiltCommand, channel::kBaseCommand,   channel::kObjectIndex,
    channel::kPieceRequest,   channel::kHealth,        channel::kTiming,
    channel::kMapCommand,     channel::kMapAnswer,     channel::kMapRequest,
    channel::kCloudLevel,     channel::kOctomapLevel,  channel::kMapLevel,
};

/// The channel of that name, or nullptr.
constexpr const Channel* find_channel(std::string_view name) {
  for (const Channel& known : kChannels) {
    if (known.name == name) return &known;
  }
  return nullptr;
}

}  // namespace scanway
