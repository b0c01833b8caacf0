#pragma once

#include <optional>
#include <string>

namespace scanway::simulator {

/// Lines that somebody writes to this process's standard input, without waiting for them. In the background of a
/// terminal it leaves the input alone.
class Console {
 public:
  /// The next whole line; nothing now.
  std::optional<std::string> next_line();

 private:
  bool read_more();

  std::string waiting_;
  bool ended_ = false;
};

}  // namespace scanway::simulator
