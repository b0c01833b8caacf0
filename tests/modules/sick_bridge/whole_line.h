#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "common/messages/codec.h"
#include "scanway/laser_line_t.hpp"

namespace scanway::test {

/// One echo of a line, put together from its pieces.
struct WholeEcho {
  laser_line_t head;  ///< The first of its pieces that came.
  std::vector<int> ranges, rssi;
  std::vector<bool> came;

  bool whole() const { return std::count(came.begin(), came.end(), false) == 0; }
};

/// Lines by their number and echo, put together from LASER_LINE in any order.
class WholeLines {
 public:
  void add(const laser_line_t& piece) {
    WholeEcho& echo = lines_[{piece.line, piece.echo}];
    const auto beams = static_cast<std::size_t>(piece.nbeams_of_line);
    if (echo.came.empty()) {
      echo.head = piece;
      echo.ranges.resize(beams);
      echo.came.resize(beams);
      if (piece.nrssi > 0) echo.rssi.resize(beams);
    }
    ASSERT_EQ(echo.came.size(), beams);
    for (std::size_t i = 0; i < piece.range_count.size(); ++i) {
      const std::size_t beam = static_cast<std::size_t>(piece.first_beam) + i;
      ASSERT_LT(beam, beams);
      EXPECT_FALSE(echo.came[beam]) << "beam " << beam << " came twice";
      echo.came[beam] = true;
      echo.ranges[beam] = static_cast<std::uint16_t>(piece.range_count[i]);
      if (piece.nrssi > 0) echo.rssi[beam] = static_cast<std::uint16_t>(piece.rssi_count[i]);
    }
  }
  void add(std::span<const std::uint8_t> message) { add(decode<laser_line_t>(message)); }

  const std::map<std::pair<std::int64_t, int>, WholeEcho>& lines() const { return lines_; }
  const WholeEcho& at(std::int64_t line, int echo = 0) const { return lines_.at({line, echo}); }

 private:
  std::map<std::pair<std::int64_t, int>, WholeEcho> lines_;
};

}  // namespace scanway::test
