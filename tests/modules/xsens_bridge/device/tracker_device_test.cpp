#include "modules/xsens_bridge/device/tracker_device.h"

#include <unistd.h>

#include <chrono>
#include <optional>

#include "modules/xsens_bridge/device/probe.h"
#include "tests/modules/xsens_bridge/terminal_tracker.h"

namespace scanway::test {
namespace {

template <class Done>
xsens::TrackerNews run(xsens::TrackerDevice& device, TerminalTracker& tracker, const Done& done) {
  xsens::TrackerNews all;
  for (int i = 0; i < 3000 && !done(all); ++i) {
    tracker.run();
    auto news = device.run(1);
    for (auto& reading : news.readings) all.readings.push_back(reading);
    for (auto& note : news.notes) all.notes.push_back(note);
  }
  return all;
}

TEST(TrackerDevice, MeasuresOverATerminal) {
  for (const bool legacy : {false, true}) {
    TerminalTracker tracker(legacy);
    xsens::TrackerDevice device({tracker.path(), 0}, {});
    const auto news = run(device, tracker, [](const auto& all) { return all.readings.size() >= 50; });
    for (const auto& note : news.notes) ADD_FAILURE() << note;
    ASSERT_GE(news.readings.size(), 50U) << (device.dialogue() ? device.dialogue()->failure() : "closed");
    EXPECT_TRUE(device.measuring());
    EXPECT_EQ(device.baud(), 115200);
    EXPECT_EQ(device.dialogue()->info().legacy, legacy);
    // The new one's measurements hold its orientation; the old one's are zeros, which are no rotation.
    EXPECT_EQ(news.readings.back().reading.q_world_sensor.has_value(), !legacy);
    const Utime now =
        std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::system_clock::now().time_since_epoch())
            .count();
    EXPECT_LE(news.readings.back().utime, now);
  }
}

TEST(TrackerDevice, ComesBackAfterAReboot) {
  TerminalTracker tracker(false);
  xsens::TrackerDevice device({tracker.path(), 115200}, {});
  run(device, tracker, [](const auto& all) { return !all.readings.empty(); });
  tracker.put(tracker.tracker().reboot());
  run(device, tracker, [&](const auto&) { return device.counters().wake_ups == 1; });
  const auto news = run(device, tracker, [](const auto& all) { return !all.readings.empty(); });
  EXPECT_FALSE(news.readings.empty());
  EXPECT_EQ(device.openings(), 1);
}

TEST(TrackerDevice, ComesBackAfterItWasUnplugged) {
  auto tracker = std::make_optional<TerminalTracker>(false);
  const std::string link = testing::TempDir() + "scanway_tracker_" + std::to_string(getpid());
  ASSERT_EQ(symlink(tracker->path().c_str(), link.c_str()), 0);
  xsens::TrackerDevice device({link, 115200}, {});
  run(device, *tracker, [](const auto& all) { return !all.readings.empty(); });
  ASSERT_TRUE(device.measuring());
  tracker.reset();
  unlink(link.c_str());
  std::vector<std::string> notes;
  for (int i = 0; i < 100 && notes.size() < 2; ++i) {
    for (const auto& note : device.run(10).notes) notes.push_back(note);
  }
  ASSERT_FALSE(notes.empty());
  EXPECT_NE(notes[0].find(link), std::string::npos);
  tracker.emplace(false);
  ASSERT_EQ(symlink(tracker->path().c_str(), link.c_str()), 0);
  const auto news = run(device, *tracker, [](const auto& all) { return !all.readings.empty(); });
  EXPECT_FALSE(news.readings.empty());
  unlink(link.c_str());
}

TEST(TrackerProbe, SaysThatThereIsNoPort) {
  const auto result = xsens::probe_tracker({"/dev/no-such-port", 0}, {}, 3);
  EXPECT_FALSE(result.works);
  ASSERT_EQ(result.lines.size(), 2U);
  EXPECT_NE(result.lines[0].find("/dev/no-such-port"), std::string::npos);
}

}  // namespace
}  // namespace scanway::test
