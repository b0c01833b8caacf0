#pragma once

#include <cstddef>
#include <vector>

#include "common/cloud/sweep.h"

namespace scanway {

/// The sweeps of the map, to make it again where their poses move.
class SweepArchive {
 public:
  void keep(const Sweep& sweep) { sweeps_.push_back(sweep); }
  const Sweep& fetch(std::size_t number) const { return sweeps_[number]; }
  std::size_t size() const { return sweeps_.size(); }

 private:
  std::vector<Sweep> sweeps_;
};

}  // namespace scanway
