#pragma once

#include <set>
#include <string>
#include <vector>

#include "common/bus/bus.h"
#include "common/delivery/object_receiver.h"
#include "modules/tools/spy/traffic.h"

namespace scanway::tools {

/// Asks the senders of some channels for the objects that came before we listened, or not whole: as any reader of these
/// channels does.
class Asker {
 public:
  /// `bus` must outlive this.
  Asker(Bus& bus, const std::vector<std::string>& channels);

  void hear(const Sighting& sighting, SteadyTime now);
  void ask(SteadyTime now);

 private:
  std::set<std::string, std::less<>> channels_;
  ObjectReceiver receiver_;
};

}  // namespace scanway::tools
