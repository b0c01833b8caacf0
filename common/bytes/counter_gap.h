#pragma once

#include <cstdint>
#include <optional>

namespace scanway {

/// Finds gaps in the numbers of 16 bits by which devices count what they send: +1 each, and they wrap.
class CounterGap {
 public:
  /// How many are missing between the last number and this one. A number that goes back, by up to half of all, was set
  /// anew: nothing is missing then.
  std::uint16_t missing_before(std::uint16_t number) {
    const auto step = static_cast<std::uint16_t>(last_ ? number - *last_ : 1);
    last_ = number;
    return step > 1 && step < 0x8000 ? static_cast<std::uint16_t>(step - 1) : std::uint16_t{0};
  }
  /// The next number may be any.
  void restart() { last_.reset(); }

 private:
  std::optional<std::uint16_t> last_;
};

}  // namespace scanway
