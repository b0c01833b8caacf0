#include "modules/schunk_bridge/core/message.h"

#include <algorithm>

namespace scanway::schunk {
namespace {

constexpr std::size_t kBytesOfSingleFrame = 7;
constexpr std::size_t kBytesOfFragment = 6;
/// Fragments of a message follow each other within a millisecond or two on a quiet bus.
constexpr Utime kFragmentTimeout = 100'000;

bool is_fragment(Command command) {
  return command == Command::fragment_first || command == Command::fragment_middle || command == Command::fragment_last;
}

CanFrame make_frame(const Message& message, std::size_t length, Command command) {
  CanFrame frame;
  frame.id = can_id(message.direction, message.module);
  frame.data[0] = static_cast<std::uint8_t>(length);
  frame.data[1] = static_cast<std::uint8_t>(command);
  frame.size = 2;
  return frame;
}

Message empty_message(const CanFrame& frame, std::size_t number, Utime now) {
  Message message;
  message.direction = static_cast<Direction>(frame.id >> 8);
  message.module = static_cast<std::uint8_t>(frame.id & 0xFF);
  message.utime = now;
  message.frames = {number};
  return message;
}

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

bool is_motion_protocol(std::uint16_t id) {
  const int kind = id >> 8;
  return (kind == 3 || kind == 5 || kind == 7) && (id & 0xFF) != 0;
}

std::uint16_t can_id(Direction direction, std::uint8_t module) {
  return static_cast<std::uint16_t>((static_cast<unsigned>(direction) << 8) | module);
}

std::vector<CanFrame> to_frames(const Message& message) {
  std::vector<std::uint8_t> bytes = {static_cast<std::uint8_t>(message.command)};
  bytes.insert(bytes.end(), message.parameters.begin(), message.parameters.end());
  std::vector<CanFrame> frames;
  if (bytes.size() <= kBytesOfSingleFrame) {
    frames.push_back(make_frame(message, bytes.size(), message.command));
    std::copy(message.parameters.begin(), message.parameters.end(), frames.back().data.begin() + 2);
    frames.back().size = static_cast<std::uint8_t>(1 + bytes.size());
    return frames;
  }
  for (std::size_t at = 0; at < bytes.size(); at += kBytesOfFragment) {
    const std::size_t rest = bytes.size() - at, count = std::min(rest, kBytesOfFragment);
    const Command code = at == 0                   ? Command::fragment_first
                         : rest > kBytesOfFragment ? Command::fragment_middle
                                                   : Command::fragment_last;
    frames.push_back(make_frame(message, rest, code));
    std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), count, frames.back().data.begin() + 2);
    frames.back().size = static_cast<std::uint8_t>(2 + count);
  }
  return frames;
}

MessageAssembler::Result MessageAssembler::add(const CanFrame& frame, std::size_t number, Utime now) {
  Result result;
  const std::size_t length = frame.size > 0 ? frame.data[0] : 0;
  const Command command = frame.size > 1 ? static_cast<Command>(frame.data[1]) : Command{};
  if (frame.size < 2) {
    result.bad.push_back({{number}, "the frame is too short to hold a command"});
  } else if (command == Command::fragment_first) {
    begin(frame, number, now, result);
  } else if (is_fragment(command)) {
    append(frame, number, now, result);
  } else if (length == 0) {
    result.bad.push_back({{number}, "D-Len 0 leaves no room for a command"});
  } else if (length + 1 > frame.size) {
    result.bad.push_back(
        {{number}, "D-Len says " + counted(length, "byte") + ", the frame holds " + std::to_string(frame.size - 1)});
  } else {
    result.message = empty_message(frame, number, now);
    result.message->command = command;
    result.message->parameters.assign(frame.data.begin() + 2, frame.data.begin() + 1 + static_cast<long>(length));
  }
  return result;
}

void MessageAssembler::begin(const CanFrame& frame, std::size_t number, Utime now, Result& result) {
  const auto before = incomplete_.find(frame.id);
  if (before != incomplete_.end()) {
    result.bad.push_back({before->second.message.frames, "the rest of the fragmented message never came"});
    incomplete_.erase(before);
  }
  const std::size_t total = frame.data[0];
  if (total <= kBytesOfFragment || frame.size < 8) {
    result.bad.push_back({{number},
                          "a first fragment of a message of " + counted(total, "byte") + " in a frame of " +
                              counted(frame.size, "byte")});
    return;
  }
  Incomplete set{empty_message(frame, number, now), total, {frame.data.begin() + 2, frame.data.end()}};
  incomplete_.emplace(frame.id, std::move(set));
}

void MessageAssembler::append(const CanFrame& frame, std::size_t number, Utime now, Result& result) {
  const auto found = incomplete_.find(frame.id);
  if (found == incomplete_.end()) {
    result.bad.push_back({{number}, "a fragment without the beginning of its message"});
    return;
  }
  Incomplete& set = found->second;
  set.message.frames.push_back(number);
  const std::size_t missing = set.total - set.bytes.size(), count = std::min(missing, kBytesOfFragment);
  const bool last = frame.data[1] == static_cast<std::uint8_t>(Command::fragment_last);
  std::string fault;
  if (now - set.message.utime > kFragmentTimeout) {
    fault = "the fragment came too late";
  } else if (frame.data[0] != missing) {
    fault =
        "the fragment announces " + counted(frame.data[0], "byte") + ", " + std::to_string(missing) + " are missing";
  } else if (frame.size < count + 2) {
    fault = "the fragment is shorter than it says";
  } else if (last && count < missing) {
    fault = "the last fragment leaves bytes missing";
  }
  if (!fault.empty()) {
    result.bad.push_back({set.message.frames, fault});
    incomplete_.erase(found);
    return;
  }
  set.bytes.insert(set.bytes.end(), frame.data.begin() + 2, frame.data.begin() + 2 + static_cast<long>(count));
  if (last) finish(found, result);
}

void MessageAssembler::finish(std::map<std::uint16_t, Incomplete>::iterator set, Result& result) {
  Incomplete& whole = set->second;
  if (is_fragment(static_cast<Command>(whole.bytes[0]))) {
    result.bad.push_back({whole.message.frames, "a fragmented message within a fragmented message"});
  } else {
    result.message = std::move(whole.message);
    result.message->command = static_cast<Command>(whole.bytes[0]);
    result.message->parameters.assign(whole.bytes.begin() + 1, whole.bytes.end());
  }
  incomplete_.erase(set);
}

std::vector<BadFrames> MessageAssembler::give_up(const std::string& reason) {
  std::vector<BadFrames> bad;
  for (auto& [id, set] : incomplete_) bad.push_back({std::move(set.message.frames), reason});
  incomplete_.clear();
  return bad;
}

}  // namespace scanway::schunk
