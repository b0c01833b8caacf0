// MapperNode: commands to the map.
#include "common/bus/channels.h"
#include "common/files/input_error.h"
#include "common/messages/bad_message.h"
#include "common/messages/codec.h"
#include "modules/mapper/node/mapper_node.h"

namespace scanway {

void MapperNode::take_command(const BusMessage& message) {
  try {
    ++news_;
    if (const auto command = commands_.take(message)) carry_out(*command);
  } catch (const BadMessage&) {
    ++bad_messages_;
  }
}

void MapperNode::carry_out_due() {
  for (const map_command_t& command : commands_.due(last_sweep_)) carry_out(command);
}

void MapperNode::carry_out(const map_command_t& command) {
  if (command.command == map_command_t::WITHDRAW) withdraw(command);
  if (command.command == map_command_t::SAVE && save_) save(command);
}

/// Its products carry the time of the newest sweep, as do those that they follow: the command's is of another clock.
void MapperNode::withdraw(const map_command_t& command) {
  const Withdrawal withdrawal = mapper_.withdraw(command.sweep_name, stages_);
  if (withdrawal.done) keep(command);
  if (silent_) return;
  if (withdrawal.done) publisher_.publish(mapper_.map(), withdrawal.change, map_utime_);
  answer(command, withdrawal.change.version, withdrawal.done ? "" : withdrawal.reason);
}

void MapperNode::save(const map_command_t& command) {
  std::string refusal;
  try {
    save_(command.sweep_name);
  } catch (const InputError& error) {
    refusal = error.what();
  }
  answer(command, mapper_.map().version(), refusal);
}

void MapperNode::answer(const map_command_t& command, std::uint64_t version, const std::string& refusal) {
  map_answer_t answer{};
  answer.answered = command;
  answer.after_sweep_digest = static_cast<std::int64_t>(last_sweep_);
  answer.map_version = static_cast<std::int64_t>(version);
  answer.done = refusal.empty() ? 1 : 0;
  answer.reason = refusal;
  bus_.publish(channel::kMapAnswer.name, encode(answer), map_utime_);
}

void MapperNode::keep(const map_command_t& command) {
  if (store_ == nullptr) return;
  try {
    store_->keep(command, map_utime_);
  } catch (const InputError& error) {
    store_trouble_ = std::string("a withdrawal is not kept: ") + error.what();
  }
}

}  // namespace scanway
