#include "modules/schunk_bridge/device/pan_tilt_driver.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "common/clock/host_time.h"
#include "common/files/input_error.h"
#include "modules/schunk_bridge/core/candump.h"
#include "modules/schunk_bridge/core/message.h"

namespace scanway::schunk {
namespace {

constexpr Utime kOpenAgain = 500'000;
constexpr Utime kAMoment = 10'000'000;
constexpr Utime kFullTooLong = 500'000;
constexpr int kMostFramesATurn = 256;

std::vector<std::uint16_t> ids_of(const PanTiltConfig& config) {
  std::vector<std::uint16_t> ids;
  for (const std::uint8_t module : {config.pan.module, config.tilt.module}) {
    ids.push_back(can_id(Direction::from_module, module));
    ids.push_back(can_id(Direction::error, module));
  }
  return ids;
}

}  // namespace

PanTiltDriver::PanTiltDriver(std::string bus, const PanTiltConfig& config)
    : bus_(std::move(bus)), ids_(ids_of(config)), core_(config) {}

Utime PanTiltDriver::now() { return host_now(); }

void PanTiltDriver::step(int timeout_ms) {
  timeout_ms = std::clamp(timeout_ms, 0, 10);
  if (!link_) open();
  try {
    send_all();
    // Frames are a millisecond apart: another one may be waiting for its turn.
    receive_all(sent_ ? std::min(timeout_ms, 1) : timeout_ms);
    core_.tick(now());
    send_all();
  } catch (const InputError& error) {
    disconnect(error.what());
  }
}

void PanTiltDriver::open() {
  if (const Utime since = now() - opened_last_; since >= 0 && since < kOpenAgain) return;
  opened_last_ = now();
  try {
    link_ = open_can(bus_, ids_);
    ++counters_.times_opened;
    if (!told_.empty()) tell(bus_ + ": the CAN bus is there again");
    told_.clear();
  } catch (const InputError& error) {
    tell(error.what());
  }
}

void PanTiltDriver::send_all() {
  sent_ = false;
  for (;;) {
    if (!unsent_) unsent_ = core_.next_frame(now());
    if (!unsent_) return;
    if (link_ && !link_->send(*unsent_)) {
      ++counters_.times_full;
      if (full_since_ == 0) full_since_ = now();
      if (now() - full_since_ > kFullTooLong) {
        tell(bus_ +
             ": nobody takes frames off the CAN bus: check wiring, termination, bit rate and the modules' power");
      }
      return;
    }
    full_since_ = 0;
    unsent_.reset();
    sent_ = true;
  }
}

void PanTiltDriver::receive_all(int timeout_ms) {
  if (!link_) return std::this_thread::sleep_for(std::chrono::milliseconds(timeout_ms));
  for (int i = 0; i < kMostFramesATurn; ++i) {
    const auto received = link_->receive(i == 0 ? timeout_ms : 0);
    if (!received) return;
    if (received->lost_before) {
      ++counters_.losses;
      core_.frames_lost();
    }
    if (received->error != 0) {
      ++counters_.error_frames;
      tell(bus_ + ": the CAN bus reports " + describe_error_frame(received->error) +
           ": check wiring, termination and that the bit rate is the modules'");
    }
    if (received->frame) core_.receive(*received->frame, received->utime != 0 ? received->utime : now());
  }
}

void PanTiltDriver::disconnect(const std::string& why) {
  link_.reset();
  unsent_.reset();
  full_since_ = 0;
  opened_last_ = now();
  tell(why);
}

void PanTiltDriver::tell(const std::string& line) {
  told_at_ = now();
  if (line == told_) return;
  told_ = line;
  troubles_.push_back(line);
}

std::string PanTiltDriver::trouble() const {
  return link_ == nullptr || now() - told_at_ < kAMoment ? told_ : std::string();
}

std::vector<std::string> PanTiltDriver::take_troubles() { return std::exchange(troubles_, {}); }

}  // namespace scanway::schunk
