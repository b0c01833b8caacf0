#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "modules/mapper/core/cloud/sweep_number.h"
#include "modules/mapper/core/octomap/packed_brick.h"
#include "modules/mapper/core/octomap/voxel_bricks.h"
#include "modules/mapper/core/storage/byte_store.h"

namespace scanway {

using BrickNumbers = std::vector<VoxelBricks::BrickNumber>;  ///< In increasing order.

/// What every sweep says of the voxels, packed, in a store.
class VoxelHistory {
 public:
  explicit VoxelHistory(std::shared_ptr<ByteStore> store) : store_(std::move(store)) {}

  void put(SweepNumber sweep, VoxelBricks& bricks);
  /// The bricks that the sweep touched; none when there is no such sweep.
  BrickNumbers forget(SweepNumber sweep);

  std::vector<SweepNumber> sweeps() const;  ///< Oldest first.

  /// What one sweep says of some bricks.
  class Page {
   public:
    std::size_t size() const { return bricks_.size(); }
    std::size_t place(std::size_t i) const { return bricks_[i].place; }  ///< Of brick i among those asked for.
    VoxelBrick brick(std::size_t i) const { return unpacked_brick(&bytes_[bricks_[i].begin]); }

   private:
    friend class VoxelHistory;
    struct Brick {
      std::size_t place, begin;
    };
    std::vector<std::uint8_t> bytes_;
    std::vector<Brick> bricks_;
  };
  Page read(SweepNumber sweep, const BrickNumbers& numbers) const;

 private:
  struct View {
    BrickNumbers numbers;
    StoredBytes bricks;
  };

  std::shared_ptr<ByteStore> store_;
  std::map<SweepNumber, View> views_;
};

}  // namespace scanway
