#pragma once

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "common/can/can_link.h"
#include "common/clock/host_time.h"
#include "common/files/input_error.h"
#include "tests/modules/schunk_bridge/support/test_module.h"

namespace scanway::test {

/// Whether that CAN bus can be used.
inline bool is_there(const std::string& bus) {
  try {
    open_can(bus);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

/// Two modules that live on a CAN bus, real or pretended, in a thread of their own, and come back when it does.
class Responder {
 public:
  explicit Responder(std::string bus) : bus_(std::move(bus)), thread_([this] { live(); }) {}
  ~Responder() {
    end_ = true;
    thread_.join();
  }
  Responder(const Responder&) = delete;
  Responder& operator=(const Responder&) = delete;

  /// Looks at or changes the modules between two of their steps.
  template <class Touch>
  auto with(const Touch& touch) {
    const std::lock_guard lock(mutex_);
    return touch(pan_, tilt_);
  }
  /// When the kernel got the frames with these bytes.
  std::vector<Utime> times_of(std::uint16_t id, const std::vector<std::uint8_t>& bytes) {
    const std::lock_guard lock(mutex_);
    std::vector<Utime> times;
    for (const auto& [utime, frame] : heard_) {
      if (frame.id == id && frame.bytes == bytes) times.push_back(utime);
    }
    return times;
  }

 private:
  void live() {
    while (!end_) {
      try {
        if (!link_) link_ = serve_can(bus_);
        step();
      } catch (const InputError&) {
        link_.reset();
        usleep(10'000);
      }
    }
  }
  void step() {
    const auto received = link_->receive(1);
    const std::lock_guard lock(mutex_);
    TestFrame frame;
    if (received && received->frame) {
      frame = {received->frame->id, {received->frame->bytes().begin(), received->frame->bytes().end()}};
      heard_.emplace_back(received->utime, frame);
    }
    for (TestModule* module : {&pan_, &tilt_}) {
      if (!frame.bytes.empty()) answer(module->handle(frame, host_now()));
      answer(module->run(host_now()));
    }
  }
  void answer(const std::vector<TestFrame>& frames) {
    for (const TestFrame& said : frames) {
      CanFrame frame;
      frame.id = said.id;
      frame.size = static_cast<std::uint8_t>(said.bytes.size());
      std::copy(said.bytes.begin(), said.bytes.end(), frame.data.begin());
      while (!link_->send(frame)) usleep(200);
    }
  }

  std::string bus_;
  std::unique_ptr<CanLink> link_;
  std::mutex mutex_;
  TestModule pan_{11, TestModule::kDegrees, true}, tilt_{12, TestModule::kDegrees, true};
  std::vector<std::pair<Utime, TestFrame>> heard_;
  std::atomic<bool> end_{false};
  std::thread thread_;
};

}  // namespace scanway::test
