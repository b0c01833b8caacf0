#include "modules/mapper/core/cloud/packed_sums.h"

#include <algorithm>

namespace scanway {
namespace {

constexpr std::int32_t kNormalZero = 128;
constexpr std::size_t kMostBytes = 64;  // of one sum: six numbers of at most 10 bytes, one of them of 5, and a normal
constexpr std::size_t kSumsAtOnce = 128;

/// Seven bits a byte, the lowest first; the last byte's highest bit is not set. Nearly all numbers take one byte or
/// two, by turns that no CPU foresees: these take no branch, and the second byte may be written over by what follows.
std::uint8_t* put_number(std::uint64_t number, std::uint8_t* to) {
  for (; number >= 1 << 14; number >>= 7) *to++ = static_cast<std::uint8_t>(number | 128);
  const std::uint64_t more = number >= 128 ? 1 : 0;
  to[0] = static_cast<std::uint8_t>(number % 128 | more << 7);
  to[1] = static_cast<std::uint8_t>(number >> 7);
  return to + 1 + more;
}

/// Small numbers for small distances from 0.
std::uint64_t zigzag(std::int64_t v) {
  return static_cast<std::uint64_t>(v) << 1 ^ static_cast<std::uint64_t>(v >> 63);
}
std::int64_t unzigzag(std::uint64_t v) { return static_cast<std::int64_t>(v >> 1 ^ (0 - (v & 1))); }

}  // namespace

void SumPacker::pack(std::span<const VoxelSum> sums, std::vector<std::uint8_t>& bytes) {
  while (!sums.empty()) {
    const std::span<const VoxelSum> now = sums.first(std::min(kSumsAtOnce, sums.size()));
    const std::size_t before = bytes.size();
    bytes.resize(before + now.size() * kMostBytes);
    std::uint8_t* to = bytes.data() + before;
    for (const VoxelSum& voxel : now) to = put(voxel, to);
    bytes.resize(static_cast<std::size_t>(to - bytes.data()));
    sums = sums.subspan(now.size());
  }
}

std::uint8_t* SumPacker::put(const VoxelSum& voxel, std::uint8_t* to) {
  const bool turns = !voxel.has_normal(normal_);
  to = put_number((voxel.key - key_) << 1 | (turns ? 1 : 0), to);
  key_ = voxel.key;
  if (turns) {
    normal_ = voxel.normal();
    for (const std::int32_t component : normal_) *to++ = static_cast<std::uint8_t>(component + kNormalZero);
  }
  to = put_number(voxel.count, to);
  for (const std::uint64_t sum : voxel.offset_sum) to = put_number(sum, to);
  return with_intensity_ ? put_number(zigzag(voxel.intensity_sum), to) : to;
}

SumReader::SumReader(std::span<const std::uint8_t> bytes, std::uint64_t first_key, bool with_intensity)
    : at_(bytes.data()), end_(at_ + bytes.size()), key_(first_key), with_intensity_(with_intensity) {
  step();
}

/// To the next sum's key, and its normal.
void SumReader::step() {
  at_end_ = at_ == end_;
  if (at_end_) return;
  const std::uint64_t step = take_number();
  key_ += step >> 1;
  if ((step & 1) == 0) return;
  for (std::int32_t& component : normal_) component = *at_++ - kNormalZero;
}

void SumReader::read_until(std::uint64_t end_key, std::vector<VoxelSum>& sums) {
  while (!at_end_ && key_ < end_key) {
    VoxelSum& voxel = sums.emplace_back();
    voxel.key = key_;
    voxel.count = static_cast<std::uint32_t>(take_number());
    voxel.set_normal(normal_);
    for (std::uint64_t& sum : voxel.offset_sum) sum = take_number();
    if (with_intensity_) {
      voxel.with_intensity = voxel.count;
      voxel.intensity_sum = unzigzag(take_number());
    }
    step();
  }
}

/// As they are put, one byte or two without a branch.
inline std::uint64_t SumReader::take_number() {
  const std::uint64_t low = *at_++;
  if (at_ == end_) return low;
  const std::uint64_t more = low >> 7, high = *at_ & (0 - more);
  at_ += more;
  std::uint64_t number = (low & 127) | (high & 127) << 7;
  for (std::uint64_t byte = high, shift = 14; byte >= 128; shift += 7) {
    byte = *at_++;
    number |= (byte & 127) << shift;
  }
  return number;
}

}  // namespace scanway
