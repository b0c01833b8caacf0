#include "common/health/health.h"

#include <unistd.h>

#include <array>
#include <chrono>
#include <tuple>
#include <utility>

#include "common/files/printable.h"

namespace scanway {

std::string Identity::text() const {
  return printable(process) + " (process " + std::to_string(id) + " on host " + printable(host) + ")";
}

Identity this_process(std::string process) {
  std::array<char, 256> host{};
  if (::gethostname(host.data(), host.size() - 1) != 0) host = {};
  return {std::move(process), host.data(), static_cast<std::int32_t>(::getpid()), wall_clock()};
}

Identity identity_of(const health_t& message) {
  return {message.process_name, message.host_name, message.process_id, message.start_utime};
}

bool is_elder_twin(const Identity& other, const Identity& mine) {
  const auto order = [](const Identity& who) { return std::tie(who.start, who.host, who.id); };
  return other.process == mine.process && order(other) < order(mine);
}

health_t to_message(const Identity& who, const Health& health, Utime wall_clock) {
  health_t message{};
  message.utime = wall_clock;
  message.process_name = who.process;
  message.host_name = who.host;
  message.process_id = who.id;
  message.start_utime = who.start;
  message.summary = health.summary;
  for (const auto& [name, count] : health.counters) message.counters.push_back({name, count});
  for (const auto& [channel, age] : health.input_ages_s) message.input_ages.push_back({channel, age});
  message.ncounters = static_cast<std::int16_t>(message.counters.size());
  message.ninput_ages = static_cast<std::int16_t>(message.input_ages.size());
  return message;
}

Utime wall_clock() {
  using namespace std::chrono;
  return duration_cast<microseconds>(system_clock::now().time_since_epoch()).count();
}

}  // namespace scanway
