#include "modules/mapper/node/map_commands.h"

#include <algorithm>

#include "common/messages/bad_message.h"
#include "common/messages/codec.h"

namespace scanway {

std::optional<map_command_t> MapCommands::take(const BusMessage& message) {
  auto command = decode<map_command_t>(message.bytes);
  if (command.command != map_command_t::WITHDRAW) throw BadMessage("a command that is not known");
  const bool answered = std::any_of(answers_.begin(), answers_.end(), [&](const map_answer_t& answer) {
    return name_of(answer.answered) == name_of(command);
  });
  if (answered || !known_.insert(name_of(command)).second) return std::nullopt;
  return command;
}

std::vector<map_command_t> MapCommands::due(std::uint64_t sweep) {
  std::vector<map_command_t> due;
  for (const map_answer_t& answer : answers_) {
    const bool is_next = static_cast<std::uint64_t>(answer.after_sweep_digest) == sweep;
    if (is_next && known_.insert(name_of(answer.answered)).second) due.push_back(answer.answered);
  }
  return due;
}

}  // namespace scanway
