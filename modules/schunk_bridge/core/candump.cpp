#include "modules/schunk_bridge/core/candump.h"

#include <charconv>

namespace scanway::schunk {
namespace {

constexpr std::uint32_t kErrorFlag = 0x20000000, kRemoteFlag = 0x40000000;

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/// Cuts the next word off the line; empty at the end.
std::string_view next_word(std::string_view& line) {
  std::size_t begin = 0;
  while (begin < line.size() && is_space(line[begin])) ++begin;
  std::size_t end = begin;
  while (end < line.size() && !is_space(line[end])) ++end;
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

template <class T>
bool parse_whole(std::string_view text, T& value, int base) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  return error == std::errc{} && end == text.data() + text.size() && !text.empty();
}

/// "(seconds.microseconds)".
std::optional<Utime> parse_time(std::string_view word) {
  if (word.size() < 10 || word.front() != '(' || word.back() != ')') return std::nullopt;
  word = word.substr(1, word.size() - 2);
  const std::size_t point = word.find('.');
  if (point == std::string_view::npos || word.size() - point != 7 || point > 12) return std::nullopt;
  std::uint64_t seconds = 0, microseconds = 0;
  if (!parse_whole(word.substr(0, point), seconds, 10) || !parse_whole(word.substr(point + 1), microseconds, 10)) {
    return std::nullopt;
  }
  return static_cast<Utime>(seconds) * kMicrosecondsPerSecond + static_cast<Utime>(microseconds);
}

/// Three digits are a standard identifier, eight an extended one or flags.
bool parse_id(std::string_view word, CanLine& line) {
  if ((word.size() != 3 && word.size() != 8) || !parse_whole(word, line.id, 16)) return false;
  if (word.size() == 3) {
    line.frame.id = static_cast<std::uint16_t>(line.id);
    return line.id <= 0x7FF;
  }
  line.kind = (line.id & kErrorFlag) ? CanLine::Kind::error : CanLine::Kind::extended;
  if (line.id & kRemoteFlag) line.kind = CanLine::Kind::remote;
  return true;
}

bool append_byte(std::string_view digits, CanFrame& frame) {
  return frame.size < 8 && digits.size() == 2 && parse_whole(digits, frame.data[frame.size++], 16);
}

/// "0192", also "01.92"; "R" or "R8" for a remote frame; "#..." is CAN FD.
bool parse_compact_data(std::string_view data, CanLine& line) {
  if (data.starts_with('#')) {
    line.kind = CanLine::Kind::flexible;
    return true;
  }
  if (data.starts_with('R')) {
    line.kind = CanLine::Kind::remote;
    return data.size() <= 2;
  }
  while (!data.empty()) {
    if (data.front() == '.' && line.frame.size > 0) data.remove_prefix(1);
    if (!append_byte(data.substr(0, 2), line.frame)) return false;
    data.remove_prefix(2);
  }
  return true;
}

/// "[2]  01 92", with nothing but bytes after it.
bool parse_screen_data(std::string_view length, std::string_view rest, CanLine& line) {
  unsigned count = 0;
  if (length.size() < 3 || length.back() != ']' || !parse_whole(length.substr(1, length.size() - 2), count, 10)) {
    return false;
  }
  if (length.size() == 4) {  // candump writes [08] for CAN FD.
    line.kind = CanLine::Kind::flexible;
    return true;
  }
  for (unsigned i = 0; i < count; ++i) {
    const std::string_view word = next_word(rest);
    if (i == 0 && word == "remote") {
      line.kind = CanLine::Kind::remote;
      return true;
    }
    if (!append_byte(word, line.frame)) return false;
  }
  const std::string_view after = next_word(rest);
  // With -a and -e candump goes on with the bytes as text and with the meaning of error frames.
  return after.empty() || after.starts_with('\'') || line.kind == CanLine::Kind::error;
}

bool parse_compact(std::string_view word, CanLine& line) {
  const std::size_t hash = word.find('#');
  return hash != std::string_view::npos && parse_id(word.substr(0, hash), line) &&
         parse_compact_data(word.substr(hash + 1), line);
}

}  // namespace

std::optional<CanLine> parse_can_line(std::string_view text) {
  CanLine line;
  std::string_view word = next_word(text);
  if (word.starts_with('(')) {
    line.utime = parse_time(word);
    if (!line.utime) return std::nullopt;
    word = next_word(text);
  }
  if (!line.utime && word.find('#') != std::string_view::npos) {
    const bool good = parse_compact(word, line) && next_word(text).empty();
    return good ? std::optional(line) : std::nullopt;
  }
  line.interface = word;
  word = next_word(text);
  if (word.find('#') != std::string_view::npos) {
    const bool good = parse_compact(word, line);
    word = next_word(text);  // Newer candumps add whether the frame was received or transmitted.
    return good && (word.empty() || word == "R" || word == "T") ? std::optional(line) : std::nullopt;
  }
  if (word == "RX" || word == "TX") {  // candump -x
    next_word(text);
    next_word(text);
    word = next_word(text);
  }
  if (!parse_id(word, line)) return std::nullopt;
  word = next_word(text);
  return parse_screen_data(word, text, line) ? std::optional(line) : std::nullopt;
}

std::string describe_error_frame(std::uint32_t id) {
  struct Class {
    std::uint32_t bit;
    std::string_view name;
  };
  static constexpr Class classes[] = {
      {0x001, "transmit time-out"},
      {0x002, "lost arbitration"},
      {0x004, "controller problem"},
      {0x008, "protocol violation"},
      {0x010, "transceiver status"},
      {0x020, "no acknowledgement"},
      {0x040, "bus off"},
      {0x080, "bus error"},
      {0x100, "controller restarted"},
  };
  std::string text;
  for (const Class& known : classes) {
    if (!(id & known.bit)) continue;
    if (!text.empty()) text += ", ";
    text += known.name;
  }
  return text.empty() ? "unknown error" : text;
}

}  // namespace scanway::schunk
