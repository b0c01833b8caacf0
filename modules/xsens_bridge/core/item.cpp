#include "modules/xsens_bridge/core/item.h"

#include <cmath>

namespace scanway::xsens {

std::size_t size_of(NumberFormat format) {
  constexpr std::size_t kSizes[] = {4, 4, 6, 8};
  return kSizes[static_cast<int>(format)];
}

double read_number(BigEndianReader& reader, NumberFormat format) {
  switch (format) {
    case NumberFormat::float32:
      return reader.f32();
    case NumberFormat::fp12_20:
      return std::ldexp(reader.i32(), -20);
    case NumberFormat::float64:
      return reader.f64();
    case NumberFormat::fp16_32:
      break;
  }
  const double fraction = std::ldexp(reader.u32(), -32);  // The fraction comes first.
  return reader.i16() + fraction;
}

const char* name_of(NumberFormat format) {
  constexpr const char* kNames[] = {"float32", "fp12.20", "fp16.32", "float64"};
  return kNames[static_cast<int>(format)];
}

const char* name_of(EarthFrame frame) {
  constexpr const char* kNames[] = {"ENU", "NED", "NWU"};
  return kNames[static_cast<int>(frame)];
}

UtcTime read_utc(BigEndianReader& reader) {
  UtcTime time;
  time.nanosecond = reader.u32();
  time.year = reader.u16();
  time.month = reader.u8();
  time.day = reader.u8();
  time.hour = reader.u8();
  time.minute = reader.u8();
  time.second = reader.u8();
  time.flags = reader.u8();
  return time;
}

bool has_frame(Quantity quantity) {
  return quantity == Quantity::quaternion || quantity == Quantity::rotation_matrix || quantity == Quantity::euler ||
         quantity == Quantity::velocity;
}

const Item* find_item(std::span<const Item> items, Quantity quantity) {
  for (const Item& item : items) {
    if (item.quantity == quantity) return &item;
  }
  return nullptr;
}

}  // namespace scanway::xsens
