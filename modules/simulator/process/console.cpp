#include "modules/simulator/process/console.h"

#include <poll.h>
#include <unistd.h>

namespace scanway::simulator {

std::optional<std::string> Console::next_line() {
  while (waiting_.find('\n') == std::string::npos) {
    if (!read_more()) return std::nullopt;
  }
  const std::size_t end = waiting_.find('\n');
  std::string line = waiting_.substr(0, end);
  waiting_.erase(0, end + 1);
  return line;
}

bool Console::read_more() {
  constexpr std::size_t kLongest = 4096;
  const bool in_background = isatty(STDIN_FILENO) == 1 && tcgetpgrp(STDIN_FILENO) != getpgrp();
  pollfd input{STDIN_FILENO, POLLIN, 0};
  if (ended_ || in_background || poll(&input, 1, 0) <= 0) return false;
  char bytes[256];
  const ssize_t count = read(STDIN_FILENO, bytes, sizeof bytes);
  ended_ = count <= 0 || waiting_.size() > kLongest;
  if (count > 0) waiting_.append(bytes, static_cast<std::size_t>(count));
  return !ended_;
}

}  // namespace scanway::simulator
