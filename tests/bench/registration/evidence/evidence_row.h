#pragma once

#include <optional>
#include <string>

#include "modules/mapper/core/registration/conclusion.h"
#include "tests/bench/registration/real_pairs.h"

namespace scanway::bench {

/// What is known of a pair beforehand.
struct KnownPair {
  std::string set;
  std::optional<Pose> truth;  ///< T_target_source; none for scans of different places, which have no right pose.
  double overlap = 0.0;       ///< True overlap, 0 without a truth.
  double right_m = 0.1, right_angle = 0.0087266;
};

void print_header();

/// Registers the pair as register_scans() does and prints one CSV line of what the verdict saw at its end.
void print_evidence(const KnownPair& known, const PreparedScan& source, const PreparedScan& target,
                    const std::optional<OrientationPrior>& prior);

}  // namespace scanway::bench
