#include "modules/tools/drive/mapper_order.h"

#include <cstdio>
#include <optional>

#include <fmt/format.h>

#include "common/clock/host_time.h"
#include "common/files/printable.h"
#include "modules/tools/drive/dialogue.h"
#include "scanway/map_state_t.hpp"

namespace scanway::tools {
namespace {

constexpr int kRefused = 1;
constexpr SteadyTime kSayAgain = 500'000;
/// The mapper says its state once a second, except while it works on a sweep.
constexpr SteadyTime kLongestSilence = 60'000'000;

map_answer_t answer_to(std::int8_t what, const MapperOrder& order) {
  map_command_t command{};
  command.utime = host_now();
  command.command = what;
  command.sweep_name = order.name;
  Dialogue talk(order.lcm_url, {"scanway-mapper", kLongestSilence});
  std::optional<map_answer_t> answer;
  talk.hear<map_answer_t>(channel::kMapAnswer, [&](const map_answer_t& said) {
    if (said.answered.utime == command.utime) answer = said;
  });
  talk.hear<map_state_t>(channel::kMapState, [&talk](const map_state_t&) { talk.note_partner(); });
  talk.say_until([&] { return answer.has_value(); }, kSayAgain, channel::kMapCommand, encode(command));
  return *answer;
}

int say(const map_answer_t& answer, const std::string& done, const std::string& refused) {
  const std::string name = printable(answer.answered.sweep_name);
  std::puts(answer.done != 0 ? fmt::format("{} {}: map version {}", name, done, answer.map_version).c_str()
                             : fmt::format("{} {}: {}", name, refused, printable(answer.reason)).c_str());
  return answer.done != 0 ? 0 : kRefused;
}

}  // namespace

int run_withdraw(const MapperOrder& order) {
  return say(answer_to(map_command_t::WITHDRAW, order), "is withdrawn", "stays");
}

int run_keep_map(const MapperOrder& order) {
  return say(answer_to(map_command_t::SAVE, order), "is saved", "is not saved");
}

}  // namespace scanway::tools
