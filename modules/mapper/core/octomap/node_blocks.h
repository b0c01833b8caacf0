#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <vector>

namespace scanway {

/// A block's number; there is no block 0: a node without children has that.
using BlockNumber = std::uint32_t;

/// The eight children of a node, side by side: their values in log-odds (of a child that is not there: not a number)
/// and the blocks of their own children.
struct alignas(64) NodeBlock {
  static constexpr float kNoNode = std::numeric_limits<float>::quiet_NaN();
  std::array<float, 8> log_odds;
  std::array<BlockNumber, 8> children;

  bool has(std::size_t child) const { return !std::isnan(log_odds[child]); }
};

/// The blocks of one tree. They keep their addresses; reading them while others are taken is safe.
class NodeBlocks {
 public:
  NodeBlocks();

  NodeBlock& operator[](BlockNumber number) { return chunks_[number >> kChunkBits][number % kChunkSize]; }
  const NodeBlock& operator[](BlockNumber number) const { return chunks_[number >> kChunkBits][number % kChunkSize]; }

  /// Some blocks that nobody uses, for one thread. Throws std::length_error when there are no more numbers.
  std::vector<BlockNumber> take();
  void give_back(std::vector<BlockNumber> blocks);

 private:
  static constexpr int kChunkBits = 15;
  static constexpr BlockNumber kChunkSize = BlockNumber{1} << kChunkBits;
  static constexpr BlockNumber kMostChunks = BlockNumber{1} << 13;
  static constexpr std::size_t kTakenAtOnce = 256;

  void add_chunk();

  std::vector<std::unique_ptr<NodeBlock[]>> chunks_;  ///< Of a fixed size, so that it never moves.
  BlockNumber next_ = 1;                              ///< The first that was never taken.
  std::vector<BlockNumber> unused_;
  std::mutex mutex_;
};

/// One thread's supply of blocks; what is left of it goes back at the end.
class BlockSupply {
 public:
  explicit BlockSupply(NodeBlocks& blocks) : blocks_(blocks) {}
  BlockSupply(const BlockSupply&) = delete;
  BlockSupply& operator=(const BlockSupply&) = delete;
  ~BlockSupply() { blocks_.give_back(std::move(stock_)); }

  /// A block of children without children, all of that value.
  BlockNumber take(float log_odds) {
    if (stock_.empty()) stock_ = blocks_.take();
    const BlockNumber number = stock_.back();
    stock_.pop_back();
    blocks_[number].log_odds.fill(log_odds);
    blocks_[number].children.fill(0);
    return number;
  }
  void give_back(BlockNumber number) { stock_.push_back(number); }

 private:
  NodeBlocks& blocks_;
  std::vector<BlockNumber> stock_;
};

}  // namespace scanway
