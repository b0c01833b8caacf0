#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "common/bytes/can_frame.h"
#include "common/time/utime.h"

namespace scanway::schunk {

/// A line of a CAN recording.
struct CanLine {
  enum class Kind { data, extended, remote, error, flexible };
  Kind kind = Kind::data;
  std::uint32_t id = 0;  ///< As it stands there; of an error frame the classes of the error.
  CanFrame frame;        ///< Its bytes; its id only when the kind is `data`.
  std::optional<Utime> utime;
  std::string_view interface;
};

/// Reads one line in any of these forms; nothing if it is in none of them.
///   (1436509052.249713) can0 501#0192            candump -L, candump -l
///   501#0192                                      cansend
///   (1436509052.249713)  can0  501   [2]  01 92   candump on the screen, with or without the time
std::optional<CanLine> parse_can_line(std::string_view line);

/// What an error frame of SocketCAN says (linux/can/error.h), in words: "bus off", "no acknowledgement, bus error".
std::string describe_error_frame(std::uint32_t id);

}  // namespace scanway::schunk
