#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "modules/mapper/core/mapper.h"

namespace scanway {

/// What became of the sweeps that the map was offered: in numbers, and of the last one in words.
class PlacementTally {
 public:
  void count(const SweepResult& result);

  std::map<std::string, std::int64_t> counters() const;
  /// Of the last sweep, what people should know; empty: it is in the map, with its ground, and all stood still.
  const std::string& note() const { return note_; }

 private:
  std::string note_;
  std::int64_t refused_ = 0, moved_ = 0, scenes_moved_ = 0, corrections_ = 0, without_ground_ = 0;
};

}  // namespace scanway
