#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "common/bytes/frame_finder.h"

namespace scanway::sick {

/// The two spellings of SICK's command language: ASCII between STX and ETX, or binary with a length and a checksum.
enum class Dialect : std::uint8_t { cola_a, cola_b };

/// "cola_a", "cola_b".
const char* name_of(Dialect dialect);

/// A telegram whose frame is whole, and whose content is not what its name promises. what() says what, in one line.
class BadTelegram : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One telegram, out of its frame.
struct Telegram {
  Dialect dialect = Dialect::cola_b;
  std::string command;     ///< sRN, sRA, sWN, sWA, sMN, sAN, sEN, sEA, sSN or sFA.
  std::string name;        ///< Of the variable, method or event; empty for sFA.
  std::string parameters;  ///< As the dialect spells them.
};

/// Every frame of either dialect begins with this byte.
constexpr std::uint8_t kStx = 0x02;
/// Longest bodies that are taken for real: with five echoes and remission an LMS5xx sends at most half of this.
constexpr std::size_t kMaxBodyBinary = 32 * 1024;
constexpr std::size_t kMaxBodyAscii = 96 * 1024;

/// The rule of both dialects for a FrameFinder: what begins at bytes[0].
FrameProbe probe_frame(std::span<const std::uint8_t> bytes);

/// A finder of frames of both dialects.
inline FrameFinder make_frame_finder() { return FrameFinder(probe_frame, kStx); }

/// The telegram in a whole frame. Throws BadTelegram when it has no name.
Telegram open_frame(std::span<const std::uint8_t> frame);

/// `body` in its frame, ready to be sent.
std::string make_frame(Dialect dialect, std::string_view body);

}  // namespace scanway::sick
