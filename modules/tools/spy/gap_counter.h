#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>

#include "common/messages/layout.h"

namespace scanway::tools {

/// How many messages of a channel did not come, as far as the messages themselves tell: by their numbers (a member
/// `line`, `seq`, `number`, ...), else by their utime, if that is evenly spaced.
class GapCounter {
 public:
  /// `message` must have passed find_fault() with this layout.
  void add(const Layout& layout, std::span<const std::uint8_t> message);

  /// Nothing if this channel's messages do not tell.
  std::optional<std::uint64_t> missing() const;

 private:
  void add_number(std::int64_t number);
  void add_utime(std::int64_t utime);
  /// The step of most of the last messages; nothing if there is none.
  std::optional<double> usual_step() const;

  bool numbered_ = false;
  bool even_ = false;
  std::uint64_t missing_ = 0;
  std::optional<std::int64_t> last_;  // Highest number, or last utime.
  std::deque<std::int64_t> steps_;    // Of utime; the newest kStepsKept.
};

/// The value of an integer member that stands behind nothing but numbers.
std::optional<std::int64_t> integer_member(const Layout& layout, std::span<const std::uint8_t> message,
                                           std::string_view name);

}  // namespace scanway::tools
