#pragma once

#include <cstdint>

namespace scanway {

/// Random numbers that depend on the seed alone: the same on every machine and with every library.
/// SplitMix64 (Steele, Lea, Flood: Fast Splittable Pseudorandom Number Generators, OOPSLA 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next();
  /// In [0, 1).
  double uniform();
  /// In [0, n), n > 0; without bias.
  std::uint64_t below(std::uint64_t n);
  /// Normal with mean 0 and deviation 1.
  double normal();

 private:
  std::uint64_t state_;
};

}  // namespace scanway
