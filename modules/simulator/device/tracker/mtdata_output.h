#pragma once

#include "modules/simulator/device/tracker/output.h"

namespace scanway::simulator {

/// Of the older trackers (MTi, MTx): MTData, whose layout follows from an output mode and output settings and is not
/// said in the message. Calibrated data, orientation, status and counter; of other modes it says nothing.
class MtDataOutput : public TrackerOutput {
 public:
  std::optional<XbusBytes> answer(const XbusRequest& request) override;
  void describe(XbusBytes& configuration) const override;
  std::optional<Utime> time_of(std::int64_t number) const override;
  XbusBytes message(const TrackerSample& sample, const SampleMark& mark) const override;

 private:
  XbusBytes content(const TrackerSample& sample, const SampleMark& mark) const;

  std::uint16_t period_ = 1152, skip_ = 0, mode_ = 0x0004;  // As they leave the factory.
  std::uint32_t settings_ = 0x00000001;
};

}  // namespace scanway::simulator
