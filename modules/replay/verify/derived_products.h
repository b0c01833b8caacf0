#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>

#include "common/bus/bus.h"
#include "modules/replay/verify/recorded_log.h"

namespace scanway {

/// What a mapper derives of one sweep, as names: products are compared by channel, key, version and digest.
class DerivedProducts {
 public:
  /// Takes what is published to `bus`; it must not outlive this.
  void listen(Bus& bus);
  void clear() { digests_.clear(); }

  /// How what was recorded of a sweep differs from this: one line for the first that does; empty: in nothing.
  std::string difference(const RecordedLog& log, Utime sweep) const;

 private:
  using Key = std::tuple<std::string, std::string, std::int64_t>;  // Channel, key, version.

  std::string difference(const RecordedLog& log, const RecordedName& recorded) const;

  std::map<Key, std::int64_t> digests_;
};

/// "digest A in the log, B derived from it".
std::string both_digests(std::int64_t recorded, std::int64_t derived);

}  // namespace scanway
