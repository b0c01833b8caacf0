#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "modules/mapper/core/assembly/assembly.h"

namespace scanway {

/// What became of the sweeps that the pan-tilt has made: in numbers, and of the last one in words.
class SweepTally {
 public:
  void made(const AssembledSweep& assembled);
  void given_up(const std::string& sweep, const std::string& reason);
  void never_ended(const std::string& sweep);
  void never_started() { ++never_started_; }

  std::map<std::string, std::int64_t> counters() const;
  /// Of the last sweep, what people should know; empty: nothing.
  const std::string& note() const { return note_; }

 private:
  void count(const AssemblyReport& report);

  std::string note_;
  std::int64_t sweeps_ = 0, aborted_ = 0, never_ended_ = 0, never_started_ = 0, empty_ = 0, moved_ = 0;
  std::int64_t missing_lines_ = 0, missing_beams_ = 0, without_angle_ = 0;
};

}  // namespace scanway
