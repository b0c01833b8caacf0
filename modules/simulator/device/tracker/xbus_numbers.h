#pragma once

#include <cstdint>

/// Numbers of Xsens' messages.
namespace scanway::simulator::xbus {

enum : std::uint8_t {
  kReqDid = 0x00,
  kSetPeriod = 0x04,
  kReqDataLength = 0x0A,
  kReqConfiguration = 0x0C,
  kConfiguration = 0x0D,
  kGoToMeasurement = 0x10,
  kReqFirmware = 0x12,
  kSetBaudrate = 0x18,
  kReqProductCode = 0x1C,
  kGoToConfig = 0x30,
  kMtData = 0x32,
  kMtData2 = 0x36,
  kWakeUp = 0x3E,
  kWakeUpAck = 0x3F,
  kReset = 0x40,
  kError = 0x42,
  kSetStringOutput = 0x8E,
  kSetOutputConfiguration = 0xC0,
  kSetOutputMode = 0xD0,
  kSetOutputSettings = 0xD2,
  kSetOutputSkipFactor = 0xD4,
};
constexpr std::uint8_t kMessageInvalid = 4, kParameterInvalid = 33;

constexpr std::uint32_t kPeriodClock = 115'200;  // Of which the period is told.

}  // namespace scanway::simulator::xbus
