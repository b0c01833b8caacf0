#pragma once

#include <string>

namespace scanway::tools {

/// One line on a terminal's standard error that says how far long work is. Draws nothing where there is no terminal.
class ProgressBar {
 public:
  explicit ProgressBar(std::string what);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// `share` of the work is done, from 0 to 1.
  void show(double share);

 private:
  std::string what_;
  bool terminal_;
  int drawn_percent_ = -1;
};

}  // namespace scanway::tools
