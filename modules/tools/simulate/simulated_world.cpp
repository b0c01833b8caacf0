#include "modules/tools/simulate/simulated_world.h"

#include "common/files/input_error.h"
#include "common/files/printable.h"

namespace scanway::tools {

using namespace scanway::simulator;

World world_of(const std::string& name, std::uint64_t seed) {
  std::string known;
  for (const WorldKind& kind : world_kinds()) {
    if (kind.name == name) return make_world(name, seed);
    known += (known.empty() ? "" : ", ") + std::string(kind.name);
  }
  throw InputError("--world " + in_quotes(name) + ": there is no such world; the worlds are " + known);
}

}  // namespace scanway::tools
