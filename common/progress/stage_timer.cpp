#include "common/progress/stage_timer.h"

#include <algorithm>

namespace scanway {

void StageTimer::begin(std::string_view name) {
  const auto now = std::chrono::steady_clock::now();
  if (!current_.empty()) {
    const auto stage =
        std::find_if(seconds_.begin(), seconds_.end(), [&](const auto& entry) { return entry.first == current_; });
    stage->second += std::chrono::duration<double>(now - started_).count();
  }
  current_ = name;
  started_ = now;
  const bool known =
      std::any_of(seconds_.begin(), seconds_.end(), [&](const auto& entry) { return entry.first == current_; });
  if (!current_.empty() && !known) seconds_.emplace_back(current_, 0.0);
}

const std::vector<std::pair<std::string, double>>& StageTimer::finish() {
  begin("");
  return seconds_;
}

double StageTimer::total_s() const {
  double total = 0.0;
  for (const auto& [name, seconds] : seconds_) total += seconds;
  return total;
}

}  // namespace scanway
