#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/messages/objects.h"
#include "common/time/utime.h"
#include "scanway/map_command_t.hpp"

namespace scanway {

/// Keeps the sweeps that a map is made of, each with the orientation that it was used with, as a small LCM log a sweep.
/// A mapper that is started again makes the same map of them.
class SweepStore {
 public:
  /// Makes the folder. Throws InputError.
  explicit SweepStore(std::string folder);

  /// `imu`: a message with the orientation that the sweep uses; empty: none. `inputs`: the SWEEP_INPUTS of a sweep that
  /// was assembled; else empty. Whole on the disk when this returns. Throws InputError.
  void keep(const Object& sweep, std::span<const std::uint8_t> imu, std::span<const std::uint8_t> inputs = {}) const;
  /// A command that was carried out after the sweep of that time. Throws InputError.
  void keep(const map_command_t& command, Utime after) const;
  bool has(const Object& sweep) const;
  /// The sweep did not get into the map.
  void drop(const Object& sweep) const;

  /// The logs, in the order of their sweeps' times.
  std::vector<std::string> logs() const;

  /// The map that this one continues, if it does.
  std::optional<SweepStore> earlier() const;
  /// From now on this continues the map in `folder`, whose sweeps it takes over. Whole on the disk when this returns,
  /// or not at all; nothing if it continues a map already. Throws InputError.
  void continue_from(const std::string& folder) const;
  /// Takes over the sweeps of `map`, and of those that it continues. Throws InputError.
  void take_over(const SweepStore& map) const;

 private:
  std::string path_of(const Object& sweep) const;

  std::string folder_;
};

/// The map that was kept in `folder`, or saved there as a whole (common/files/saved_folder.h), which is checked then.
/// Throws InputError if there is none.
SweepStore saved_map(const std::string& folder);

}  // namespace scanway
