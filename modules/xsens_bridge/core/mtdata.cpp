#include "modules/xsens_bridge/core/mtdata.h"

#include <algorithm>
#include <cmath>

#include "modules/xsens_bridge/core/message.h"
#include "modules/xsens_bridge/core/rotation_matrix.h"

namespace scanway::xsens {
namespace {

enum class Form : std::uint8_t { numbers, u16s, bits, utc };

struct Block {
  Quantity quantity;
  const char* name;
  Form form;
  std::size_t count;
};

NumberFormat format_of(const OutputLayout& layout) { return static_cast<NumberFormat>(layout.settings >> 8 & 3); }

Block orientation_block(std::uint32_t settings) {
  if ((settings & kSettingMatrix) != 0) return {Quantity::rotation_matrix, "rotation_matrix", Form::numbers, 9};
  if ((settings & kSettingEuler) != 0) return {Quantity::euler, "euler_rpy_deg", Form::numbers, 3};
  return {Quantity::quaternion, "quaternion_wxyz", Form::numbers, 4};
}

void add_sensor_blocks(const OutputLayout& layout, std::vector<Block>& blocks) {
  const auto has = [&](unsigned mode) { return (layout.mode & mode) != 0; };
  const auto lacks = [&](unsigned setting) { return (layout.settings & setting) == 0; };
  if (has(kModeTemperature)) blocks.push_back({Quantity::temperature, "temperature_C", Form::numbers, 1});
  if (has(kModeCalibrated)) {
    if (lacks(kSettingNoAcceleration)) blocks.push_back({Quantity::acceleration, "acceleration", Form::numbers, 3});
    if (lacks(kSettingNoRateOfTurn)) blocks.push_back({Quantity::rate_of_turn, "rate_of_turn", Form::numbers, 3});
    if (lacks(kSettingNoMagneticField)) {
      blocks.push_back({Quantity::magnetic_field, "magnetic_field", Form::numbers, 3});
    }
  }
  if (has(kModeOrientation)) blocks.push_back(orientation_block(layout.settings));
  if (has(kModeAuxiliary)) {
    const std::size_t inputs = std::size_t{lacks(kSettingNoAnalog1)} + std::size_t{lacks(kSettingNoAnalog2)};
    if (inputs > 0) blocks.push_back({Quantity::analog_inputs, "analog_inputs", Form::u16s, inputs});
  }
  if (has(kModePosition)) blocks.push_back({Quantity::position_lla, "position_lla", Form::numbers, 3});
  if (has(kModeVelocity)) blocks.push_back({Quantity::velocity, "velocity_xyz", Form::numbers, 3});
  if (has(kModeStatus)) blocks.push_back({Quantity::status_byte, "status_byte", Form::bits, 1});
}

/// The blocks in the order of the wire.
std::vector<Block> blocks_of(const OutputLayout& layout) {
  std::vector<Block> blocks;
  if ((layout.mode & kModeRaw) != 0) {
    blocks.push_back({Quantity::raw_sensors, "raw_acc_gyr_mag", Form::u16s, 9});
    blocks.push_back({Quantity::raw_temperature, "raw_temperature", Form::u16s, 1});
  } else {
    add_sensor_blocks(layout, blocks);
  }
  if ((layout.settings & kSettingCounter) != 0) {
    blocks.push_back({Quantity::sample_counter, "sample_counter", Form::u16s, 1});
  }
  if ((layout.settings & kSettingUtc) != 0) blocks.push_back({Quantity::utc_time, "utc_time", Form::utc, 1});
  return blocks;
}

std::size_t size_of(const Block& block, NumberFormat format) {
  switch (block.form) {
    case Form::numbers:
      return block.count * size_of(format);
    case Form::u16s:
      return block.count * 2;
    case Form::bits:
      return 1;
    case Form::utc:
      break;
  }
  return 12;
}

Item read_block(BigEndianReader& reader, const Block& block, const OutputLayout& layout) {
  Item item;
  item.quantity = block.quantity;
  item.name = block.name;
  item.format = format_of(layout);
  item.frame = (layout.settings & kSettingNed) != 0 ? EarthFrame::ned : EarthFrame::nwu;
  Numbers numbers;
  switch (block.form) {
    case Form::numbers:
      for (std::size_t i = 0; i < block.count; ++i) numbers.push_back(read_number(reader, item.format));
      break;
    case Form::u16s:
      for (std::size_t i = 0; i < block.count; ++i) numbers.push_back(reader.u16());
      break;
    case Form::bits:
      item.value = BitField{reader.u8(), 2};
      return item;
    case Form::utc:
      item.value = read_utc(reader);
      return item;
  }
  if (block.quantity == Quantity::rotation_matrix) numbers = rows_from_columns(numbers);
  if (block.quantity == Quantity::sample_counter || block.quantity == Quantity::raw_temperature) {
    item.value = static_cast<std::uint32_t>(numbers[0]);
  } else {
    item.value = std::move(numbers);
  }
  return item;
}

double norm_of(const Numbers& numbers) {
  double sum = 0.0;
  for (const double number : numbers) sum += number * number;
  return std::sqrt(sum);
}

/// Whether the values can be what the layout says that they are.
bool plausible(const Item& item) {
  const auto* numbers = std::get_if<Numbers>(&item.value);
  if (numbers == nullptr) return true;
  if (!std::all_of(numbers->begin(), numbers->end(), [](double value) { return std::isfinite(value); })) return false;
  const double norm = norm_of(*numbers);
  switch (item.quantity) {
    case Quantity::quaternion:
      return std::fabs(norm - 1.0) < 0.01;
    case Quantity::rotation_matrix:
      return std::fabs(norm - std::sqrt(3.0)) < 0.01;
    case Quantity::euler:
      return std::fabs((*numbers)[0]) <= 180.5 && std::fabs((*numbers)[1]) <= 90.5 && std::fabs((*numbers)[2]) <= 180.5;
    case Quantity::acceleration:
      return norm > 1.0 && norm < 100.0;
    case Quantity::rate_of_turn:
      return norm < 100.0;
    case Quantity::magnetic_field:
      return norm > 0.01 && norm < 10.0;
    case Quantity::temperature:
      return (*numbers)[0] > -60.0 && (*numbers)[0] < 120.0;
    default:
      return true;
  }
}

/// The likeliest first: orientation alone or with the calibrated sensors, and a counter, as drivers set it.
std::vector<OutputLayout> likely_layouts() {
  constexpr std::uint16_t kModes[] = {0x0004, 0x0006, 0x0002, 0x0005, 0x0007, 0x0804, 0x0806, 0x0805, 0x0807};
  constexpr std::uint32_t kOrientations[] = {0, kSettingEuler, kSettingMatrix};
  constexpr std::uint32_t kAllDropped = kSettingNoAcceleration | kSettingNoRateOfTurn | kSettingNoMagneticField;
  std::vector<OutputLayout> layouts;
  for (const std::uint32_t format_and_time : {0x001, 0x000, 0x101, 0x100, 0x201, 0x200, 0x301, 0x300}) {
    for (const std::uint16_t mode : kModes) {
      const std::uint32_t last_dropped = (mode & kModeCalibrated) != 0 ? kAllDropped - kSettingNoAcceleration : 0;
      for (std::uint32_t dropped = 0; dropped <= last_dropped; dropped += kSettingNoAcceleration) {
        for (const std::uint32_t orientation : kOrientations) {
          layouts.push_back({mode, format_and_time | dropped | orientation});
        }
      }
    }
  }
  return layouts;
}

}  // namespace

std::size_t length_of(const OutputLayout& layout) {
  std::size_t length = 0;
  for (const Block& block : blocks_of(layout)) length += size_of(block, format_of(layout));
  return length;
}

std::vector<Item> parse_mtdata(std::span<const std::uint8_t> data, const OutputLayout& layout) {
  if (data.size() != length_of(layout)) {
    throw BadMessage("MTData of " + std::to_string(data.size()) + " bytes, where the output mode gives " +
                     std::to_string(length_of(layout)));
  }
  BigEndianReader reader(data);
  std::vector<Item> items;
  for (const Block& block : blocks_of(layout)) items.push_back(read_block(reader, block, layout));
  return items;
}

std::optional<OutputLayout> guess_layout(std::span<const std::uint8_t> data) {
  for (const OutputLayout& layout : likely_layouts()) {
    if (length_of(layout) != data.size()) continue;
    const auto items = parse_mtdata(data, layout);
    if (std::all_of(items.begin(), items.end(), plausible)) return layout;
  }
  return std::nullopt;
}

}  // namespace scanway::xsens
