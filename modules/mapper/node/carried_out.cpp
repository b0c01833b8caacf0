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

/// Its products carry the time of the newest sweep, as do those that they follow: the command's is of another clock.
void MapperNode::carry_out(const map_command_t& command) {
  const Withdrawal withdrawal = mapper_.withdraw(command.sweep_name, stages_);
  if (withdrawal.done) keep(command);
  if (silent_) return;
  map_answer_t answer{};
  answer.answered = command;
  answer.after_sweep_digest = static_cast<std::int64_t>(last_sweep_);
  answer.map_version = static_cast<std::int64_t>(withdrawal.change.version);
  answer.done = withdrawal.done ? 1 : 0;
  answer.reason = withdrawal.reason;
  if (withdrawal.done) publisher_.publish(mapper_.map(), withdrawal.change, map_utime_);
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
