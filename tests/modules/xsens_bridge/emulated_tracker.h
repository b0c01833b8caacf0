#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/bytes/big_endian.h"
#include "tests/modules/xsens_bridge/hostile_xsens.h"

namespace scanway::test {

/// A tracker of either generation, by the sheet's checklist for emulators.
class EmulatedTracker {
 public:
  explicit EmulatedTracker(bool legacy) : legacy_(legacy) {}

  /// What it sends when it gets these bytes.
  Bytes answer(std::span<const std::uint8_t> bytes) {
    finder_.push(bytes);
    Bytes out;
    while (const auto stretch = finder_.next()) {
      if (stretch->whole) append(out, answer_one(xsens::open_frame(stretch->bytes)));
    }
    return out;
  }

  /// The next measurement, if it measures.
  Bytes measure() {
    if (!measuring_) return {};
    ++counter_;
    if (!legacy_) return small_mtdata2(counter_);
    Bytes data(length_ - 2, 0);
    append_big_endian(data, counter_, 2);
    return xsens::make_frame(xsens::kMtData, data);
  }

  Bytes reboot() {
    measuring_ = false;
    return xsens::make_frame(xsens::kWakeUp);
  }

  int late_answers = 0;      ///< So many measurements come before the answer to GoToConfig.
  std::uint8_t refused = 0;  ///< A message that is answered with error 33.

 private:
  static void append(Bytes& out, const Bytes& more) { out.insert(out.end(), more.begin(), more.end()); }

  static Bytes acknowledge(const xsens::Message& request, const Bytes& data = {}) {
    return xsens::make_frame(static_cast<std::uint8_t>(request.mid + 1), data);
  }

  Bytes answer_one(const xsens::Message& request) {
    if (refused != 0 && request.mid == refused) return xsens::set_number(xsens::kError, 33, 1);
    switch (request.mid) {
      case xsens::kGoToConfig:
        return go_to_config(request);
      case xsens::kGoToMeasurement:
        measuring_ = true;
        return acknowledge(request);
      case xsens::kReqDeviceId:
        return acknowledge(request, {0x03, 0x68, 0x24, 0x8C});
      case xsens::kReqProductCode:
        return acknowledge(request, product_code());
      case xsens::kReqFirmware:
        return acknowledge(request, {1, 8, 2});
      case xsens::kSetOutputConfiguration:
        if (legacy_) return xsens::set_number(xsens::kError, 4, 1);
        return acknowledge(request, request.data);
      case xsens::kSetOutputMode:
        mode_ = request.data;
        return acknowledge(request);
      case xsens::kSetOutputSettings:
        settings_ = request.data;
        length_ = 54;
        return acknowledge(request);
      case xsens::kReqConfiguration:
        return acknowledge(request, configuration());
      case xsens::kSetPeriod:
      case xsens::kSetOutputSkipFactor:
        return acknowledge(request);
      case xsens::kWakeUpAck:
        return {};
      default:
        return xsens::set_number(xsens::kError, 4, 1);
    }
  }

  Bytes go_to_config(const xsens::Message& request) {
    Bytes out;
    for (measuring_ = true; late_answers > 0; --late_answers) append(out, measure());
    measuring_ = false;
    append(out, acknowledge(request));
    return out;
  }

  static Bytes product_code() {
    const std::string_view text = "MTi-30-2A8G4        ";
    return {text.begin(), text.end()};
  }

  Bytes configuration() const {
    Bytes data(102, 0);
    append_big_endian(data, length_, 2);
    append(data, mode_);
    append(data, settings_);
    data.resize(118, 0);
    return data;
  }

  bool legacy_;
  bool measuring_ = true;  // As after power-up, when nobody answers its WakeUp.
  std::uint16_t counter_ = 65530;
  std::uint16_t length_ = 18;
  Bytes mode_{0, 4}, settings_{0, 0, 0, 1};
  FrameFinder finder_ = xsens::make_frame_finder();
};

}  // namespace scanway::test
