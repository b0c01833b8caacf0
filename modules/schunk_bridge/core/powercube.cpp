#include "modules/schunk_bridge/core/powercube.h"

#include <cmath>
#include <iterator>

#include "modules/schunk_bridge/core/fields.h"

namespace scanway::schunk::powercube {
namespace {

constexpr std::uint16_t kState = 0x060, kAcknowledge = 0x0A0, kGet = 0x0C0, kSet = 0x0E0, kBroadcast = 0x100;

struct Name {
  std::uint8_t code;
  std::string_view name;
};

constexpr Name kCommands[] = {{0x00, "RESET"},    {0x01, "HOME"},          {0x02, "HALT"},
                              {0x07, "WATCHDOG"}, {0x08, "SET PARAMETER"}, {0x0A, "GET PARAMETER"},
                              {0x0B, "SET MOVE"}, {0x0F, "START MOVE"},    {0x10, "SAVE"}};
constexpr Name kMoves[] = {{0x04, "ramp"}, {0x06, "step"}, {0x07, "velocity"}, {0x08, "current"},
                           {0x0E, "ramp"}, {0x10, "step"}, {0x11, "velocity"}, {0x12, "current"}};
constexpr Name kParameters[] = {{0x27, "state"},
                                {0x3C, "position_rad"},
                                {0x41, "velocity_rad_s"},
                                {0x45, "min_position_rad"},
                                {0x46, "max_position_rad"},
                                {0x48, "max_velocity_rad_s"},
                                {0x4A, "max_acceleration_rad_s2"},
                                {0x4C, "max_current_A"},
                                {0x4D, "current_A"},
                                {0x4F, "ramp_velocity_rad_s"},
                                {0x50, "ramp_acceleration_rad_s2"}};

template <std::size_t N>
std::string name_in(const Name (&names)[N], std::uint8_t code) {
  for (const Name& known : names) {
    if (known.code == code) return std::string(known.name);
  }
  return "unknown " + hex_of(std::span(&code, 1));
}

std::uint16_t kind_of(std::uint16_t id) { return id == kBroadcast ? kBroadcast : static_cast<std::uint16_t>(id & ~31); }

bool is_ours(std::uint16_t id) {
  const std::uint16_t kind = kind_of(id);
  const bool a_module = (id & 31) != 0 && (kind == kState || kind == kAcknowledge || kind == kGet || kind == kSet);
  return a_module || id == kBroadcast;
}

/// "SET MOVE" and the like: a parameter's name and its value.
void read_parameter(const CanFrame& frame, Reading& reading) {
  const bool moves = frame.data[0] == 0x0B;
  const std::string name = moves ? name_in(kMoves, frame.data[1]) : name_in(kParameters, frame.data[1]);
  reading.fields.push_back({"parameter", name});
  if (frame.size < 6) return;
  const auto bytes = frame.bytes().subspan(2, 4);
  const double value = static_cast<double>(read_float(bytes));
  if (name == "state") {
    reading.fields.push_back({"value", static_cast<std::int64_t>(read_unsigned(bytes))});
  } else if (std::isfinite(value)) {
    reading.fields.push_back({"value", value});
  }
}

}  // namespace

CanFrame ask_position(std::uint8_t module) {
  return {static_cast<std::uint16_t>(kGet + (module & 31)), 2, {0x0A, 0x3C}};
}

bool is_answer(const CanFrame& frame) {
  const std::uint16_t kind = kind_of(frame.id);
  return is_ours(frame.id) && (kind == kAcknowledge || kind == kState);
}

std::optional<Reading> read(const CanFrame& frame) {
  if (!is_ours(frame.id)) return std::nullopt;
  Reading reading;
  reading.module = frame.id == kBroadcast ? 0 : frame.id & 31;
  reading.kind = is_answer(frame) ? "answer" : "request";
  if (kind_of(frame.id) == kState || frame.size == 0) {
    reading.type = "PowerCube STATE";
    reading.fields.push_back({"bytes", hex_of(frame.bytes())});
    return reading;
  }
  reading.type = "PowerCube " + name_in(kCommands, frame.data[0]);
  const bool has_parameter = frame.data[0] == 0x08 || frame.data[0] == 0x0A || frame.data[0] == 0x0B;
  if (has_parameter && frame.size > 1) {
    read_parameter(frame, reading);
  } else {
    reading.fields.push_back({"bytes", hex_of(frame.bytes())});
  }
  return reading;
}

}  // namespace scanway::schunk::powercube
