#include "common/random/random.h"

#include <cmath>
#include <limits>

#include "common/math/repeatable.h"

namespace scanway {

std::uint64_t Random::next() {
  state_ += 0x9E3779B97F4A7C15u;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

double Random::uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }

std::uint64_t Random::below(std::uint64_t n) {
  const std::uint64_t threshold = (0 - n) % n;
  for (;;) {
    const std::uint64_t value = next();
    if (value >= threshold) return value % n;
  }
}

double Random::normal() {
  // Box and Muller; 1 - u keeps the logarithm's argument above zero.
  const double radius = std::sqrt(-2.0 * repeatable::log(1.0 - uniform()));
  return radius * repeatable::cos(2.0 * repeatable::kPi * uniform());
}

}  // namespace scanway
