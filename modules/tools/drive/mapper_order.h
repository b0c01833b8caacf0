#pragma once

#include <string>

#include "scanway/map_answer_t.hpp"

namespace scanway::tools {

struct MapperOrder {
  std::string name;     ///< Of the sweep to withdraw, as REGISTRATION says it; of the map to save.
  std::string lcm_url;  ///< Empty: LCM_DEFAULT_URL, or LCM's default.
};

/// `scanway map withdraw`: has the live mapper take a sweep out of its map. `scanway map keep`: has it save its map in
/// the folder of its --maps. Both wait until it has, and return 1 when it refused. Throw InputError when no mapper is
/// heard.
int run_withdraw(const MapperOrder& order);
int run_keep_map(const MapperOrder& order);

}  // namespace scanway::tools
