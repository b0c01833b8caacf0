#pragma once

#include <cstddef>
#include <vector>

#include "common/cloud/sweep.h"

namespace scanway {

/// Holds the sweeps of the map, to move them where their poses move.
class SweepArchive {
 public:
  virtual ~SweepArchive() = default;
  virtual void keep(const Sweep& sweep) = 0;
  /// The sweep that was kept after `number` others.
  virtual Sweep fetch(std::size_t number) const = 0;
};

class SweepsInMemory : public SweepArchive {
 public:
  void keep(const Sweep& sweep) override { sweeps_.push_back(sweep); }
  Sweep fetch(std::size_t number) const override { return sweeps_.at(number); }

 private:
  std::vector<Sweep> sweeps_;
};

}  // namespace scanway
