#pragma once

#include <optional>

#include "tests/bench/planning/scenes.h"

namespace scanway::bench {

enum class Sampler { rrt_connect, bit_star, prm_star };
const char* name_of(Sampler sampler);

struct SampledWay {
  double ms = 0.0;  ///< CPU.
  double length = 0.0;
};

/// A way for a point from corner to corner by one of OMPL's planners, with its own shortening of the path. RRT-Connect
/// ends with the first way that it finds; the others, which go on to shorten theirs, when the time is over. Nothing
/// when there is none by then.
std::optional<SampledWay> sample(const Scene& scene, Sampler sampler, double most_seconds);

}  // namespace scanway::bench
