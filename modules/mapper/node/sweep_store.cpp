#include "modules/mapper/node/sweep_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "common/bus/channels.h"
#include "common/bus/log_bus.h"
#include "common/bus/log_writer.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "common/files/product_folder.h"
#include "common/files/saved_folder.h"
#include "common/messages/codec.h"
#include "common/messages/digest.h"

namespace scanway {
namespace {

constexpr const char* kExtension = ".lcmlog";
constexpr const char* kEarlier = "/earlier";

/// Files that are whole never change, so that one on the disk serves both folders where the disk can.
void link_or_copy(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::error_code no_link;
  std::filesystem::create_hard_link(from, to, no_link);
  if (no_link) std::filesystem::copy_file(from, to);
}

void copy_map(const SweepStore& from, const std::filesystem::path& to) {
  std::filesystem::create_directories(to);
  for (const std::string& log : from.logs()) link_or_copy(log, to / std::filesystem::path(log).filename());
  if (const auto earlier = from.earlier()) copy_map(*earlier, to.string() + kEarlier);
}

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

// Its name comes after those of the sweeps of that time, which go on in hexadecimal.
void SweepStore::keep(const map_command_t& command, Utime after) const {
  LogWriter log(fmt::format("{}/sweep-{:020}-withdrawal-{:020}{}", folder_, after, command.utime, kExtension));
  LogBus bus(log);
  bus.publish(channel::kMapCommand.name, encode(command), after);
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

std::optional<SweepStore> SweepStore::earlier() const {
  if (!std::filesystem::is_directory(folder_ + kEarlier)) return std::nullopt;
  return SweepStore(folder_ + kEarlier);
}

void SweepStore::continue_from(const std::string& folder) const {
  if (earlier()) return;
  const std::string half = folder_ + kEarlier + std::string(".half");
  try {
    std::filesystem::remove_all(half);
    copy_map(saved_map(folder), half);
    std::filesystem::rename(half, folder_ + kEarlier);
  } catch (const std::filesystem::filesystem_error& error) {
    throw InputError(fmt::format("{}: cannot take over the map of {}: {}", printable(folder_), printable(folder),
                                 error.code().message()));
  }
}

void SweepStore::take_over(const SweepStore& map) const {
  try {
    copy_map(map, folder_);
  } catch (const std::filesystem::filesystem_error& error) {
    throw InputError(fmt::format("{}: cannot take over the sweeps of {}: {}", printable(folder_),
                                 printable(map.folder_), error.code().message()));
  }
}

SweepStore saved_map(const std::string& folder) {
  if (SavedFolder::is_one(folder)) return saved_map(SavedFolder(folder).path_of("sweeps"));
  if (std::filesystem::is_directory(folder)) {
    SweepStore store(folder);
    if (!store.logs().empty() || store.earlier()) return store;
  }
  throw InputError(printable(folder) +
                   ": holds no sweeps of a map; name what scanway-mapper --state or scanway replay --keep has kept");
}

// So that the order of the names is that of the times.
std::string SweepStore::path_of(const Object& sweep) const {
  return fmt::format("{}/sweep-{:020}-{}{}", folder_, sweep.utime, hex(sweep.digest), kExtension);
}

}  // namespace scanway
