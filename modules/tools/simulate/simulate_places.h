#pragma once

#include <cstdint>
#include <string>

namespace scanway::tools {

struct SimulatePlacesOptions {
  std::string world;
  std::uint64_t seed = 1;
  int count = 3;
  double spacing_m = 5.0;  ///< Along the world's route; 0: spread over all of it.
  bool in_map = false;     ///< In the frame of the map that is made on the bus.
  std::string lcm_url;     ///< Empty: LCM_DEFAULT_URL, or LCM's default.
};

/// `scanway simulate places`: places on the world's route, which the robot can drive, "x,y,yaw" a line, in metres and
/// radians. `in_map`: seen from the map, by the truth that scanway-simulator says; the robot must stand where its
/// newest sweep was taken. Throws InputError.
int run_simulate_places(const SimulatePlacesOptions& options);

}  // namespace scanway::tools
