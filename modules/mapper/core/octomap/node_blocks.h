#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace scanway {

/// A block's number; there is no block 0: a node without children has that.
using BlockNumber = std::uint32_t;
constexpr BlockNumber kLastBlock = (BlockNumber{1} << 28) - 1;

/// The value of a node that is not there: not a number.
constexpr float kNoNode = std::numeric_limits<float>::quiet_NaN();

/// The eight children of a node, side by side: their values in log-odds and the blocks of their own children.
struct alignas(64) NodeBlock {
  std::array<float, 8> log_odds;
  std::array<BlockNumber, 8> children;

  bool has(std::size_t child) const { return !std::isnan(log_odds[child]); }
  void fill(float value) {
    log_odds.fill(value);
    children.fill(0);
  }
};

/// Blocks of one tree. They keep their addresses; reading them while others are taken is safe.
template <class Block>
class BlockPool {
 public:
  BlockPool() : chunks_(kMostChunks) {}

  Block& operator[](BlockNumber number) { return chunks_[number >> kChunkBits][number % kChunkSize]; }
  const Block& operator[](BlockNumber number) const { return chunks_[number >> kChunkBits][number % kChunkSize]; }

  /// Some blocks that nobody uses, for one thread. Throws std::length_error when there are no more numbers.
  std::vector<BlockNumber> take();
  void give_back(const std::vector<BlockNumber>& blocks);

 private:
  static constexpr int kChunkBits = 15;
  static constexpr BlockNumber kChunkSize = BlockNumber{1} << kChunkBits;
  static constexpr BlockNumber kMostChunks = (kLastBlock >> kChunkBits) + 1;
  static constexpr std::size_t kTakenAtOnce = 256;

  void add_chunk();

  std::vector<std::unique_ptr<Block[]>> chunks_;  ///< Of a fixed size, so that it never moves.
  BlockNumber next_ = 1;                          ///< The first that was never taken.
  std::vector<BlockNumber> unused_;
  std::mutex mutex_;
};

/// One thread's supply of blocks; what is left of it goes back at the end.
template <class Block>
class BlockSupply {
 public:
  explicit BlockSupply(BlockPool<Block>& blocks) : blocks_(blocks) {}
  BlockSupply(const BlockSupply&) = delete;
  BlockSupply& operator=(const BlockSupply&) = delete;
  ~BlockSupply() { blocks_.give_back(stock_); }

  /// A block of any content.
  BlockNumber take() {
    if (stock_.empty()) stock_ = blocks_.take();
    const BlockNumber number = stock_.back();
    stock_.pop_back();
    return number;
  }
  void give_back(BlockNumber number) { stock_.push_back(number); }

 private:
  BlockPool<Block>& blocks_;
  std::vector<BlockNumber> stock_;
};

}  // namespace scanway
