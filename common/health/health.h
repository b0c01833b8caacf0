#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "common/time/utime.h"
#include "scanway/health_t.hpp"

namespace scanway {

/// Who a process is, on all machines of the bus.
struct Identity {
  std::string process;
  std::string host;
  std::int32_t id = 0;
  Utime start = 0;  ///< Wall clock.

  std::string text() const;  ///< "mapper (process 12 on host robot)"
};

/// This process, as `process`.
Identity this_process(std::string process);
Identity identity_of(const health_t& message);

/// Whether `other` does the same work and was there before `mine` (or began at once with it, and goes first).
bool is_elder_twin(const Identity& other, const Identity& mine);

/// How a process fares.
struct Health {
  std::string summary;  ///< One line for people; empty: all is well.
  std::map<std::string, std::int64_t> counters;
  std::map<std::string, double> input_ages_s;  ///< By channel; NaN: nothing came yet.
};

/// HEALTH as messages of at most kMaxHealthBytes, one network frame each: all say who and how, each has its share of
/// the counters and ages. Whoever reads them puts them together by name.
std::vector<health_t> to_messages(const Identity& who, const Health& health, Utime wall_clock);
constexpr std::size_t kMaxHealthBytes = 1300;

/// The wall clock: for HEALTH, which tells when a process spoke, and for nothing else.
Utime wall_clock();

}  // namespace scanway
