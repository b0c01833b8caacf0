#pragma once

#include <optional>

#include "common/bytes/can_frame.h"
#include "modules/schunk_bridge/core/listener.h"

/// The protocol of older modules (PowerCube), as far as it takes to name it where it is met. Scanway does not drive
/// them.
namespace scanway::schunk::powercube {

/// Asks a module (1 to 31) for its position, which moves nothing.
CanFrame ask_position(std::uint8_t module);
/// Whether the frame is such a module's answer or state.
bool is_answer(const CanFrame& frame);
/// What a frame with one of the protocol's identifiers says; nothing for other identifiers.
std::optional<Reading> read(const CanFrame& frame);

}  // namespace scanway::schunk::powercube
