#include "modules/simulator/device/tracker/tracker_emulator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "common/bytes/big_endian.h"
#include "common/math/repeatable.h"

namespace scanway::simulator {
namespace {

enum : std::uint8_t {
  kReqDid = 0x00,
  kSetPeriod = 0x04,
  kReqConfiguration = 0x0C,
  kConfiguration = 0x0D,
  kGoToMeasurement = 0x10,
  kReqFirmware = 0x12,
  kSetBaudrate = 0x18,
  kReqProductCode = 0x1C,
  kGoToConfig = 0x30,
  kMtData2 = 0x36,
  kWakeUp = 0x3E,
  kWakeUpAck = 0x3F,
  kReset = 0x40,
  kError = 0x42,
  kSetStringOutput = 0x8E,
  kSetOutputConfiguration = 0xC0,
};
constexpr std::uint8_t kMessageInvalid = 4, kParameterInvalid = 33;

// An MTi-30, as recorded.
constexpr std::uint32_t kDeviceId = 0x0368248C;
constexpr std::string_view kProductCode = "MTi-30-2A8G4        ";
constexpr std::uint8_t kFirmware[] = {0x01, 0x08, 0x02, 0x00, 0x00, 0x00, 0x25, 0x00, 0x01, 0x15, 0x34};
constexpr std::uint16_t kPeriod = 1152;  // Of 1/115200 s.

constexpr Utime kGreeting = 500'000;
constexpr std::uint16_t kFastest = 0xFFFF, kTopRate = 400;
constexpr std::uint32_t kHealthy = 3;  // Self-test ok, filter valid.
constexpr Utime kMostBehind = kMicrosecondsPerSecond;

std::uint16_t kind_of(std::uint16_t id) { return id & 0xFFF0; }
bool is_orientation(std::uint16_t id) { return (id & 0xF800) == 0x2000; }
bool is_of_every_message(std::uint16_t id) { return (id & 0xF800) == 0x1000 || (id & 0xF800) == 0xE000; }

bool is_known(std::uint16_t id) {
  constexpr std::array<std::uint16_t, 10> kKnown = {0x1020, 0x1060, 0x1070, 0x2010, 0x2020,
                                                    0x2030, 0x4020, 0x8020, 0xC020, 0xE020};
  return std::find(kKnown.begin(), kKnown.end(), kind_of(id)) != kKnown.end() || kind_of(id) == 0xE010;
}

/// The same turn in the earth frame that the identifier names: 0 ENU, 4 NED, 8 NWU.
Eigen::Quaterniond in_frame(const Eigen::Quaterniond& q_enu_sensor, std::uint16_t id) {
  const double s = std::sqrt(0.5);
  if ((id & 0xC) == 0x4) return Eigen::Quaterniond(0, s, s, 0).conjugate() * q_enu_sensor;
  if ((id & 0xC) == 0x8) return Eigen::Quaterniond(s, 0, 0, s).conjugate() * q_enu_sensor;
  return q_enu_sensor;
}

void append_orientation(XbusBytes& data, std::uint16_t id, const Eigen::Quaterniond& q) {
  if (kind_of(id) == 0x2010) return append_numbers(data, id, std::array{q.w(), q.x(), q.y(), q.z()});
  const Eigen::Matrix3d R = q.toRotationMatrix();
  if (kind_of(id) == 0x2020) return append_numbers(data, id, std::span(R.data(), 9));  // Column by column.
  const double degree = repeatable::kPi / 180.0;
  const double roll = repeatable::atan2(R(2, 1), R(2, 2)), yaw = repeatable::atan2(R(1, 0), R(0, 0));
  const double pitch = repeatable::atan2(-R(2, 0), std::sqrt(R(2, 1) * R(2, 1) + R(2, 2) * R(2, 2)));
  append_numbers(data, id, std::array{roll / degree, pitch / degree, yaw / degree});
}

XbusBytes error_message(std::uint8_t code) { return xbus_message(kError, std::array{code}); }

void append(XbusBytes& bytes, const XbusBytes& more) { bytes.insert(bytes.end(), more.begin(), more.end()); }

}  // namespace

XbusBytes TrackerEmulator::receive(std::span<const std::uint8_t> bytes, Utime now) {
  XbusBytes answers = tick(now);
  requests_.push(bytes);
  while (const auto request = requests_.next()) append(answers, answer(*request, now));
  return answers;
}

void TrackerEmulator::reboot() {
  state_ = State::off;
  requests_ = {};
  counter_ = 0;
}

XbusBytes TrackerEmulator::tick(Utime now) {
  XbusBytes bytes;
  if (state_ == State::off) {
    state_ = State::waking;
    woke_ = now;
    return xbus_message(kWakeUp);
  }
  if (state_ == State::waking && now - woke_ >= kGreeting) {
    append(bytes, xbus_message(kConfiguration, configuration()));
    start_measuring(now);
  }
  if (state_ != State::measuring || outputs_.empty()) return bytes;
  const auto time_of = [&](std::int64_t sample) { return began_ + sample * kMicrosecondsPerSecond / rate_hz(); };
  for (; time_of(sample_) <= now; ++sample_) {
    if (now - time_of(sample_) < kMostBehind) append(bytes, measure(time_of(sample_)));
  }
  return bytes;
}

void TrackerEmulator::start_measuring(Utime now) {
  state_ = State::measuring;
  began_ = now;
  sample_ = 0;
}

XbusBytes TrackerEmulator::answer(const XbusRequest& request, Utime now) {
  const auto ok = static_cast<std::uint8_t>(request.number + 1);
  switch (request.number) {
    case kWakeUpAck:
      if (state_ == State::waking) state_ = State::configuring;
      return {};
    case kGoToConfig:
      state_ = State::configuring;
      return xbus_message(ok);
    case kGoToMeasurement:
      start_measuring(now);
      return xbus_message(ok);
    case kReset:
      state_ = State::off;
      return xbus_message(ok);
    default:
      return state_ == State::configuring ? answer_in_configuration(request) : error_message(kMessageInvalid);
  }
}

XbusBytes TrackerEmulator::answer_in_configuration(const XbusRequest& request) {
  const auto ok = static_cast<std::uint8_t>(request.number + 1);
  XbusBytes data;
  switch (request.number) {
    case kReqDid:
      append_big_endian(data, kDeviceId, 4);
      return xbus_message(ok, data);
    case kSetPeriod:
      if (request.data.empty()) append_big_endian(data, kPeriod, 2);
      return xbus_message(ok, data);
    case kReqConfiguration:
      return xbus_message(ok, configuration());
    case kReqFirmware:
      return xbus_message(ok, kFirmware);
    case kReqProductCode:
      data.assign(kProductCode.begin(), kProductCode.end());
      return xbus_message(ok, data);
    case kSetBaudrate:
      if (request.data.empty()) data.push_back(0x02);
      return xbus_message(ok, data);
    case kSetStringOutput:
      return xbus_message(ok);
    case kSetOutputConfiguration:
      return request.data.empty() ? xbus_message(ok, output_list()) : set_output(request.data);
    default:
      return error_message(kMessageInvalid);
  }
}

XbusBytes TrackerEmulator::set_output(const XbusBytes& list) {
  constexpr std::size_t kEntry = 4, kMostEntries = 32;
  if (list.size() % kEntry != 0 || list.size() > kMostEntries * kEntry) return error_message(kParameterInvalid);
  std::vector<Output> next;
  for (BigEndianReader reader(list); reader.left() > 0;) {
    const std::uint16_t id = reader.u16();
    std::uint16_t rate = reader.u16();
    if (id == 0) continue;  // "No output", and where old firmware changed to the older messages.
    if (!is_known(id)) return error_message(kParameterInvalid);
    if (is_of_every_message(id)) rate = kFastest;
    if (!is_of_every_message(id) && (rate == 0 || rate > kTopRate)) rate = kTopRate;
    next.push_back({id, rate});
  }
  outputs_ = next;
  return xbus_message(kSetOutputConfiguration + 1, output_list());
}

XbusBytes TrackerEmulator::output_list() const {
  XbusBytes list;
  for (const Output& output : outputs_) {
    append_big_endian(list, output.id, 2);
    append_big_endian(list, output.rate_hz, 2);
  }
  return list;
}

/// Of 118 bytes; what belongs to the older messages is zero.
XbusBytes TrackerEmulator::configuration() const {
  XbusBytes data;
  append_big_endian(data, kDeviceId, 4);
  append_big_endian(data, kPeriod, 2);
  data.resize(96);
  append_big_endian(data, 1, 2);
  append_big_endian(data, kDeviceId, 4);
  data.resize(118);
  return data;
}

std::int64_t TrackerEmulator::rate_hz() const {
  std::uint16_t rate = 0;
  for (const Output& output : outputs_) {
    if (output.rate_hz != kFastest) rate = std::max(rate, output.rate_hz);
  }
  return rate == 0 ? kTopRate : rate;
}

XbusBytes TrackerEmulator::measure(Utime time) {
  const TrackerSample sample = sense_(sample_, time);
  XbusBytes data;
  for (const Output& output : outputs_) {
    const bool due = output.rate_hz == kFastest || sample_ % std::max<std::int64_t>(1, rate_hz() / output.rate_hz) == 0;
    if (due) append_output(data, output, sample, time);
  }
  ++counter_;
  return xbus_message(kMtData2, data);
}

void TrackerEmulator::append_output(XbusBytes& data, const Output& output, const TrackerSample& sample,
                                    Utime time) const {
  const auto told = static_cast<Utime>(static_cast<double>(time) / speed_);
  const auto vector = [&](const Eigen::Vector3d& v) { append_numbers(data, output.id, std::span(v.data(), 3)); };
  if (is_orientation(output.id)) return append_orientation(data, output.id, in_frame(sample.q_world_sensor, output.id));
  switch (kind_of(output.id)) {
    case 0x1020:
      return append_integer(data, output.id, counter_, 2);
    case 0x1060:
      return append_integer(data, output.id, static_cast<std::uint32_t>(told / 100), 4);
    case 0x1070:
      return append_integer(data, output.id, static_cast<std::uint32_t>(told / kMicrosecondsPerSecond), 4);
    case 0x4020:
      return vector(sample.acceleration);
    case 0x8020:
      return vector(sample.rate_of_turn);
    case 0xC020:
      return vector(sample.magnetic_field);
    case 0xE010:
      return append_integer(data, output.id, kHealthy, 1);
    default:
      return append_integer(data, output.id, kHealthy, 4);
  }
}

}  // namespace scanway::simulator
