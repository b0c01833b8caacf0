#pragma once

#include <cstdint>

#include "common/random/random.h"

namespace scanway::simulator {

/// A line that loses bytes. The seed and what passed before decide which.
class ByteLoss {
 public:
  explicit ByteLoss(std::uint64_t seed) : random_(seed) {}

  /// Of all bytes; 0: none.
  void set_share(double share) { share_ = share; }

  /// What comes through of `bytes`, a string or a vector of bytes.
  template <class Bytes>
  Bytes pass(Bytes bytes) {
    if (share_ > 0.0) std::erase_if(bytes, [this](auto) { return random_.uniform() < share_; });
    return bytes;
  }

 private:
  Random random_;
  double share_ = 0.0;
};

}  // namespace scanway::simulator
