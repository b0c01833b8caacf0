#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/cloud/sweep.h"
#include "common/messages/codec.h"
#include "scanway/sweep_t.hpp"

namespace scanway {

/// Without orientation, which travels on IMU, and without the beams that gave no return.
sweep_t to_message(const Sweep& sweep);
/// Throws BadMessage when it contradicts itself.
Sweep to_sweep(const sweep_t& message);

/// The object that travels on SWEEP: a sweep_t, or a full_sweep_t if beams gave no return. Without orientation.
std::vector<std::uint8_t> encode(const Sweep& sweep);
/// Of either. Throws BadMessage.
template <>
Sweep decode<Sweep>(std::span<const std::uint8_t> bytes);

}  // namespace scanway
