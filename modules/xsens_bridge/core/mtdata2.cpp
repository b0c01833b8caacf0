#include "modules/xsens_bridge/core/mtdata2.h"

#include <optional>

#include "modules/xsens_bridge/core/message.h"
#include "modules/xsens_bridge/core/rotation_matrix.h"

namespace scanway::xsens {
namespace {

constexpr std::uint16_t kQuantityMask = 0xFFF0;  // The rest says the frame (bits 3-2) and the number format (1-0).

enum class Form : std::uint8_t { numbers, integer, bits, utc, bytes };

struct Definition {
  Quantity quantity;
  const char* name;
  Form form;
  std::size_t count;  ///< Of numbers; bytes of an integer or bit field.
};

constexpr Definition kDefinitions[] = {
    {Quantity::temperature, "temperature_C", Form::numbers, 1},
    {Quantity::utc_time, "utc_time", Form::utc, 12},
    {Quantity::packet_counter, "packet_counter", Form::integer, 2},
    {Quantity::sample_time_fine, "sample_time_fine", Form::integer, 4},
    {Quantity::sample_time_coarse, "sample_time_coarse", Form::integer, 4},
    {Quantity::quaternion, "quaternion_wxyz", Form::numbers, 4},
    {Quantity::rotation_matrix, "rotation_matrix", Form::numbers, 9},
    {Quantity::euler, "euler_rpy_deg", Form::numbers, 3},
    {Quantity::pressure, "baro_pressure_Pa", Form::integer, 4},
    {Quantity::delta_v, "delta_v", Form::numbers, 3},
    {Quantity::acceleration, "acceleration", Form::numbers, 3},
    {Quantity::free_acceleration, "free_acceleration", Form::numbers, 3},
    {Quantity::acceleration_high_rate, "acceleration_high_rate", Form::numbers, 3},
    {Quantity::altitude, "altitude_ellipsoid_m", Form::numbers, 1},
    {Quantity::position_ecef, "position_ecef_m", Form::numbers, 3},
    {Quantity::lat_lon, "lat_lon_deg", Form::numbers, 2},
    {Quantity::gnss_pvt, "gnss_pvt_raw_hex", Form::bytes, 0},
    {Quantity::gnss_satellites, "gnss_satellites_raw_hex", Form::bytes, 0},
    {Quantity::rate_of_turn, "rate_of_turn", Form::numbers, 3},
    {Quantity::delta_q, "delta_q", Form::numbers, 4},
    {Quantity::rate_of_turn_high_rate, "rate_of_turn_high_rate", Form::numbers, 3},
    {Quantity::magnetic_field, "magnetic_field", Form::numbers, 3},
    {Quantity::velocity, "velocity_xyz", Form::numbers, 3},
    {Quantity::status_byte, "status_byte", Form::bits, 1},
    {Quantity::status_word, "status_word", Form::bits, 4},
    {Quantity::device_id, "device_id_raw_hex", Form::bytes, 0},
    {Quantity::location_id, "location_id_raw_hex", Form::bytes, 0},
};

const Definition* find_definition(std::uint16_t id) {
  for (const Definition& known : kDefinitions) {
    if (static_cast<std::uint16_t>(known.quantity) == (id & kQuantityMask)) return &known;
  }
  return nullptr;
}

std::optional<EarthFrame> frame_of(std::uint16_t id) {
  switch (id >> 2 & 3) {
    case 0:
      return EarthFrame::enu;
    case 1:
      return EarthFrame::ned;
    case 2:
      return EarthFrame::nwu;
    default:
      return std::nullopt;
  }
}

/// The format of `count` numbers in `size` bytes. The size decides; the identifier only where both fit.
std::optional<NumberFormat> format_of(std::uint16_t id, std::size_t size, std::size_t count) {
  const auto said = static_cast<NumberFormat>(id & 3);
  if (size == count * size_of(said)) return said;
  for (const NumberFormat other : {NumberFormat::float32, NumberFormat::fp16_32, NumberFormat::float64}) {
    if (size == count * size_of(other)) return other;
  }
  return std::nullopt;
}

std::uint32_t read_integer(BigEndianReader& reader, std::size_t size) {
  return size == 1 ? reader.u8() : size == 2 ? reader.u16() : reader.u32();
}

/// Reads numbers into the item; false when the size fits no format.
bool read_numbers(BigEndianReader reader, const Definition& definition, Item& item) {
  const auto format = format_of(item.id, reader.left(), definition.count);
  const auto frame = has_frame(definition.quantity) ? frame_of(item.id) : EarthFrame::enu;
  if (!format || !frame) return false;
  item.format = *format;
  item.frame = *frame;
  Numbers numbers;
  for (std::size_t i = 0; i < definition.count; ++i) numbers.push_back(read_number(reader, *format));
  if (definition.quantity == Quantity::rotation_matrix) numbers = rows_from_columns(numbers);
  item.value = std::move(numbers);
  return true;
}

/// Reads the value into the item; false when its size fits nothing that it could hold.
bool read_value(std::span<const std::uint8_t> bytes, const Definition& definition, Item& item) {
  BigEndianReader reader(bytes);
  if (definition.form == Form::numbers) return read_numbers(reader, definition, item);
  if (definition.form == Form::bytes) {
    item.value = Bytes(bytes.begin(), bytes.end());
    return true;
  }
  if (bytes.size() != definition.count) return false;
  if (definition.form == Form::utc) {
    item.value = read_utc(reader);
  } else if (definition.form == Form::integer) {
    item.value = read_integer(reader, definition.count);
  } else {
    item.value = BitField{read_integer(reader, definition.count), static_cast<int>(2 * definition.count)};
  }
  return true;
}

Item read_item(BigEndianReader& reader) {
  Item item;
  item.id = reader.u16();
  const auto bytes = reader.take(reader.u8());
  const Definition* definition = find_definition(item.id);
  if (definition != nullptr && read_value(bytes, *definition, item)) {
    item.quantity = definition->quantity;
    item.name = definition->name;
  } else {
    item.name = "unknown";
    item.value = Bytes(bytes.begin(), bytes.end());
  }
  return item;
}

}  // namespace

std::vector<Item> parse_mtdata2(std::span<const std::uint8_t> data) {
  BigEndianReader reader(data);
  std::vector<Item> items;
  try {
    while (reader.left() > 0) items.push_back(read_item(reader));
  } catch (const std::out_of_range&) {
    throw BadMessage("its last item is longer than the message");
  }
  return items;
}

}  // namespace scanway::xsens
