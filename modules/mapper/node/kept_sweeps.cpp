/// The node's work on sweeps that were kept: its own, and those of a map that it continues.
#include <utility>

#include "common/bus/channels.h"
#include "common/bus/log_reader.h"
#include "common/files/input_error.h"
#include "common/messages/bad_message.h"
#include "common/messages/codec.h"
#include "modules/mapper/node/mapper_node.h"

namespace scanway {

void MapperNode::restore(const SweepStore& store) {
  if (const auto earlier = store.earlier()) resume(*earlier);
  for (const std::string& log : store.logs()) work_on_kept(log);
  store_ = &store;
}

void MapperNode::resume(const SweepStore& map) {
  silent_ = true;
  work_on_session(map);
  silent_ = false;
  if (mapper_.map().version() > 0) publisher_.publish_whole(mapper_.map(), map_utime_);
  carry_out_due();
}

void MapperNode::work_on_session(const SweepStore& map) {
  if (const auto earlier = map.earlier()) work_on_session(*earlier);
  for (const std::string& log : map.logs()) work_on_kept(log);
  begin_session();
}

void MapperNode::work_on_kept(const std::string& path) {
  try {
    LogReader log(path);
    while (const auto event = log.next()) {
      const BusMessage message{event->channel, event->bytes, event->utime};
      if (event->channel == channel::kImu.name) take_imu(message);
      if (event->channel == channel::kSweepInputs.name) take_origin(message);
      if (event->channel == channel::kSweep.name) take_piece(message);
      if (event->channel == channel::kMapCommand.name) {
        inputs_.flush();
        take_command(message);
      }
    }
    if (!log.trouble().empty()) store_trouble_ = path + ": " + log.trouble();
  } catch (const InputError& error) {
    store_trouble_ = error.what();
  }
  inputs_.flush();
}

/// Nothing of one session is early or late in another.
void MapperNode::begin_session() {
  finish();
  mapper_.begin_session();
  inputs_ = merge();
  newest_orientation_.reset();
}

/// As keep() wrote it: after the orientation.
void MapperNode::take_origin(const BusMessage& message) {
  try {
    SweepOrigin origin{decode<sweep_inputs_t>(message.bytes), std::nullopt};
    inputs_.flush();
    if (newest_orientation_ && newest_orientation_->utime == origin.inputs.utime) {
      origin.R_world_sweep = newest_orientation_->R_world_sweep;
    }
    expect(std::move(origin));
  } catch (const BadMessage&) {
    ++bad_messages_;
  }
}

void MapperNode::keep(const Object& sweep, const std::optional<Orientation>& orientation) {
  if (store_ == nullptr) return;
  try {
    const auto origin = origins_.find(sweep.digest);
    const auto inputs = origin == origins_.end() ? std::vector<std::uint8_t>() : encode(origin->second.inputs);
    store_->keep(sweep, orientation ? orientation->message : std::vector<std::uint8_t>(), inputs);
    store_trouble_.clear();
  } catch (const InputError& error) {
    store_trouble_ = std::string("sweeps are not kept: ") + error.what();
  }
}

}  // namespace scanway
