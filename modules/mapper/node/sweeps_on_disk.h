#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "modules/mapper/core/sweep_archive.h"
#include "modules/mapper/node/nameless_file.h"

namespace scanway {

/// Sweeps in a file without a name: a hundred of them would fill the memory, and they are read only when their poses
/// move. Where the disk takes no more, they stay in memory.
class SweepsOnDisk : public SweepArchive {
 public:
  void keep(const Sweep& sweep) override;
  Sweep fetch(std::size_t number) const override;

 private:
  struct Kept {
    std::int64_t offset = 0;
    std::size_t size = 0;
    std::vector<std::uint8_t> bytes;  ///< Only if they are not in the file.
    std::optional<Eigen::Quaterniond> R_world_sweep;
  };

  NamelessFile file_;
  std::int64_t end_ = 0;
  std::vector<Kept> sweeps_;
};

}  // namespace scanway
