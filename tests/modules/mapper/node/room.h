#pragma once

#include <string>

#include "common/cloud/sweep.h"
#include "common/random/random.h"

namespace scanway::test {

/// A floor and four walls around the sensor, which stands 1 m above the floor.
inline Sweep room(Utime utime, const std::string& name) {
  Random random(1);
  Sweep sweep;
  sweep.name = name;
  sweep.utime = utime;
  const auto add = [&](double x, double y, double z) {
    sweep.cloud.points.emplace_back(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
  };
  for (int i = 0; i < 6000; ++i) {
    const double u = 8.0 * random.uniform() - 4.0, v = 6.0 * random.uniform() - 3.0, h = 2.5 * random.uniform() - 1.0;
    add(u, v, -1.0);
    add(u, random.uniform() < 0.5 ? -3.0 : 3.0, h);
    add(random.uniform() < 0.5 ? -4.0 : 4.0, v, h);
  }
  return sweep;
}

}  // namespace scanway::test
