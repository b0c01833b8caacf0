#include "modules/sick_bridge/device/lms_device.h"

#include <chrono>

#include "modules/sick_bridge/device/probe.h"
#include "tests/modules/sick_bridge/loopback_server.h"
#include "tests/modules/sick_bridge/scripted_lms.h"

namespace scanway::test {
namespace {

/// Runs both until `done` says so, at most `rounds` times.
template <class Done>
sick::LmsNews run(sick::LmsDevice& device, LoopbackServer& server, const Done& done, int rounds = 4000) {
  sick::LmsNews all;
  for (int i = 0; i < rounds && !done(all); ++i) {
    server.run();
    sick::LmsNews news = device.run(1);
    for (auto& scan : news.scans) all.scans.push_back(std::move(scan));
    for (auto& frame : news.frames) all.frames.push_back(std::move(frame));
    for (auto& note : news.notes) all.notes.push_back(std::move(note));
  }
  return all;
}

TEST(LmsDevice, TheRecordedLms511OverASocket) {
  SKIP_WITHOUT_LMS_DATA();
  ScriptedLms script;
  LoopbackServer server([&](const std::string& bytes) { return script.answer(bytes); });
  sick::LmsDevice device(server.address(), {});
  const auto news = run(device, server, [](const auto& all) { return all.scans.size() >= 5; });
  ASSERT_EQ(news.scans.size(), 5U);
  EXPECT_TRUE(device.measuring());
  EXPECT_EQ(news.scans[0].scan.telegram_counter, 54098);
  // Each was measured some 41 ms before the device sent it, and it was sent before it came.
  const Utime now =
      std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::system_clock::now().time_since_epoch())
          .count();
  for (const auto& timed : news.scans) {
    EXPECT_LT(timed.utime, now - (timed.scan.transmission_time_us - timed.scan.start_time_us) + 1);
    EXPECT_GT(timed.utime, now - 60 * kMicrosecondsPerSecond);
  }
}

TEST(LmsDevice, ComesBackByItselfWhenTheDeviceHangsUp) {
  SKIP_WITHOUT_LMS_DATA();
  ScriptedLms script;
  LoopbackServer server([&](const std::string& bytes) { return script.answer(bytes); });
  sick::LmsDevice device(server.address(), {});
  run(device, server, [](const auto& all) { return !all.scans.empty(); });
  ASSERT_TRUE(device.measuring());
  server.hang_up();
  const auto news = run(device, server, [](const auto& all) { return !all.scans.empty(); });
  EXPECT_EQ(device.connections(), 2);
  EXPECT_FALSE(news.scans.empty());
  ASSERT_FALSE(news.notes.empty());
  EXPECT_NE(news.notes[0].find("the device closed the connection"), std::string::npos);
}

TEST(LmsDevice, AnAbsentDeviceIsOneLineNotOneAnAttempt) {
  LoopbackServer server([](const std::string&) { return std::string(); });
  server.unplug();
  sick::LmsDevice device(server.address(), {});
  std::vector<std::string> notes;
  for (int i = 0; i < 30; ++i) {
    for (const auto& note : device.run(50).notes) notes.push_back(note);
  }
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("Connection refused; is that the port of the device (2112 or 2111)"), std::string::npos);
}

TEST(LmsProbe, SaysWhyThereAreNoScans) {
  LoopbackServer server([](const std::string&) { return std::string(); });
  server.unplug();
  const auto result = sick::probe_lms(server.address(), {}, 5);
  EXPECT_FALSE(result.works);
  EXPECT_EQ(result.lines.size(), 2U);
}

}  // namespace
}  // namespace scanway::test
