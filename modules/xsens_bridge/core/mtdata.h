#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "modules/xsens_bridge/core/item.h"

namespace scanway::xsens {

/// What an older tracker's MTData messages hold. The messages do not say it themselves: it is set, or asked for.
struct OutputLayout {
  std::uint16_t mode = 0x0004;
  std::uint32_t settings = 0x00000001;

  bool operator==(const OutputLayout&) const = default;
};

/// Bits of OutputLayout::mode.
enum OutputMode : std::uint16_t {
  kModeTemperature = 0x0001,
  kModeCalibrated = 0x0002,
  kModeOrientation = 0x0004,
  kModeAuxiliary = 0x0008,
  kModePosition = 0x0010,
  kModeVelocity = 0x0020,
  kModeStatus = 0x0800,
  kModeRaw = 0x4000,
};

/// Bits and values of OutputLayout::settings.
enum OutputSettings : std::uint32_t {
  kSettingCounter = 0x1,
  kSettingUtc = 0x2,
  kSettingEuler = 0x4,
  kSettingMatrix = 0x8,
  kSettingNoAcceleration = 0x10,
  kSettingNoRateOfTurn = 0x20,
  kSettingNoMagneticField = 0x40,
  kSettingNoAnalog1 = 0x400,
  kSettingNoAnalog2 = 0x800,
  kSettingNed = 0x80000000,
};

/// Bytes of an MTData message with that layout.
std::size_t length_of(const OutputLayout& layout);

/// The items of an MTData message, named as those of MTData2. Throws BadMessage when the length is not the layout's.
std::vector<Item> parse_mtdata(std::span<const std::uint8_t> data, const OutputLayout& layout);

/// The layout that makes sense of a message whose layout nobody said: its length fits, and quaternion, matrix or angles
/// can be such, and gravity where there is acceleration. The likeliest if there are several; a guess, to be said so.
std::optional<OutputLayout> guess_layout(std::span<const std::uint8_t> data);

}  // namespace scanway::xsens
