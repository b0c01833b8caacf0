#pragma once

#include <string>

namespace scanway::tools {

/// Shows a text on standard output: on a terminal in place of the one before, cut to the terminal's size.
class Screen {
 public:
  Screen();

  bool is_terminal() const { return terminal_; }
  void show(const std::string& text) const;

 private:
  bool terminal_;
};

}  // namespace scanway::tools
