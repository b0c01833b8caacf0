#include "tests/live/hostile/processes.h"

#include <thread>

#include "common/bus/channels.h"
#include "common/messages/codec.h"
#include "tests/live/hostile/allocation_meter.h"

namespace scanway::test {
namespace {

constexpr auto kNoWait = std::chrono::milliseconds(0);
constexpr auto kPatience = std::chrono::milliseconds(2000);
constexpr int kQuietTurns = 25;
constexpr SteadyTime kUntilHealth = 1'200'000;

// What never becomes whole; a minute otherwise.
LiveBusOptions soon_given_up() {
  LiveBusOptions options;
  options.receiver.give_up_after = 300'000;
  return options;
}

}  // namespace

Processes::Processes()
    : lcm_("memq://"),
      mapper_bus_(lcm_, this_process("mapper"), soon_given_up()),
      planner_bus_(lcm_, this_process("planner"), soon_given_up()),
      mapper_(mapper_bus_, Robot{}),
      planner_(planner_bus_, Robot{}, nullptr, PlannerNode::Pace::live) {
  lcm_.subscribe(channel::kHealth.name, [this](const BusMessage& message) {
    if (told_) return;
    const auto health = decode<health_t>(message.bytes);
    for (const counter_t& counter : health.counters) health_[health.process_name][counter.counter_name] = counter.count;
  });
}

std::size_t Processes::tell(std::string_view channel, const std::vector<std::uint8_t>& bytes) {
  told_ = true;
  const AllocationMeter meter;
  lcm_.publish(channel, bytes, 0);
  while (lcm_.dispatch(kPatience) == 0) {
  }
  dispatch();
  const std::size_t allocated = meter.bytes();
  told_ = false;
  return allocated;
}

bool Processes::dispatch() {
  const std::size_t taken = mapper_bus_.dispatch(kNoWait) + planner_bus_.dispatch(kNoWait);
  return taken > 0;
}

void Processes::turn() {
  mapper_bus_.report(mapper_.counters(), mapper_.summary());
  planner_bus_.report(planner_.counters(), planner_.summary());
  mapper_bus_.turn(kNoWait);
  planner_bus_.turn(kNoWait);
  std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

void Processes::settle() {
  for (int round = 0; round < 3 || mapper_bus_.lacks(channel::kSweep.name); ++round) {
    for (int quiet = 0; quiet < kQuietTurns; ++quiet) {
      turn();
      if (dispatch()) quiet = 0;
    }
    mapper_.settle(mapper_bus_.lacks(channel::kSweep.name));
    const auto state = mapper_.state();
    mapper_bus_.publish(channel::kMapState.name, encode(state), state.utime);
    turn();
    dispatch();
    planner_.settle();
  }
  for (const SteadyTime end = steady_now() + kUntilHealth; steady_now() < end;) turn();
}

}  // namespace scanway::test
