#include "modules/base_bridge/device/base_driver.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <thread>
#include <utility>

#include "common/clock/host_time.h"
#include "common/files/input_error.h"

namespace scanway::erratic {
namespace {

constexpr Utime kOpenAgain = 500'000;
constexpr Utime kProbeTime = 6'000'000;
constexpr auto kBetweenPackets = std::chrono::milliseconds(20);

}  // namespace

BaseDriver::BaseDriver(std::string port, const BaseConfig& config) : path_(std::move(port)), core_(config) {}

BaseDriver::~BaseDriver() {
  if (!port_) return;
  try {
    for (const Packet& packet : Base::farewell()) {
      port_->write(packet);
      std::this_thread::sleep_for(kBetweenPackets);
    }
  } catch (const InputError&) {
    // A port that is gone takes no farewell.
  }
}

Utime BaseDriver::now() { return host_now(); }

void BaseDriver::open() {
  if (const Utime since = now() - opened_last_; since >= 0 && since < kOpenAgain) return;
  opened_last_ = now();
  try {
    port_.emplace(path_, core_.baud());
    ++times_opened_;
    core_.port_opened(now());
    if (!told_.empty()) tell(path_ + ": the serial port is there again");
    told_.clear();
  } catch (const InputError& error) {
    tell(error.what());
  }
}

void BaseDriver::step(int timeout_ms) {
  timeout_ms = std::clamp(timeout_ms, 0, 10);
  if (!port_) open();
  if (!port_) {
    std::this_thread::sleep_for(std::chrono::milliseconds(timeout_ms));
    core_.tick(now());
    return;
  }
  try {
    write_all();
    std::array<std::uint8_t, 1024> buffer;
    const std::size_t count = port_->read(buffer, timeout_ms);
    if (count > 0) core_.receive(std::span(buffer).first(count), now());
    core_.tick(now());
    if (core_.baud() != port_->baud()) port_->set_baud(core_.baud());
    write_all();
  } catch (const InputError& error) {
    port_.reset();
    opened_last_ = now();
    tell(error.what());
  }
}

void BaseDriver::write_all() {
  for (Packet packet = core_.next_packet(now()); !packet.empty(); packet = core_.next_packet(now())) {
    port_->write(packet);
  }
}

void BaseDriver::tell(const std::string& line) {
  if (line == told_) return;
  told_ = line;
  troubles_.push_back(line);
}

std::vector<std::string> BaseDriver::take_troubles() { return std::exchange(troubles_, {}); }

ProbeResult probe(const std::string& port) {
  { const SerialPort usable(port, 38400); }
  BaseDriver driver(port, {});
  ProbeResult result;
  std::vector<std::string>& lines = result.lines;
  for (const Utime end = BaseDriver::now() + kProbeTime; BaseDriver::now() < end && !driver.core().ready();) {
    driver.step(10);
  }
  for (const std::string& trouble : driver.take_troubles()) lines.push_back(trouble);
  for (const BaseEvent& event : driver.core().take_events()) lines.push_back(event.text);
  result.works = driver.core().ready();
  if (result.works && driver.core().motors()) {
    const std::string volts = std::to_string(driver.core().motors()->battery_V);
    lines.push_back("it sends its odometry; battery " + volts.substr(0, volts.find('.') + 2) + " V");
  }
  return result;
}

}  // namespace scanway::erratic
