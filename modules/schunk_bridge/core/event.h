#pragma once

#include <cstdint>
#include <string>

#include "common/time/utime.h"

namespace scanway::schunk {

/// Something that happened to an axis or to the sweep, for the bus, the health and the log.
struct Event {
  enum class Kind : std::uint8_t {
    found,          ///< The module answers, and is set up.
    lost,           ///< It does not answer (any more).
    booted,         ///< It has restarted.
    referenced,     ///< It knows its zero now.
    started,        ///< A move has been accepted.
    reached,        ///< A move has ended at its target.
    blocked,        ///< A move has ended elsewhere.
    stopped,        ///< It has taken a stop.
    refused,        ///< It did not carry out a command.
    error,          ///< It reports an error (`code`): its motor is off.
    warning,        ///< It reports a warning (`code`).
    info,           ///< It reports something else (`code`).
    cleared,        ///< Its errors are gone.
    sweep_started,  ///< From here on the sweep's lines count. `position` is the pan angle.
    sweep_ended,    ///< Up to here.
    sweep_done,     ///< The pan is back at the sweep's start, or its way back was given up.
    sweep_aborted,  ///< Given up before its end.
  };
  Kind kind{};
  Utime utime = 0;
  std::string axis;        ///< "pan", "tilt"; empty for sweeps.
  std::uint8_t code = 0;   ///< The module's.
  double position = 0;     ///< Radians, where one is said.
  std::int64_t sweep = 0;  ///< Number of the sweep.
  std::string reason;      ///< Why a sweep was given up.
  std::string text;        ///< One line for people.
};

}  // namespace scanway::schunk
