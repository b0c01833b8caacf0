// The types for Java and Python: all of them are there, and a Python program reads our logs with them.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <sstream>

#include <nlohmann/json.hpp>

#include "bot_core/ins_t.hpp"
#include "common/bus/log_writer.h"
#include "common/messages/codec.h"
#include "scanway/health_t.hpp"
#include "scanway/path_t.hpp"
#include "tests/support/command.h"

namespace scanway::test {
namespace {

using nlohmann::json;

TEST(Jar, HoldsEveryType) {
  const std::string jar = LCMTYPES_DIR "/lcmtypes.jar";
  if (!std::filesystem::exists(jar)) GTEST_SKIP() << "no jar: there was no Java when this was built";
  const auto listing = run_command(
      {"python3", "-c", "import sys, zipfile; print('\\n'.join(zipfile.ZipFile(sys.argv[1]).namelist()))", jar});
  ASSERT_EQ(listing.status, 0) << listing.err;
  std::set<std::string> classes;
  std::istringstream lines(listing.out);
  for (std::string line; std::getline(lines, line);) classes.insert(line);
  for (const Layout& layout : layouts()) {
    std::string name = layout.name;
    name[name.find('.')] = '/';
    EXPECT_TRUE(classes.contains(name + ".class")) << layout.name;
  }
}

// Reads an LCM log with nothing but Python's library and our modules.
constexpr const char* kReader = R"(
import importlib, json, struct, sys
sys.path.insert(0, sys.argv[1])
channels = {'IMU': 'bot_core.ins_t', 'HEALTH': 'scanway.health_t', 'PLAN': 'scanway.path_t'}

def plain(value):
    if isinstance(value, bytes): return list(value)
    if isinstance(value, (list, tuple)): return [plain(element) for element in value]
    if hasattr(value, '__slots__'): return {name: plain(getattr(value, name)) for name in value.__slots__}
    return value

with open(sys.argv[2], 'rb') as log:
    while header := log.read(28):
        sync, number, utime, channel_length, length = struct.unpack('>IqqII', header)
        channel = log.read(channel_length).decode()
        package, name = channels[channel].split('.')
        decoder = getattr(importlib.import_module(package), name)
        print(json.dumps({'channel': channel, 'utime': utime, 'message': plain(decoder.decode(log.read(length)))}))
)";

TEST(Python, ReadsOurLogs) {
  if (run_command({"python3", "-c", ""}).status != 0) GTEST_SKIP() << "no python3";
  const ScratchFolder scratch;
  bot_core::ins_t imu{};
  imu.utime = 1'700'000'000'000'001;
  imu.quat[0] = 0.1;
  health_t health{};
  health.host_name =
      "r\xC3\xB6"
      "bot";
  health.ncounters = 2;
  health.counters.resize(2);
  health.counters[1].counter_name = "gaps";
  health.counters[1].count = -5;
  path_t path{};
  path.provisional = 1;
  path.nposes = 2;
  path.pose_x_m = {1.5, -2.25};
  path.pose_y_m = {0.0, 1e-300};
  path.pose_heading_rad = {3.0, 4.0};
  path.pose_time_s = {0.0, 2.5};
  path.pose_speed_m_s = {0.0, -0.5};
  LogWriter log(scratch / "log");
  log.write("IMU", encode(imu), 1);
  log.write("HEALTH", encode(health), 2);
  log.write("PLAN", encode(path), 3);
  log.close();
  write_text(scratch / "read.py", kReader);
  const auto read = run_command({"python3", scratch / "read.py", LCMTYPES_DIR "/python", scratch / "log"});
  ASSERT_EQ(read.status, 0) << read.err;
  std::istringstream lines(read.out);
  std::vector<json> messages;
  for (std::string line; std::getline(lines, line);) messages.push_back(json::parse(line)["message"]);
  ASSERT_EQ(messages.size(), 3U);
  EXPECT_EQ(messages[0]["utime"], 1'700'000'000'000'001);
  EXPECT_EQ(messages[0]["quat"], (json{0.1, 0.0, 0.0, 0.0}));
  EXPECT_EQ(messages[1]["host_name"],
            "r\xC3\xB6"
            "bot");
  EXPECT_EQ(messages[1]["counters"][1], (json{{"counter_name", "gaps"}, {"count", -5}}));
  EXPECT_EQ(messages[2]["provisional"], true);
  EXPECT_EQ(messages[2]["pose_x_m"], (json{1.5, -2.25}));
  EXPECT_EQ(messages[2]["pose_y_m"], (json{0.0, 1e-300}));
}

}  // namespace
}  // namespace scanway::test
