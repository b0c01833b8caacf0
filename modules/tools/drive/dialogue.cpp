#include "modules/tools/drive/dialogue.h"

#include <chrono>
#include <utility>

#include "common/bus/lcm_url.h"
#include "common/files/input_error.h"

namespace scanway::tools {
namespace {

constexpr auto kMoment = std::chrono::milliseconds(20);

}  // namespace

Dialogue::Dialogue(const std::string& url, Partner partner) : bus_(lcm_url(url)), partner_(std::move(partner)) {}

void Dialogue::listen() {
  bus_.dispatch(kMoment);
  if (steady_now() - heard_ <= partner_.longest_silence) return;
  throw InputError("no " + partner_.program + " is heard on this bus: start it, or name its bus by --lcm-url");
}

void Dialogue::say_until(const std::function<bool()>& answered, SteadyTime period, const Channel& channel,
                         const std::vector<std::uint8_t>& message) {
  for (SteadyTime next = 0; !answered(); listen()) {
    if (steady_now() < next) continue;
    bus_.publish(channel.name, message, 0);
    next = steady_now() + period;
  }
}

}  // namespace scanway::tools
