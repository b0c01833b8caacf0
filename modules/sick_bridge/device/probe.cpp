#include "modules/sick_bridge/device/probe.h"

#include <chrono>

#include "modules/sick_bridge/core/names.h"
#include "modules/sick_bridge/core/scan_geometry.h"

namespace scanway::sick {
namespace {

constexpr std::size_t kScansEnough = 10;

std::string decimal(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

void describe_device(const Dialogue& dialogue, std::vector<std::string>& lines) {
  const DeviceInfo& info = dialogue.info();
  if (dialogue.dialect()) lines.push_back(std::string("speaks ") + name_of(*dialogue.dialect()));
  if (!info.model.empty()) lines.push_back("model: " + info.model);
  if (!info.model.empty() && info.model.find("LMS5") == std::string::npos) {
    lines.push_back("this model is no LMS5xx: its scan modes and sector are others");
  }
  if (!info.firmware.empty()) lines.push_back("firmware: " + info.firmware);
  if (!info.location_name.empty()) lines.push_back("name: " + info.location_name);
  if (info.operating_hours) lines.push_back("operating hours: " + decimal(*info.operating_hours, 1));
  if (info.device_state) lines.push_back("state: " + device_state_name(*info.device_state));
  if (info.contamination) lines.push_back("dirt on the window: " + contamination_name(*info.contamination));
}

void describe_scan(const Scan& scan, std::vector<std::string>& lines) {
  if (scan.channels_16_bit.empty()) return;
  const ScanChannel& channel = scan.channels_16_bit.front();
  std::size_t returns = 0;
  for (std::size_t beam = 0; beam < channel.counts.size(); ++beam) returns += range_m(channel, beam) ? 1 : 0;
  lines.push_back("scans: " + decimal(scan.scan_frequency / 100.0, 0) + " Hz, " +
                  std::to_string(channel.counts.size()) + " beams from " + decimal(channel.start_angle / 1e4, 4) +
                  " deg in steps of " + decimal(channel.step / 1e4, 4) + " deg, " + std::to_string(returns) +
                  " with a return, " + std::to_string(scan.channels_16_bit.size()) + " echo(es), " +
                  (scan.channels_8_bit.empty() ? "no RSSI" : "RSSI"));
  if (scan.device_status != 0) lines.push_back("device status: " + device_status_text(scan.device_status));
}

}  // namespace

ProbeResult probe_lms(const LmsAddress& address, const LmsConfig& config, int timeout_s) {
  ProbeResult result;
  LmsDevice device(address, config);
  std::size_t scans = 0;
  std::vector<std::string> found;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(timeout_s);
  bool lost = false;
  while (!lost && scans < kScansEnough && std::chrono::steady_clock::now() < end) {
    const bool talked = device.dialogue() != nullptr;
    const LmsNews news = device.run(50);
    for (const std::string& note : news.notes) result.lines.push_back(note);
    lost = device.dialogue() == nullptr && (talked || !news.notes.empty());
    if (news.scans.empty() || device.dialogue() == nullptr) continue;
    scans += news.scans.size();
    found.clear();
    describe_device(*device.dialogue(), found);
    describe_scan(news.scans.back().scan, found);
  }
  result.works = scans > 0;
  result.lines.insert(result.lines.end(), found.begin(), found.end());
  result.lines.push_back(result.works ? address.host + ": the scanner works"
                                      : address.host + ": no scans; see docs/devices.md");
  return result;
}

}  // namespace scanway::sick
