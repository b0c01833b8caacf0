#include "modules/base_bridge/node/base_node.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cmath>
#include <utility>
#include <vector>

#include "bot_core/pose_t.hpp"
#include "common/bus/channels.h"
#include "common/math/repeatable.h"
#include "common/messages/bad_message.h"
#include "common/messages/codec.h"

namespace scanway::erratic {
namespace {

/// How long a refusal stands in the summary.
constexpr Utime kRefusalShown = 10 * kMicrosecondsPerSecond;
/// Of a 12 V lead battery under load: a rule of thumb.
constexpr double kLowBattery_V = 11.5;

bool is_trouble(const BaseEvent& event) {
  return event.kind != BaseEvent::Kind::found && event.kind != BaseEvent::Kind::text;
}

}  // namespace

BaseNode::BaseNode(Bus& bus, Base& base) : bus_(bus), base_(base) {
  bus_.subscribe(channel::kBaseCommand.name, [this](const BusMessage& message) { take(message); });
}

void BaseNode::take(const BusMessage& message) {
  try {
    waiting_ = decode<base_command_t>(message.bytes);
    ++commands_;
  } catch (const BadMessage&) {
    ++bad_messages_;
  }
}

void BaseNode::obey(Utime now) {
  const auto command = std::exchange(waiting_, std::nullopt);
  if (!command) return;
  const std::string refusal = base_.drive(command->forward_speed_m_s, command->turn_rate_rad_s, now);
  if (refusal.empty()) return;
  ++refused_;
  if (refusal != last_refusal_ || now - refused_at_ > kRefusalShown) spdlog::warn("command refused: {}", refusal);
  last_refusal_ = refusal;
  refused_at_ = now;
}

void BaseNode::tell() {
  if (base_.ready() && base_.pose().utime != told_) publish_pose(base_.pose());
  base_.take_reports();
  for (const BaseEvent& event : base_.take_events()) {
    spdlog::log(is_trouble(event) ? spdlog::level::warn : spdlog::level::info, "{}", event.text);
    if (event.kind == BaseEvent::Kind::stalled) ++stalls_;
    if (event.kind == BaseEvent::Kind::motors_off) ++ran_out_;
  }
}

void BaseNode::publish_pose(const WheelPose& pose) {
  told_ = pose.utime;
  ++poses_;
  bot_core::pose_t message{};
  message.utime = pose.utime;
  message.pos[0] = pose.x_m;
  message.pos[1] = pose.y_m;
  message.vel[0] = pose.speed_m_s;
  message.orientation[0] = repeatable::cos(pose.heading / 2);
  message.orientation[3] = repeatable::sin(pose.heading / 2);
  message.rotation_rate[2] = pose.turn_rate_rad_s;
  bus_.publish(channel::kOdometry.name, encode(message), message.utime);
}

std::map<std::string, std::int64_t> BaseNode::counters() const {
  const BaseCounters& base = base_.counters();
  const auto count = [](std::uint64_t value) { return static_cast<std::int64_t>(value); };
  std::map<std::string, std::int64_t> counters = {{"base_commands", commands_},
                                                  {"base_commands_refused", refused_},
                                                  {"base_commands_ran_out", ran_out_},
                                                  {"base_bad_messages", bad_messages_},
                                                  {"base_poses", poses_},
                                                  {"base_stalls", stalls_},
                                                  {"base_motors_on", base_.motors_on() ? 1 : 0},
                                                  {"base_packets", count(base.packets)},
                                                  {"base_bad_bytes", count(base.bad_bytes)},
                                                  {"base_bad_packets", count(base.malformed)},
                                                  {"base_dropped_steps", count(base.dropped_steps)},
                                                  {"base_times_lost", count(base.times_lost)}};
  if (base_.motors()) counters["base_battery_mV"] = std::llround(base_.motors()->battery_V * 1000);
  return counters;
}

std::string BaseNode::summary(Utime now) const {
  if (!base_.ready()) return "the base does not answer";
  std::vector<std::string> sentences;
  if (!last_refusal_.empty() && now - refused_at_ < kRefusalShown) {
    sentences.push_back("command refused: " + last_refusal_);
  }
  if (base_.stalled()) sentences.push_back("a wheel is stalled");
  if (const auto& motors = base_.motors(); motors && motors->battery_V < kLowBattery_V) {
    sentences.push_back(fmt::format("the battery is low: {:.1f} V", motors->battery_V));
  }
  return fmt::format("{}", fmt::join(sentences, "; "));
}

}  // namespace scanway::erratic
