#include "modules/simulator/device/tracker/mtdata_output.h"

#include <array>
#include <cmath>
#include <span>

#include "common/bytes/big_endian.h"
#include "modules/simulator/device/tracker/euler.h"
#include "modules/simulator/device/tracker/xbus_numbers.h"

namespace scanway::simulator {
namespace {

using namespace xbus;

constexpr std::uint16_t kCalibrated = 0x0002, kOrientation = 0x0004, kStatus = 0x0800;
constexpr std::uint8_t kWell = 3;  // Self-test ok, filter valid.

/// Without a value in the request: what it is now; else it is taken.
template <class Value>
XbusBytes ask_or_set(const XbusRequest& request, Value& value) {
  const auto ok = static_cast<std::uint8_t>(request.number + 1);
  XbusBytes data;
  if (request.data.empty()) append_big_endian(data, value, sizeof value);
  if (request.data.empty()) return xbus_message(ok, data);
  if (request.data.size() != sizeof value) return xbus_message(kError, std::array{kParameterInvalid});
  value = 0;
  for (const std::uint8_t byte : request.data) value = static_cast<Value>(value << 8 | byte);
  return xbus_message(ok);
}

void put(XbusBytes& bytes, std::size_t at, std::uint32_t value, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) bytes.at(at + i) = static_cast<std::uint8_t>(value >> 8 * (size - 1 - i));
}

}  // namespace

std::optional<XbusBytes> MtDataOutput::answer(const XbusRequest& request) {
  switch (request.number) {
    case kSetPeriod:
      return ask_or_set(request, period_);
    case kSetOutputSkipFactor:
      return ask_or_set(request, skip_);
    case kSetOutputMode:
      return ask_or_set(request, mode_);
    case kSetOutputSettings:
      return ask_or_set(request, settings_);
    case kReqDataLength: {
      XbusBytes data;
      append_big_endian(data, content({}, {}).size(), 2);
      return xbus_message(kReqDataLength + 1, data);
    }
    default:
      return std::nullopt;
  }
}

void MtDataOutput::describe(XbusBytes& configuration) const {
  put(configuration, 4, period_, 2);
  put(configuration, 6, skip_, 2);
  put(configuration, 102, static_cast<std::uint32_t>(content({}, {}).size()), 2);
  put(configuration, 104, mode_, 2);
  put(configuration, 106, settings_, 4);
}

std::optional<Utime> MtDataOutput::time_of(std::int64_t number) const {
  if (period_ == 0 || mode_ == 0) return std::nullopt;
  return number * period_ * (skip_ + 1) * kMicrosecondsPerSecond / kPeriodClock;
}

XbusBytes MtDataOutput::message(const TrackerSample& sample, const SampleMark& mark) const {
  return xbus_message(kMtData, content(sample, mark));
}

XbusBytes MtDataOutput::content(const TrackerSample& sample, const SampleMark& mark) const {
  constexpr unsigned kQuaternion = 0, kEuler = 1, kCounter = 1;
  const int format = static_cast<int>(settings_ >> 8 & 3);
  XbusBytes data;
  const auto numbers = [&](std::span<const double> values) { append_bare_numbers(data, format, values); };
  if ((mode_ & kCalibrated) != 0) {
    const Eigen::Vector3d* const triples[] = {&sample.acceleration, &sample.rate_of_turn, &sample.magnetic_field};
    for (unsigned i = 0; i < 3; ++i) {
      if ((settings_ >> (4 + i) & 1) == 0) numbers({triples[i]->data(), 3});
    }
  }
  if ((mode_ & kOrientation) != 0) {
    // Its earth is x north, y west, z up.
    const double s = std::sqrt(0.5);
    const Eigen::Quaterniond q = Eigen::Quaterniond(s, 0, 0, s).conjugate() * sample.q_world_sensor;
    const Eigen::Matrix3d R = q.toRotationMatrix();
    const unsigned form = settings_ >> 2 & 3;
    if (form == kQuaternion) numbers(std::array{q.w(), q.x(), q.y(), q.z()});
    if (form == kEuler) numbers(euler_deg(R));
    if (form > kEuler) numbers({R.data(), 9});
  }
  if ((mode_ & kStatus) != 0) data.push_back(kWell);
  if ((settings_ & 3) == kCounter) append_big_endian(data, mark.counter, 2);
  return data;
}

}  // namespace scanway::simulator
