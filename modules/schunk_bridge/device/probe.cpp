#include <algorithm>
#include <set>

#include "modules/schunk_bridge/core/powercube.h"
#include "modules/schunk_bridge/core/request.h"
#include "modules/schunk_bridge/device/pan_tilt_driver.h"

namespace scanway::schunk {
namespace {

std::string list(const std::set<int>& modules) {
  std::string text;
  for (const int module : modules) text += (text.empty() ? "" : ", ") + std::to_string(module);
  return text;
}

/// Who else is on the bus: modules of the Motion Protocol by their ids, and older ones.
struct Others {
  std::set<int> motion, powercube;

  void listen(CanLink& link, Utime until) {
    while (PanTiltDriver::now() < until) {
      const auto received = link.receive(10);
      if (!received || !received->frame) continue;
      const CanFrame& frame = *received->frame;
      if (is_motion_protocol(frame.id) && frame.id >> 8 != static_cast<int>(Direction::to_module)) {
        motion.insert(frame.id & 0xFF);
      } else if (powercube::is_answer(frame)) {
        powercube.insert(frame.id & 31);
      }
    }
  }
};

std::vector<std::string> look_for_others(const std::string& bus, const PanTiltConfig& config) {
  const auto link = open_can(bus);
  for (const std::uint8_t module : {config.pan.module, config.tilt.module}) link->send(powercube::ask_position(module));
  // Every id there is, two milliseconds apart: reading a setting disturbs nobody.
  Others others;
  for (int module = 1; module <= 255; ++module) {
    link->send(to_frames(request::get_config(static_cast<std::uint8_t>(module), Setting::unit_system)).front());
    others.listen(*link, PanTiltDriver::now() + 2'000);
  }
  others.listen(*link, PanTiltDriver::now() + 300'000);
  std::vector<std::string> lines;
  if (!others.motion.empty()) lines.push_back("modules of these ids answer: " + list(others.motion));
  if (!others.powercube.empty()) {
    lines.push_back("modules of these ids speak the older PowerCube protocol, which Scanway does not: " +
                    list(others.powercube));
  }
  if (lines.empty()) {
    lines.push_back("no module answers on " + bus +
                    ": check power, wiring, termination and the bit rate (50 to 1000 kbit/s are possible)");
  }
  return lines;
}

}  // namespace

ProbeResult probe(const std::string& bus, const PanTiltConfig& config, Utime time) {
  open_can(bus);  // Or say why not.
  PanTiltDriver driver(bus, config);
  ProbeResult result;
  std::vector<std::string>& lines = result.lines;
  if (is_pretended_can(bus)) lines.push_back(bus + ": not a CAN bus, but a program that pretends one");
  const auto ready = [&] {
    return driver.core().pan().phase() == Axis::Phase::ready && driver.core().tilt().phase() == Axis::Phase::ready;
  };
  for (const Utime end = PanTiltDriver::now() + time; PanTiltDriver::now() < end && !ready();) driver.step(10);
  for (const std::string& trouble : driver.take_troubles()) lines.push_back(trouble);
  for (const Event& event : driver.core().take_events()) lines.push_back(event.text);
  result.works = ready();
  if (!result.works) {
    for (const std::string& line : look_for_others(bus, config)) lines.push_back(line);
  }
  return result;
}

}  // namespace scanway::schunk
