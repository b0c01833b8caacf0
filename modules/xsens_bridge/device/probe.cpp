#include "modules/xsens_bridge/device/probe.h"

#include <chrono>
#include <cstdio>

namespace scanway::xsens {
namespace {

std::string printed(const char* format, double a, double b = 0.0, double c = 0.0, double d = 0.0) {
  char text[128];
  std::snprintf(text, sizeof text, format, a, b, c, d);
  return text;
}

void describe_tracker(const TrackerDevice& device, std::vector<std::string>& lines) {
  const TrackerInfo& info = device.dialogue()->info();
  lines.push_back("answers at " + std::to_string(device.baud()) + " baud");
  if (!info.product_code.empty()) lines.push_back("product: " + info.product_code);
  if (info.device_id) {
    char text[32];
    std::snprintf(text, sizeof text, "device id: %08X", *info.device_id);
    lines.push_back(text);
  }
  if (info.firmware) {
    lines.push_back(
        printed("firmware: %.0f.%.0f.%.0f", info.firmware->major, info.firmware->minor, info.firmware->revision));
  }
  lines.push_back(info.legacy ? "sends MTData (MTi, MTx, MTi-G)" : "sends MTData2");
}

void describe_reading(const TrackerReading& reading, std::vector<std::string>& lines) {
  const auto& q = *reading.q_world_sensor;
  lines.push_back(printed("orientation (w, x, y, z): %.4f %.4f %.4f %.4f", q.w(), q.x(), q.y(), q.z()));
  if (reading.acceleration) {
    const auto& a = *reading.acceleration;
    lines.push_back(printed("acceleration: %.2f %.2f %.2f m/s^2", a.x(), a.y(), a.z()));
  }
  if (!reading.healthy()) lines.push_back("its filter is not valid, or a sensor is at its limit");
}

}  // namespace

ProbeResult probe_tracker(const TrackerAddress& address, const TrackerConfig& config, int timeout_s) {
  ProbeResult result;
  TrackerDevice device(address, config);
  std::size_t orientations = 0;
  std::vector<std::string> found;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(timeout_s);
  bool lost = false;
  while (!lost && orientations < config.rate_hz && std::chrono::steady_clock::now() < end) {
    const TrackerNews news = device.run(20);
    for (const std::string& note : news.notes) result.lines.push_back(note);
    lost = device.dialogue() == nullptr && !news.notes.empty();
    for (const TimedReading& timed : news.readings) {
      if (!timed.reading.q_world_sensor) continue;
      ++orientations;
      found.clear();
      describe_tracker(device, found);
      describe_reading(timed.reading, found);
    }
  }
  result.works = orientations > 0;
  result.lines.insert(result.lines.end(), found.begin(), found.end());
  result.lines.push_back(result.works ? address.port + ": the tracker works"
                                      : address.port + ": no orientation; see docs/devices.md");
  return result;
}

}  // namespace scanway::xsens
