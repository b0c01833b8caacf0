#pragma once

#include <cstdint>

/// Commands of the SCHUNK Motion Protocol, and codes of what is wrong: SCHUNK Motion manual v1.41.
namespace scanway::simulator::motion {

enum : std::uint8_t {
  kGetConfig = 0x80,
  kSetConfig = 0x81,
  kError = 0x88,
  kInfo = 0x8A,
  kAck = 0x8B,
  kFastStop = 0x90,
  kStop = 0x91,
  kReference = 0x92,
  kMoveBlocked = 0x93,
  kPosReached = 0x94,
  kGetState = 0x95,
  kDetailedError = 0x96,
  kTargetVel = 0xA0,
  kTargetAcc = 0xA1,
  kTargetTime = 0xA4,
  kMovePos = 0xB0,
  kMoveVel = 0xB5,
  kMovePosRel = 0xB8,
  kReboot = 0xE0,
  kChangeUser = 0xE3,
  kToggleImpulse = 0xE7,
};
enum : std::uint8_t {
  kBoot = 0x01,
  kUnknownCommand = 0x04,
  kFailed = 0x05,
  kNotReferenced = 0x06,
  kNoError = 0x08,
  kAboveLimit = 0x1B,
  kMessageLength = 0x1D,
  kWrongParameter = 0x1E,
  kSoftLow = 0xD5,
  kSoftHigh = 0xD6,
  kFastStopped = 0xD9,
  kTow = 0xDA,
};

}  // namespace scanway::simulator::motion
