#pragma once

#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/progress/stages.h"
#include "tests/bench/mapping/products/cpu_time.h"

namespace scanway::bench {

/// CPU seconds by stage.
class CpuStages : public StageListener {
 public:
  void begin(std::string_view name) override {
    const double now = cpu_s();
    if (!stages_.empty()) stages_.back().second += now - began_;
    began_ = now;
    stages_.emplace_back(name, 0.0);
  }
  double total_s() const {
    double total = 0.0;
    for (const auto& [name, seconds] : stages_) total += seconds;
    return total;
  }
  std::string text() const {
    std::string text;
    for (const auto& [name, seconds] : stages_) {
      char stage[64];
      std::snprintf(stage, sizeof(stage), " %s %.3f", name.c_str(), seconds);
      if (!name.empty()) text += stage;
    }
    return text;
  }

 private:
  std::vector<std::pair<std::string, double>> stages_;
  double began_ = 0.0;
};

}  // namespace scanway::bench
