#pragma once

#include <cstdint>
#include <string>

namespace scanway::test {

struct RelayOptions {
  std::uint64_t seed = 1;
  double lost = 0.0;     ///< Of the datagrams of each direction, in [0, 1].
  double twice = 0.0;    ///< Go twice.
  double held_ms = 0.0;  ///< Each copy waits for a time of its own, from 0 up to this: so they overtake each other.
};

/// Two multicast groups as two machines: carries the datagrams of LCM from one to the other and does to them what a bad
/// network does. Prints what became of them, a line a direction (ab, ba), fate (SENT, LOST, TWICE, OVERTAKEN) and
/// channel; ends on INT or TERM. Groups: ADDRESS:PORT, with ports of their own.
int relay(const std::string& group_a, const std::string& group_b, const RelayOptions& options);

}  // namespace scanway::test
