#include "common/health/health.h"

#include <unistd.h>

#include <array>
#include <chrono>
#include <tuple>
#include <utility>

#include "common/files/printable.h"

namespace scanway {
namespace {

constexpr std::size_t kMaxSummaryBytes = 600;
constexpr std::size_t kEntryBytes = 4 + 1 + 8;  // Of an encoded counter or age, beside its name.

health_t head_of(const Identity& who, const std::string& summary, Utime wall_clock) {
  health_t head{};
  head.utime = wall_clock;
  head.process_name = who.process;
  head.host_name = who.host;
  head.process_id = who.id;
  head.start_utime = who.start;
  head.summary = summary.substr(0, kMaxSummaryBytes);
  return head;
}

}  // namespace

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

std::vector<health_t> to_messages(const Identity& who, const Health& health, Utime wall_clock) {
  const health_t head = head_of(who, health.summary, wall_clock);
  std::vector<health_t> messages = {head};
  int size = head.getEncodedSize();
  const auto with_room = [&](const std::string& name) -> health_t& {
    const int needed = static_cast<int>(kEntryBytes + name.size());
    if (size + needed > static_cast<int>(kMaxHealthBytes)) {
      messages.push_back(head);
      size = head.getEncodedSize();
    }
    size += needed;
    return messages.back();
  };
  for (const auto& [name, count] : health.counters) with_room(name).counters.push_back({name, count});
  for (const auto& [channel, age] : health.input_ages_s) with_room(channel).input_ages.push_back({channel, age});
  for (health_t& message : messages) {
    message.ncounters = static_cast<std::int16_t>(message.counters.size());
    message.ninput_ages = static_cast<std::int16_t>(message.input_ages.size());
  }
  return messages;
}

Utime wall_clock() {
  using namespace std::chrono;
  return duration_cast<microseconds>(system_clock::now().time_since_epoch()).count();
}

}  // namespace scanway
