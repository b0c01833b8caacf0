#include "modules/sick_bridge/core/cola.h"

#include <algorithm>
#include <optional>

#include "common/bytes/big_endian.h"

namespace scanway::sick {
namespace {

constexpr std::uint8_t kEtx = 0x03;
constexpr std::size_t kHeaderBinary = 8;  // Four STX and the length.
constexpr std::size_t kCommandLength = 3;
constexpr std::string_view kCommands[] = {"sRN", "sRA", "sWN", "sWA", "sMN", "sAN", "sEN", "sEA", "sSN", "sFA"};

bool is_stx(std::uint8_t byte) { return byte == kStx; }

/// Whether a body may begin like this: with a command, or as much of one as there is.
bool begins_with_command(std::span<const std::uint8_t> body) {
  const std::size_t length = std::min(body.size(), kCommandLength);
  return std::any_of(std::begin(kCommands), std::end(kCommands), [&](std::string_view command) {
    return std::equal(command.begin(), command.begin() + static_cast<std::ptrdiff_t>(length), body.begin(),
                      body.begin() + static_cast<std::ptrdiff_t>(length));
  });
}

std::uint8_t checksum(std::span<const std::uint8_t> body) {
  std::uint8_t sum = 0;
  for (const std::uint8_t byte : body) sum ^= byte;
  return sum;
}

/// The length of the body that a binary header promises; nothing if these bytes are none.
std::optional<std::size_t> length_in_header(std::span<const std::uint8_t> bytes) {
  const auto start = bytes.first(4);
  if (!std::all_of(start.begin(), start.end(), is_stx)) return std::nullopt;
  const std::size_t length = BigEndianReader(bytes.subspan(4)).u32();
  if (length < kCommandLength || length > kMaxBodyBinary) return std::nullopt;
  if (!begins_with_command(bytes.subspan(kHeaderBinary))) return std::nullopt;
  return length;
}

/// Whether another telegram begins inside this one: no data look like that. Then this one was cut short, or its length
/// is wrong, and its checksum of one byte is right by accident.
bool another_begins_inside(std::span<const std::uint8_t> frame) {
  const auto end = frame.end() - static_cast<std::ptrdiff_t>(kHeaderBinary + kCommandLength);
  for (auto at = std::find(frame.begin() + 1, end, kStx); at < end; at = std::find(at + 1, end, kStx)) {
    if (length_in_header(frame.subspan(static_cast<std::size_t>(at - frame.begin())))) return true;
  }
  return false;
}

FrameProbe probe_binary(std::span<const std::uint8_t> bytes) {
  const auto start = bytes.first(std::min<std::size_t>(bytes.size(), 4));
  if (!std::all_of(start.begin(), start.end(), is_stx)) return FrameProbe::none();
  if (bytes.size() < kHeaderBinary) return FrameProbe::unfinished();
  const auto length = length_in_header(bytes);
  if (!length) return FrameProbe::none();
  const std::size_t whole = kHeaderBinary + *length + 1;
  if (bytes.size() < whole) return FrameProbe::unfinished();
  if (checksum(bytes.subspan(kHeaderBinary, *length)) != bytes[whole - 1]) return FrameProbe::broken("wrong checksum");
  if (another_begins_inside(bytes.first(whole))) return FrameProbe::broken("cut short: another telegram begins in it");
  return FrameProbe::whole(whole);
}

FrameProbe probe_ascii(std::span<const std::uint8_t> bytes) {
  if (!begins_with_command(bytes.subspan(1))) return FrameProbe::none();
  const std::size_t limit = std::min(bytes.size(), kMaxBodyAscii + 2);
  for (std::size_t i = 1; i < limit; ++i) {
    if (bytes[i] == kEtx) return i > kCommandLength ? FrameProbe::whole(i + 1) : FrameProbe::none();
    if (bytes[i] < ' ') return FrameProbe::broken("a byte that is no text before the end of the telegram");
  }
  if (bytes.size() > limit) return FrameProbe::broken("no end within the longest telegram");
  return FrameProbe::unfinished();
}

std::string_view text(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

const char* name_of(Dialect dialect) { return dialect == Dialect::cola_a ? "cola_a" : "cola_b"; }

FrameProbe probe_frame(std::span<const std::uint8_t> bytes) {
  if (bytes[0] != kStx) return FrameProbe::none();
  if (bytes.size() == 1) return FrameProbe::unfinished();
  if (bytes[1] != kStx) return probe_ascii(bytes);
  return probe_binary(bytes);
}

Telegram open_frame(std::span<const std::uint8_t> frame) {
  Telegram telegram;
  telegram.dialect = frame[1] == kStx ? Dialect::cola_b : Dialect::cola_a;
  const auto body = telegram.dialect == Dialect::cola_b
                        ? text(frame.subspan(kHeaderBinary, frame.size() - kHeaderBinary - 1))
                        : text(frame.subspan(1, frame.size() - 2));
  telegram.command = body.substr(0, kCommandLength);
  std::string_view rest = body.substr(kCommandLength);
  if (telegram.command == "sFA") {
    // Binary: the code follows without a blank; one with a blank is printed in the listing, so both are read.
    const bool blank = telegram.dialect == Dialect::cola_a ? rest.starts_with(' ') : rest.size() == 3 && rest[0] == ' ';
    telegram.parameters = rest.substr(blank ? 1 : 0);
    return telegram;
  }
  if (!rest.starts_with(' ')) throw BadTelegram(telegram.command + " without the name of what it is about");
  rest.remove_prefix(1);
  telegram.name = rest.substr(0, rest.find(' '));
  if (telegram.name.empty()) throw BadTelegram(telegram.command + " without the name of what it is about");
  if (telegram.name.size() < rest.size()) telegram.parameters = rest.substr(telegram.name.size() + 1);
  return telegram;
}

std::string make_frame(Dialect dialect, std::string_view body) {
  if (dialect == Dialect::cola_a) return '\x02' + std::string(body) + '\x03';
  std::string frame(4, static_cast<char>(kStx));
  append_big_endian(frame, body.size(), 4);
  frame += body;
  frame.push_back(
      static_cast<char>(checksum(std::span(reinterpret_cast<const std::uint8_t*>(body.data()), body.size()))));
  return frame;
}

}  // namespace scanway::sick
