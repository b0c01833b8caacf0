#pragma once

#include <vector>

#include "modules/simulator/device/tracker/output.h"

namespace scanway::simulator {

/// Of the current series: MTData2, a list of items, each at a rate of its own.
class MtData2Output : public TrackerOutput {
 public:
  std::optional<XbusBytes> answer(const XbusRequest& request) override;
  void describe(XbusBytes& configuration) const override;
  std::optional<Utime> time_of(std::int64_t number) const override;
  XbusBytes message(const TrackerSample& sample, const SampleMark& mark) const override;

 private:
  struct Item {
    std::uint16_t id, rate_hz;
  };

  XbusBytes set_items(const XbusBytes& list);
  XbusBytes item_list() const;
  void append(XbusBytes& data, const Item& item, const TrackerSample& sample, const SampleMark& mark) const;
  std::int64_t rate_hz() const;

  std::vector<Item> items_ = {{0x1020, 0xFFFF}, {0x1060, 0xFFFF}, {0x2010, 100}, {0xE020, 0xFFFF}};
};

}  // namespace scanway::simulator
