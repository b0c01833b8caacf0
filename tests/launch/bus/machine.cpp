#include "tests/launch/bus/machine.h"

#include <gtest/gtest.h>

#include "bot_core/ins_t.hpp"
#include "common/bus/log_writer.h"
#include "common/cloud/read_cloud.h"
#include "common/cloud/write_cloud.h"
#include "common/messages/codec.h"
#include "scanway/goal_t.hpp"
#include "scanway/health_t.hpp"

namespace scanway::test {
namespace {

constexpr Utime kBegin = 1'700'000'000'000'000;
constexpr std::size_t kEveryPoint = 16;

}  // namespace

bool namespaces_permitted() { return run_command({"unshare", "--net", "--mount", "true"}).status == 0; }

CommandResult Machine::run(const std::string& script) const {
  const std::string head = "cd '" + folder_.path() + "'\n" +
                           "ip link set lo up && ip route add 224.0.0.0/4 dev lo || exit 99\n" +
                           "LAUNCH='" SCANWAY_SOURCE_DIR "/launch' SCANWAY='" SCANWAY_BIN_DIR "/scanway'\n" +
                           "export SCANWAY_BUILD='" SCANWAY_BIN_DIR "/..'\n" + "unset LCM_DEFAULT_URL\n";
  return run_command(
      {"unshare", "--net", "--mount", "--pid", "--fork", "--kill-child", "--mount-proc", "bash", "-c", head + script});
}

nlohmann::json Machine::info(const std::string& log) const {
  const CommandResult told = run_command({SCANWAY_BIN_DIR "/scanway", "info", path(log), "--json"});
  EXPECT_EQ(told.status, 0) << log << ": " << told.err;
  return nlohmann::json::parse(told.out, nullptr, false);
}

nlohmann::json channel_of(const nlohmann::json& document, const std::string& channel) {
  for (const nlohmann::json& entry : document["channels"]) {
    if (entry["channel"] == channel) return entry;
  }
  return nullptr;
}

StreamLog::StreamLog(const std::string& path, int seconds) {
  LogWriter log(path);
  for (int i = 0; i < seconds * 50; ++i) {
    const Utime utime = kBegin + i * 20'000;
    bot_core::ins_t imu{};
    imu.utime = utime;
    imu.device_time = i;
    imu.accel[2] = 9.81;
    if (i % 40 == 30) {
      ++left_out;
    } else {
      log.write("IMU", encode(imu), utime);
      ++imus;
    }
    health_t health{};
    health.utime = utime;
    health.process_name = "tracker";
    if (i % 50 == 0) log.write("HEALTH", encode(health), utime);
    auto goal = encode(goal_t{});
    goal.pop_back();
    if (i == seconds * 25) log.write("GOAL", goal, utime);
  }
  log.close();
}

void write_sweep_log(const std::string& folder, const std::string& log) {
  const PointCloud whole = read_cloud(SCANWAY_SOURCE_DIR "/logs/halls/scan000.pcd");
  PointCloud thin;
  for (std::size_t i = 0; i < whole.size(); i += kEveryPoint) thin.points.push_back(whole.points[i]);
  write_pcd(folder + "/scan000.pcd", thin);
  const CommandResult made =
      run_command({SCANWAY_BIN_DIR "/scanway", "import", "clouds", folder + "/scan000.pcd", "--poses",
                   SCANWAY_SOURCE_DIR "/logs/halls/poses_reference.txt", "--goal", "2,0", "-o", log});
  EXPECT_EQ(made.status, 0) << made.err;
}

}  // namespace scanway::test
