#include "modules/mapper/node/arrival_keeper.h"

#include <spdlog/spdlog.h>

#include <optional>
#include <utility>

#include "bot_core/ins_t.hpp"
#include "common/bus/channels.h"
#include "common/files/input_error.h"
#include "common/messages/codec.h"
#include "common/messages/sweep_message.h"

namespace scanway {

void ArrivalKeeper::take(const BusMessage& message) {
  try {
    if (message.channel == channel::kImu.name) {
      imu_utime_ = decode<bot_core::ins_t>(message.bytes).utime;
      imu_.assign(message.bytes.begin(), message.bytes.end());
    } else if (message.channel == channel::kSweep.name) {
      if (auto sweep = sweeps_.add(decode<piece_t>(message.bytes))) keep(std::move(*sweep));
    }
  } catch (const BadMessage&) {
    // The mapper gets it too, and counts it.
  } catch (const InputError& error) {
    spdlog::warn("a sweep is not kept: {}", error.what());
  }
}

void ArrivalKeeper::keep(Object sweep) {
  sweep.utime = decode<Sweep>(sweep.bytes).utime;
  if (store_.has(sweep)) return;  // With the orientation that it was used with.
  // An orientation after the sweep closes it at once; until then, the newest before it is the one that it will use.
  const bool before = imu_utime_ <= sweep.utime;
  store_.keep(sweep, before ? std::span<const std::uint8_t>(imu_) : std::span<const std::uint8_t>());
}

}  // namespace scanway
