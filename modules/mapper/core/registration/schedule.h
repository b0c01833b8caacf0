#pragma once

#include <array>

#include "modules/mapper/core/registration/icp.h"

namespace scanway::registration {

/// From a hypothesis, which may be a metre off, to a pose whose agreement can be judged.
constexpr std::array<IcpRound, 1> kFirstRound = {{{1.2f, 0.4f, 6}}};
constexpr std::array<IcpRound, 1> kSecondRound = {{{0.6f, 0.2f, 8}}};
/// From there to the last millimetre.
constexpr std::array<IcpRound, 2> kFineRounds = {{{0.5f, 0.1f, 10}, {0.5f, 0.1f, 20, true}}};

}  // namespace scanway::registration
