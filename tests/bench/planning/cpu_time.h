#pragma once

#include <ctime>
#include <map>
#include <string>

#include "common/progress/stages.h"

namespace scanway::bench {

inline double cpu_now_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// CPU milliseconds of this process while `work` runs.
template <class Work>
double cpu_ms(Work&& work) {
  const double begin = cpu_now_ms();
  work();
  return cpu_now_ms() - begin;
}

/// CPU milliseconds by stage.
class CpuStages : public StageListener {
 public:
  void begin(std::string_view name) override {
    const double now = cpu_now_ms();
    ms_[stage_] += now - began_;
    stage_ = name;
    began_ = now;
  }
  /// The stage under way ends.
  double of(const std::string& stage) {
    begin("");
    return ms_[stage];
  }

 private:
  std::map<std::string, double> ms_;
  std::string stage_;
  double began_ = cpu_now_ms();
};

}  // namespace scanway::bench
