#include "modules/mapper/core/octomap/node_blocks.h"

#include <algorithm>
#include <stdexcept>

#include "modules/mapper/core/octomap/voxel_blocks.h"

namespace scanway {

template <class Block>
void BlockPool<Block>::add_chunk() {
  const BlockNumber chunk = next_ >> kChunkBits;
  if (chunk == kMostChunks) throw std::length_error("an OctoMap of more nodes than can be numbered");
  if (!chunks_[chunk]) chunks_[chunk] = std::make_unique_for_overwrite<Block[]>(kChunkSize);
}

template <class Block>
std::vector<BlockNumber> BlockPool<Block>::take() {
  const std::lock_guard lock(mutex_);
  std::vector<BlockNumber> taken;
  if (!unused_.empty()) {
    const std::size_t count = std::min(unused_.size(), kTakenAtOnce);
    taken.assign(unused_.end() - static_cast<std::ptrdiff_t>(count), unused_.end());
    unused_.resize(unused_.size() - count);
    return taken;
  }
  add_chunk();
  const BlockNumber end = std::min<BlockNumber>(next_ + kTakenAtOnce, (next_ >> kChunkBits << kChunkBits) + kChunkSize);
  for (BlockNumber number = end; number-- > next_;) taken.push_back(number);
  next_ = end;
  return taken;
}

template <class Block>
void BlockPool<Block>::give_back(const std::vector<BlockNumber>& blocks) {
  const std::lock_guard lock(mutex_);
  unused_.insert(unused_.end(), blocks.begin(), blocks.end());
}

template class BlockPool<NodeBlock>;
template class BlockPool<FewVoxelValues>;
template class BlockPool<VoxelBlock>;

}  // namespace scanway
