#include "modules/tools/drive/withdraw.h"

#include <chrono>
#include <cstdio>
#include <optional>

#include <fmt/format.h>

#include "common/bus/channels.h"
#include "common/bus/lcm_bus.h"
#include "common/bus/lcm_url.h"
#include "common/clock/host_time.h"
#include "common/clock/steady_time.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "common/messages/bad_message.h"
#include "common/messages/codec.h"
#include "scanway/map_answer_t.hpp"
#include "scanway/map_state_t.hpp"

namespace scanway::tools {
namespace {

constexpr int kRefused = 1;
constexpr SteadyTime kSayAgain = 500'000;
/// The mapper says its state once a second, except while it works on a sweep.
constexpr SteadyTime kPatience = 60'000'000;
constexpr auto kWait = std::chrono::milliseconds(20);

/// What the mapper says of one command.
class Mapper {
 public:
  Mapper(LcmBus& bus, Utime asked) : bus_(bus) {
    bus.subscribe(channel::kMapAnswer.name, [this, asked](const BusMessage& message) {
      try {
        const auto answer = decode<map_answer_t>(message.bytes);
        if (answer.answered.utime == asked) answer_ = answer;
      } catch (const BadMessage&) {
        // Of another version, or no message at all: as if it had not come.
      }
    });
    bus.subscribe(channel::kMapState.name, [this](const BusMessage&) { heard_ = steady_now(); });
  }

  const std::optional<map_answer_t>& answer() const { return answer_; }
  void listen() {
    bus_.dispatch(kWait);
    if (steady_now() - heard_ <= kPatience) return;
    throw InputError("no scanway-mapper is heard on this bus: start it, or name its bus by --lcm-url");
  }

 private:
  LcmBus& bus_;
  std::optional<map_answer_t> answer_;
  SteadyTime heard_ = steady_now();
};

}  // namespace

int run_withdraw(const WithdrawOptions& options) {
  map_command_t command{};
  command.utime = host_now();
  command.command = map_command_t::WITHDRAW;
  command.sweep_name = options.sweep;
  LcmBus bus(lcm_url(options.lcm_url));
  Mapper mapper(bus, command.utime);
  for (SteadyTime again = 0; !mapper.answer(); mapper.listen()) {
    if (steady_now() < again) continue;
    bus.publish(channel::kMapCommand.name, encode(command), 0);
    again = steady_now() + kSayAgain;
  }
  const map_answer_t& answer = *mapper.answer();
  const std::string sweep = printable(options.sweep);
  if (answer.done == 0) {
    std::puts(fmt::format("{} stays: {}", sweep, printable(answer.reason)).c_str());
    return kRefused;
  }
  std::puts(fmt::format("{} is withdrawn: map version {}", sweep, answer.map_version).c_str());
  return 0;
}

}  // namespace scanway::tools
