#include "modules/mapper/node/sweep_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "common/bus/channels.h"
#include "common/bus/log_bus.h"
#include "common/bus/log_writer.h"
#include "common/files/product_folder.h"
#include "common/messages/digest.h"

namespace scanway {
namespace {

constexpr const char* kExtension = ".lcmlog";

}  // namespace

SweepStore::SweepStore(std::string folder) : folder_(ProductFolder(std::move(folder)).path()) {}

void SweepStore::keep(const Object& sweep, std::span<const std::uint8_t> imu,
                      std::span<const std::uint8_t> inputs) const {
  LogWriter log(path_of(sweep));
  LogBus bus(log);
  if (!imu.empty()) bus.publish(channel::kImu.name, imu, sweep.utime);
  if (!inputs.empty()) bus.publish(channel::kSweepInputs.name, inputs, sweep.utime);
  publish_object(bus, channel::kSweep, sweep.bytes, sweep.key, sweep.version, sweep.utime);
  log.close();
}

bool SweepStore::has(const Object& sweep) const { return std::filesystem::exists(path_of(sweep)); }

void SweepStore::drop(const Object& sweep) const {
  std::error_code gone_already;
  std::filesystem::remove(path_of(sweep), gone_already);
}

std::vector<std::string> SweepStore::logs() const {
  std::vector<std::string> logs;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    if (entry.path().extension() == kExtension) logs.push_back(entry.path().string());
  }
  std::sort(logs.begin(), logs.end());
  return logs;
}

// So that the order of the names is that of the times.
std::string SweepStore::path_of(const Object& sweep) const {
  return fmt::format("{}/sweep-{:020}-{}{}", folder_, sweep.utime, hex(sweep.digest), kExtension);
}

}  // namespace scanway
