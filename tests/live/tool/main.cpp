/// What the live tests need beside the programs themselves:
///   scanway-live-tool digests LOG                     the products that a log holds
///   scanway-live-tool observe URL VERSION SECONDS     the products on a bus, once that version is complete (else 1);
///                                                     then the last counters of every process, as lines of HEALTH,
///                                                     and all is quiet
///   scanway-live-tool hostile URL                     lies on every channel
///   scanway-live-tool other-version URL               a GOAL of another version of its type
///   scanway-live-tool relay GROUP GROUP LOST TWICE HELD_MS SEED
///                                                     two multicast groups as two machines with a bad network between
///                                                     (relay.h)

#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <thread>

#include "common/bus/channels.h"
#include "common/bus/lcm_bus.h"
#include "common/bus/log_reader.h"
#include "common/delivery/live_bus.h"
#include "common/messages/codec.h"
#include "tests/live/tool/hostile.h"
#include "tests/live/tool/products.h"
#include "tests/live/tool/relay.h"

namespace scanway::test {
namespace {

using Milliseconds = std::chrono::milliseconds;

int digests(const std::string& path) {
  LogReader log(path);
  Products products;
  while (const auto event = log.next()) products.take({event->channel, event->bytes, event->utime});
  std::fputs(products.text().c_str(), stdout);
  return 0;
}

/// What each process has said of itself last.
class Healths {
 public:
  void take(const health_t& health) {
    Process& process = processes_[health.process_name];
    process.summary = health.summary;
    for (const counter_t& counter : health.counters) {
      std::int64_t& known = process.counters[counter.counter_name];
      if (known != counter.count && moves(counter.counter_name)) changed_ = steady_now();
      known = counter.count;
    }
  }
  /// Whether no object has moved for a while, and none is about to.
  bool quiet() const { return steady_now() - changed_ > kQuiet; }
  void print() const {
    for (const auto& [name, process] : processes_) {
      for (const auto& [counter, count] : process.counters) {
        std::printf("HEALTH %s %s %lld\n", name.c_str(), counter.c_str(), static_cast<long long>(count));
      }
      std::printf("SUMMARY %s %s\n", name.c_str(), process.summary.c_str());
    }
  }

 private:
  static constexpr SteadyTime kQuiet = 4'000'000;
  struct Process {
    std::map<std::string, std::int64_t> counters;
    std::string summary;
  };

  static bool moves(const std::string& counter) {
    return counter.starts_with("pieces_") || counter.starts_with("requests_") || counter == "lacking";
  }

  std::map<std::string, Process> processes_;
  SteadyTime changed_ = steady_now();
};

/// At once, for scripts that wait for it.
void say_when(const char* what) {
  std::printf("SECONDS since 1970 when the cost map %s: %.3f\n", what, to_seconds(wall_clock()));
  std::fflush(stdout);
}

int observe(const std::string& url, std::int64_t version, double seconds) {
  LcmBus lcm(url);
  LiveBus bus(lcm, this_process("observer"));
  Products products;
  Healths healths;
  products.listen(bus);
  bus.subscribe(channel::kHealth.name,
                [&](const BusMessage& message) { healths.take(decode<health_t>(message.bytes)); });
  bus.start();
  const SteadyTime end = steady_now() + static_cast<SteadyTime>(seconds * 1e6);
  const auto wait = [&](const std::function<bool()>& ready) {
    while (!ready() && steady_now() < end) bus.dispatch(Milliseconds(50));
    return ready();
  };
  wait([&] { return products.begun(version); });
  say_when("began");
  const SteadyTime begun = steady_now();
  wait([&] { return products.cost_map_complete(version); });
  const SteadyTime equal = steady_now();
  say_when("whole");
  const bool complete = wait([&] { return products.complete(version); });
  std::printf("SECONDS from the first tile of the version to the whole cost map: %.2f\n", to_seconds(equal - begun));
  // What is still on its way, and everybody's last word; somebody may ask for a minute for what nobody has.
  const SteadyTime patience = steady_now() + 8'000'000;
  wait([&] { return healths.quiet() || steady_now() > patience; });
  std::fputs(products.text().c_str(), stdout);
  healths.print();
  return complete ? 0 : 1;
}

int hostile(const std::string& url) {
  LcmBus bus(url);
  send_hostile(bus);
  return 0;
}

int other_version(const std::string& url) {
  LcmBus bus(url);
  const std::vector<std::uint8_t> goal_of_tomorrow(40, 0x5A);
  bus.publish(channel::kGoal.name, goal_of_tomorrow, 0);
  return 0;
}

}  // namespace
}  // namespace scanway::test

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  try {
    if (words.size() == 2 && words[0] == "digests") return scanway::test::digests(words[1]);
    if (words.size() == 4 && words[0] == "observe") {
      return scanway::test::observe(words[1], std::stoll(words[2]), std::stod(words[3]));
    }
    if (words.size() == 2 && words[0] == "hostile") return scanway::test::hostile(words[1]);
    if (words.size() == 7 && words[0] == "relay") {
      return scanway::test::relay(
          words[1], words[2], {std::stoull(words[6]), std::stod(words[3]), std::stod(words[4]), std::stod(words[5])});
    }
    if (words.size() == 2 && words[0] == "other-version") return scanway::test::other_version(words[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "scanway-live-tool: %s\n", error.what());
  }
  return 2;
}
