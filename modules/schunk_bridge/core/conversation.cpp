#include "modules/schunk_bridge/core/conversation.h"

#include <utility>

namespace scanway::schunk {
namespace {

// Every command is answered at once; these leave a loaded host its time.
constexpr Utime kPatience = 150'000;
constexpr int kTries = 3;
constexpr Utime kPatienceWithStops = 50'000;
constexpr int kTriesOfStops = 10;

bool answers(const Message& request, const Message& message, const Reply& reply) {
  if (const auto* alert = std::get_if<reply::Alert>(&reply)) {
    // A fast stop is answered by the error that it causes. Infos of one byte tell why a command failed.
    if (request.command == Command::cmd_fast_stop) return message.command == Command::cmd_error && alert->code == 0xD9;
    return message.command == Command::cmd_info && alert->asked;
  }
  if (request.command != message.command) return false;
  if (const auto* value = std::get_if<reply::SettingValue>(&reply)) {
    return request.parameters.size() == 1 && request.parameters[0] == static_cast<std::uint8_t>(value->setting);
  }
  return true;
}

}  // namespace

void Conversation::ask(Message message, bool needed) {
  queue_.push_back({std::move(message), needed, kTries, kPatience, {}});
}

void Conversation::urge(Message message) {
  clear();
  queue_.push_back({std::move(message), true, kTriesOfStops, kPatienceWithStops, {}});
  urgent_ = true;
}

void Conversation::clear() {
  queue_.clear();
  frames_.clear();
  urgent_ = false;
}

std::optional<CanFrame> Conversation::next_frame(Utime now) {
  if (frames_.empty() && !queue_.empty() && !queue_.front().sent) {
    Asked& next = queue_.front();
    next.sent = now;
    --next.tries_left;
    for (const CanFrame& frame : to_frames(next.message)) frames_.push_back(frame);
  }
  if (frames_.empty()) return std::nullopt;
  const CanFrame frame = frames_.front();
  frames_.pop_front();
  return frame;
}

Asked Conversation::take_front() {
  Asked asked = std::move(queue_.front());
  queue_.pop_front();
  urgent_ = false;
  return asked;
}

std::optional<Asked> Conversation::answered_by(const Message& message, const Reply& reply) {
  if (queue_.empty() || !queue_.front().sent || !answers(queue_.front().message, message, reply)) return std::nullopt;
  frames_.clear();
  return take_front();
}

std::optional<Asked> Conversation::given_up(Utime now) {
  if (queue_.empty() || !queue_.front().sent || now - *queue_.front().sent < queue_.front().patience)
    return std::nullopt;
  if (queue_.front().tries_left > 0) {
    queue_.front().sent.reset();
    return std::nullopt;
  }
  return take_front();
}

}  // namespace scanway::schunk
