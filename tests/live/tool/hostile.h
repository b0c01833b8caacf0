#pragma once

#include "common/bus/bus.h"

namespace scanway::test {

/// Sends to every channel messages of its own type that lie: lengths below zero or beyond all memory, cut off, longer
/// than they say, of other types; and objects that are such messages, in good pieces.
void send_hostile(Bus& bus);

}  // namespace scanway::test
