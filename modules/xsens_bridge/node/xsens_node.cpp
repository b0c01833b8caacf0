#include "modules/xsens_bridge/node/xsens_node.h"

#include <fmt/format.h>

#include <limits>
#include <utility>

#include "bot_core/ins_t.hpp"
#include "common/bus/channels.h"
#include "common/messages/codec.h"
#include "common/messages/imu_message.h"

namespace scanway::xsens {
namespace {

std::int64_t count(std::uint64_t value) { return static_cast<std::int64_t>(value); }

std::int64_t millidegrees(double radians) { return std::llround(radians * 180e3 / M_PI); }

/// A vector that the tracker measured, in the base; what it did not measure stays NaN.
void put(const std::optional<Eigen::Vector3d>& v_sensor, const Eigen::Quaterniond& q_base_sensor, double (&v)[3]) {
  if (!v_sensor) return;
  const Eigen::Vector3d v_base = q_base_sensor * *v_sensor;
  for (int i = 0; i < 3; ++i) v[i] = v_base[i];
}

std::string welcome_of(const TrackerDevice& device) {
  const TrackerInfo& info = device.dialogue()->info();
  return fmt::format("{}: {} measures ({}, {} baud)", device.port(),
                     info.product_code.empty() ? "the tracker" : info.product_code, info.legacy ? "MTData" : "MTData2",
                     device.baud());
}

}  // namespace

TrackerAccuracy accuracy_of(const Robot::Tracker& tracker) { return {tracker.tilt_sigma, tracker.heading_sigma}; }

XsensNode::XsensNode(Bus& bus, TrackerDevice& device, const Robot::Tracker& tracker)
    : bus_(bus), device_(device), q_base_sensor_(tracker.R_base_tracker()) {}

std::vector<std::string> XsensNode::run(int timeout_ms) {
  TrackerNews news = device_.run(timeout_ms);
  notice_restart();
  if (!news.notes.empty()) complaint_ = news.notes.back();
  for (const TimedReading& timed : news.readings) take(timed);
  return std::move(news.notes);
}

std::string XsensNode::take_welcome() { return std::exchange(welcome_, {}); }

std::string XsensNode::summary() const {
  if (!device_.trouble().empty()) return device_.trouble();
  if (!device_.measuring() || !works_) return device_.port() + ": no orientation yet";
  std::vector<std::string> sentences;
  if (!newest_.healthy()) {
    sentences.push_back(
        fmt::format("the tracker's filter is not valid, or a sensor is at its limit: its orientation may "
                    "be {:.0f} times as far off",
                    kUnhealthyFactor));
  }
  if (!complaint_.empty()) sentences.push_back(complaint_);
  return fmt::format("{}", fmt::join(sentences, "; "));
}

std::map<std::string, std::int64_t> XsensNode::counters() const {
  const TrackerCounters device = device_.counters();
  return {{"xsens_messages", count(device.data_messages)},
          {"xsens_lost_messages", lost_},
          {"xsens_orientations", orientations_},
          {"xsens_unhealthy", unhealthy_},
          {"xsens_tilt_sigma_mdeg", millidegrees(newest_.tilt_sigma)},
          {"xsens_heading_sigma_mdeg", millidegrees(newest_.heading_sigma)},
          {"xsens_status", newest_.status.value_or(0)},
          {"xsens_bad_messages", count(device_.bad_messages())},
          {"xsens_bad_bytes", count(device.bad_bytes)},
          {"xsens_errors", count(device.errors)},
          {"xsens_unanswered", count(device.unanswered)},
          {"xsens_reboots", count(device.wake_ups)},
          {"xsens_openings", device_.openings()},
          {"xsens_clock_jumps", device_.clock_jumps()}};
}

/// A tracker that started anew counts anew.
void XsensNode::notice_restart() {
  const std::int64_t starts = device_.openings() + count(device_.counters().wake_ups);
  if (starts == starts_) return;
  starts_ = starts;
  gap_.restart();
  works_ = false;
  complaint_.clear();
}

void XsensNode::take(const TimedReading& timed) {
  const TrackerReading& reading = timed.reading;
  const int missing = reading.packet_counter ? gap_.missing_before(*reading.packet_counter) : 0;
  lost_ += missing;
  number_ = number_ == 0 ? reading.packet_counter.value_or(1) : number_ + missing + 1;
  if (!reading.q_world_sensor) return;
  newest_ = reading;
  ++orientations_;
  if (device_.dialogue() != nullptr && !std::exchange(works_, true)) welcome_ = welcome_of(device_);
  if (!reading.healthy()) ++unhealthy_;
  publish(timed, *reading.q_world_sensor);
}

void XsensNode::publish(const TimedReading& timed, const Eigen::Quaterniond& q_world_sensor) {
  bot_core::ins_t message = imu_message(timed.utime, (q_world_sensor * q_base_sensor_.conjugate()).normalized());
  message.device_time = number_;
  put(timed.reading.rate_of_turn, q_base_sensor_, message.gyro);
  put(timed.reading.magnetic_field, q_base_sensor_, message.mag);
  put(timed.reading.acceleration, q_base_sensor_, message.accel);
  message.pressure = timed.reading.pressure_pa.value_or(std::numeric_limits<double>::quiet_NaN());
  bus_.publish(channel::kImu.name, encode(message), timed.utime);
}

}  // namespace scanway::xsens
