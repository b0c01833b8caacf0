#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "common/bus/log_reader.h"
#include "common/bus/log_writer.h"
#include "common/random/random.h"
#include "tests/support/command.h"

namespace scanway {
namespace {

using Messages = std::vector<std::pair<std::string, std::string>>;  // Channel and bytes, in order.

Messages messages_of(const std::string& path) {
  LogReader log(path);
  Messages messages;
  while (const auto event = log.next()) {
    messages.emplace_back(event->channel, std::string(event->bytes.begin(), event->bytes.end()));
  }
  EXPECT_EQ(log.trouble(), "");
  return messages;
}

// LCM's own player, into LCM's own log provider: no packet is sent.
void play(const std::string& log, const std::string& copy) {
  const auto played = test::run_command({"lcm-logplayer", "-s", "0", "-l", "file://" + copy + "?mode=w", log});
  ASSERT_EQ(played.status, 0) << played.err;
}

TEST(Logplayer, PlaysWhatWeWrite) {
  const test::ScratchFolder scratch;
  Random random(1);
  Messages written;
  {
    LogWriter log(scratch / "ours.lcmlog");
    Utime utime = 1'700'000'000'000'000;
    for (int i = 0; i < 2000; ++i) {
      std::vector<std::uint8_t> bytes(random.below(1301));
      for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random.next());
      const std::string channel = "CHANNEL_" + std::to_string(random.below(5));
      log.write(channel, bytes, utime);
      written.emplace_back(channel, std::string(bytes.begin(), bytes.end()));
      utime += static_cast<Utime>(random.below(20'000));
    }
    log.close();
  }
  play(scratch / "ours.lcmlog", scratch / "copy.lcmlog");
  EXPECT_EQ(messages_of(scratch / "copy.lcmlog"), written);
}

TEST(Logplayer, AgreesOnARecordedLog) {
  const std::string recorded = SCANWAY_SHARED_DIR "/data/lcm_logs/maebot_convex.lcmlog";
  if (!std::filesystem::exists(recorded)) GTEST_SKIP() << recorded << " is not here";
  const test::ScratchFolder scratch;
  play(recorded, scratch / "copy.lcmlog");
  EXPECT_EQ(messages_of(scratch / "copy.lcmlog"), messages_of(recorded));
}

}  // namespace
}  // namespace scanway
