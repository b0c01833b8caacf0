#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "common/progress/stages.h"

namespace scanway {

/// Wall seconds by stage, in the order in which the stages first began. For programs; a core never sees it.
class StageTimer : public StageListener {
 public:
  void begin(std::string_view name) override;
  /// Stages and their seconds; the stage under way ends.
  const std::vector<std::pair<std::string, double>>& finish();
  double total_s() const;

 private:
  std::vector<std::pair<std::string, double>> seconds_;
  std::string current_;
  std::chrono::steady_clock::time_point started_;
};

}  // namespace scanway
