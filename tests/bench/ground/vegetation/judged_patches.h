#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "modules/mapper/core/ground/soft_ground.h"
#include "modules/simulator/core/world/surface.h"

namespace scanway::bench {

/// A patch of ground of one sweep, and what it is made of in truth.
struct JudgedPatch {
  GroundPatch patch;
  Softness called = Softness::unknown;
  simulator::Material material = simulator::Material::concrete;

  bool grass() const { return material == simulator::Material::grass; }
};

/// The patches of `sweeps` sweeps along the world's route. Patches in which two materials meet are left out.
/// `brightness`: times the intensities, as of a window that is dirty or a scanner that counts otherwise.
std::vector<JudgedPatch> patches_of_world(const std::string& world, std::uint64_t seed, int sweeps, int thin,
                                          double brightness = 1.0);

}  // namespace scanway::bench
