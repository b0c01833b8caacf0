#include "modules/mapper/node/map_commands.h"

#include <algorithm>
#include <utility>

#include "common/messages/bad_message.h"
#include "common/messages/codec.h"

namespace scanway {

void MapCommands::use(std::vector<map_answer_t> answers) {
  std::erase_if(answers, [](const map_answer_t& answer) { return answer.answered.command != map_command_t::WITHDRAW; });
  answers_ = std::move(answers);
}

std::optional<map_command_t> MapCommands::take(const BusMessage& message) {
  auto command = decode<map_command_t>(message.bytes);
  const bool is_known = command.command == map_command_t::WITHDRAW || command.command == map_command_t::SAVE;
  if (!is_known) throw BadMessage("a command that is not known");
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
