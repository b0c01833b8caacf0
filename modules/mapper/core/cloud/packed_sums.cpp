#include "modules/mapper/core/cloud/packed_sums.h"

namespace scanway {
namespace {

/// Seven bits a byte, the lowest first; the last byte's highest bit is not set.
void put_number(std::uint64_t number, std::vector<std::uint8_t>& bytes) {
  for (; number >= 128; number >>= 7) bytes.push_back(static_cast<std::uint8_t>(number | 128));
  bytes.push_back(static_cast<std::uint8_t>(number));
}

std::uint64_t take_number(const std::uint8_t*& at) {
  std::uint64_t number = 0;
  for (int shift = 0;; shift += 7) {
    const std::uint8_t byte = *at++;
    number |= std::uint64_t{byte & 127u} << shift;
    if (byte < 128) return number;
  }
}

/// Small numbers for small distances from 0.
std::uint64_t zigzag(std::int64_t v) {
  return static_cast<std::uint64_t>(v) << 1 ^ static_cast<std::uint64_t>(v >> 63);
}
std::int64_t unzigzag(std::uint64_t v) { return static_cast<std::int64_t>(v >> 1 ^ (0 - (v & 1))); }

}  // namespace

void pack(std::span<const VoxelSum> sums, std::uint64_t first_key, bool with_intensity,
          std::vector<std::uint8_t>& bytes) {
  std::uint64_t before = first_key;
  for (const VoxelSum& voxel : sums) {
    put_number(voxel.key - before, bytes);
    put_number(voxel.count, bytes);
    for (const std::uint64_t sum : voxel.offset_sum) put_number(sum, bytes);
    if (with_intensity) put_number(zigzag(voxel.intensity_sum), bytes);
    before = voxel.key;
  }
}

void unpack(std::span<const std::uint8_t> bytes, std::uint64_t first_key, bool with_intensity,
            std::vector<VoxelSum>& sums) {
  std::uint64_t key = first_key;
  for (const std::uint8_t* at = bytes.data(); at != bytes.data() + bytes.size();) {
    VoxelSum voxel;
    key = voxel.key = key + take_number(at);
    voxel.count = static_cast<std::uint32_t>(take_number(at));
    for (std::uint64_t& sum : voxel.offset_sum) sum = take_number(at);
    if (with_intensity) {
      voxel.with_intensity = voxel.count;
      voxel.intensity_sum = unzigzag(take_number(at));
    }
    sums.push_back(voxel);
  }
}

}  // namespace scanway
