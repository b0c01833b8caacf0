#pragma once

#include <cstddef>
#include <set>
#include <string>

#include "common/bus/bus.h"
#include "modules/tools/spy/traffic.h"

namespace scanway::tools {

/// Shows a bus to programs that know LCM but no pieces, such as lcm-spy: passes everything on to a second bus, objects
/// whole. What is bad is left out: LCM's decoders trust the lengths in a message.
class Relay {
 public:
  /// `to` must outlive this.
  explicit Relay(Bus& to) : to_(to) {}

  void pass(const Sighting& sighting);

  /// Larger objects are passed on as the pieces that they came in: one datagram that is lost loses a whole message.
  static constexpr std::size_t kMostObjectBytes = std::size_t{1} << 20;

 private:
  Bus& to_;
  std::set<std::string, std::less<>> told_;  // Channels whose bad messages were told of.
};

}  // namespace scanway::tools
