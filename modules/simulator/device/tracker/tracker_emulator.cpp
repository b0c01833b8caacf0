#include "modules/simulator/device/tracker/tracker_emulator.h"

#include <array>
#include <string_view>

#include "common/bytes/big_endian.h"
#include "modules/simulator/device/tracker/mtdata2_output.h"
#include "modules/simulator/device/tracker/mtdata_output.h"
#include "modules/simulator/device/tracker/xbus_numbers.h"

namespace scanway::simulator {
namespace {

using namespace xbus;

// An MTi-30, as recorded.
constexpr std::uint32_t kDeviceId = 0x0368248C;
constexpr std::string_view kProductCode = "MTi-30-2A8G4        ";
constexpr std::uint8_t kFirmware[] = {0x01, 0x08, 0x02, 0x00, 0x00, 0x00, 0x25, 0x00, 0x01, 0x15, 0x34};

constexpr Utime kGreeting = 500'000;
constexpr Utime kMostBehind = kMicrosecondsPerSecond;

XbusBytes error_message(std::uint8_t code) { return xbus_message(kError, std::array{code}); }

void append(XbusBytes& bytes, const XbusBytes& more) { bytes.insert(bytes.end(), more.begin(), more.end()); }

}  // namespace

TrackerEmulator::TrackerEmulator(Sense sense, Generation generation) : sense_(std::move(sense)) {
  if (generation == Generation::older) {
    output_ = std::make_unique<MtDataOutput>();
  } else {
    output_ = std::make_unique<MtData2Output>();
  }
}

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
  if (state_ != State::measuring) return bytes;
  for (; output_->time_of(sample_); ++sample_) {
    const Utime due = began_ + *output_->time_of(sample_);
    if (due > now) break;
    if (now - due < kMostBehind) append(bytes, measure(due));
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
    default:
      return output_->answer(request).value_or(error_message(kMessageInvalid));
  }
}

/// Of 118 bytes.
XbusBytes TrackerEmulator::configuration() const {
  XbusBytes data;
  append_big_endian(data, kDeviceId, 4);
  data.resize(96);
  append_big_endian(data, 1, 2);
  append_big_endian(data, kDeviceId, 4);
  data.resize(118);
  output_->describe(data);
  return data;
}

XbusBytes TrackerEmulator::measure(Utime time) {
  const auto told = static_cast<Utime>(static_cast<double>(time) / speed_);
  return output_->message(sense_(sample_, time), {sample_, counter_++, told});
}

}  // namespace scanway::simulator
