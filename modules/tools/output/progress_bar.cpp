#include "modules/tools/output/progress_bar.h"

#include <unistd.h>

#include <cstdio>
#include <utility>

#include <fmt/format.h>

namespace scanway::tools {

ProgressBar::ProgressBar(std::string what) : what_(std::move(what)), terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (drawn_percent_ >= 0) std::fputs("\r\033[K", stderr);
}

void ProgressBar::show(double share) {
  const int percent = static_cast<int>(100.0 * share);
  if (!terminal_ || percent == drawn_percent_) return;
  drawn_percent_ = percent;
  std::fputs(fmt::format("\r{} {:3} %", what_, percent).c_str(), stderr);
}

}  // namespace scanway::tools
