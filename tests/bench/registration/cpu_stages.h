#pragma once

#include <map>
#include <string>

#include "common/progress/stages.h"
#include "tests/bench/registration/cpu_clock.h"

namespace scanway::bench {

/// CPU seconds by stage.
class CpuStages : public StageListener {
 public:
  void begin(std::string_view name) override {
    if (!current_.empty()) seconds[current_] += cpu_s() - since_;
    current_ = name;
    since_ = cpu_s();
  }
  double of(const std::string& stage) const {
    const auto found = seconds.find(stage);
    return found == seconds.end() ? 0.0 : found->second;
  }
  std::map<std::string, double> seconds;

 private:
  std::string current_;
  double since_ = 0.0;
};

}  // namespace scanway::bench
