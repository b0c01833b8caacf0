#include "modules/simulator/device/tracker/mtdata2_output.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/bytes/big_endian.h"
#include "modules/simulator/device/tracker/euler.h"
#include "modules/simulator/device/tracker/xbus_numbers.h"

namespace scanway::simulator {
namespace {

using namespace xbus;

constexpr std::uint16_t kFastest = 0xFFFF, kTopRate = 400, kPeriod = 1152;
constexpr std::uint32_t kHealthy = 3;  // Self-test ok, filter valid.

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
  append_numbers(data, id, euler_deg(R));
}

}  // namespace

std::optional<XbusBytes> MtData2Output::answer(const XbusRequest& request) {
  const auto ok = static_cast<std::uint8_t>(request.number + 1);
  XbusBytes data;
  switch (request.number) {
    case kSetPeriod:
      if (request.data.empty()) append_big_endian(data, kPeriod, 2);
      return xbus_message(ok, data);
    case kSetStringOutput:
      return xbus_message(ok);
    case kSetOutputConfiguration:
      return request.data.empty() ? xbus_message(ok, item_list()) : set_items(request.data);
    default:
      return std::nullopt;
  }
}

void MtData2Output::describe(XbusBytes& configuration) const {
  configuration[4] = kPeriod >> 8;
  configuration[5] = kPeriod & 0xFF;
}

std::optional<Utime> MtData2Output::time_of(std::int64_t number) const {
  return items_.empty() ? std::nullopt : std::optional(number * kMicrosecondsPerSecond / rate_hz());
}

XbusBytes MtData2Output::message(const TrackerSample& sample, const SampleMark& mark) const {
  XbusBytes data;
  for (const Item& item : items_) {
    const bool due = item.rate_hz == kFastest || mark.number % std::max<std::int64_t>(1, rate_hz() / item.rate_hz) == 0;
    if (due) append(data, item, sample, mark);
  }
  return xbus_message(kMtData2, data);
}

XbusBytes MtData2Output::set_items(const XbusBytes& list) {
  constexpr std::size_t kEntry = 4, kMostEntries = 32;
  if (list.size() % kEntry != 0 || list.size() > kMostEntries * kEntry)
    return xbus_message(kError, std::array{kParameterInvalid});
  std::vector<Item> next;
  for (BigEndianReader reader(list); reader.left() > 0;) {
    const std::uint16_t id = reader.u16();
    std::uint16_t rate = reader.u16();
    if (id == 0) continue;  // "No output", and where old firmware changed to the older messages.
    if (!is_known(id)) return xbus_message(kError, std::array{kParameterInvalid});
    if (is_of_every_message(id)) rate = kFastest;
    if (!is_of_every_message(id) && (rate == 0 || rate > kTopRate)) rate = kTopRate;
    next.push_back({id, rate});
  }
  items_ = next;
  return xbus_message(kSetOutputConfiguration + 1, item_list());
}

XbusBytes MtData2Output::item_list() const {
  XbusBytes list;
  for (const Item& item : items_) {
    append_big_endian(list, item.id, 2);
    append_big_endian(list, item.rate_hz, 2);
  }
  return list;
}

std::int64_t MtData2Output::rate_hz() const {
  std::uint16_t rate = 0;
  for (const Item& item : items_) {
    if (item.rate_hz != kFastest) rate = std::max(rate, item.rate_hz);
  }
  return rate == 0 ? kTopRate : rate;
}

void MtData2Output::append(XbusBytes& data, const Item& item, const TrackerSample& sample,
                           const SampleMark& mark) const {
  const auto vector = [&](const Eigen::Vector3d& v) { append_numbers(data, item.id, std::span(v.data(), 3)); };
  if (is_orientation(item.id)) return append_orientation(data, item.id, in_frame(sample.q_world_sensor, item.id));
  switch (kind_of(item.id)) {
    case 0x1020:
      return append_integer(data, item.id, mark.counter, 2);
    case 0x1060:
      return append_integer(data, item.id, static_cast<std::uint32_t>(mark.told / 100), 4);
    case 0x1070:
      return append_integer(data, item.id, static_cast<std::uint32_t>(mark.told / kMicrosecondsPerSecond), 4);
    case 0x4020:
      return vector(sample.acceleration);
    case 0x8020:
      return vector(sample.rate_of_turn);
    case 0xC020:
      return vector(sample.magnetic_field);
    case 0xE010:
      return append_integer(data, item.id, kHealthy, 1);
    default:
      return append_integer(data, item.id, kHealthy, 4);
  }
}

}  // namespace scanway::simulator
