#include "modules/mapper/core/cloud/packed_sums.h"

#include <array>

namespace scanway {
namespace {

constexpr std::int32_t kNormalZero = 128;

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

using Normal = std::array<std::int32_t, 3>;

void put_normal(const Normal& normal, std::vector<std::uint8_t>& bytes) {
  for (const std::int32_t component : normal) bytes.push_back(static_cast<std::uint8_t>(component + kNormalZero));
}

Normal take_normal(const std::uint8_t*& at) {
  Normal normal{};
  for (std::int32_t& component : normal) component = *at++ - kNormalZero;
  return normal;
}

}  // namespace

void pack(std::span<const VoxelSum> sums, std::uint64_t first_key, bool with_intensity,
          std::vector<std::uint8_t>& bytes) {
  std::uint64_t before = first_key;
  Normal normal{};
  for (const VoxelSum& voxel : sums) {
    const bool turns = !voxel.has_normal(normal);
    put_number((voxel.key - before) << 1 | (turns ? 1 : 0), bytes);
    if (turns) put_normal(normal = voxel.normal(), bytes);
    put_number(voxel.count, bytes);
    for (const std::uint64_t sum : voxel.offset_sum) put_number(sum, bytes);
    if (with_intensity) put_number(zigzag(voxel.intensity_sum), bytes);
    before = voxel.key;
  }
}

void unpack(std::span<const std::uint8_t> bytes, std::uint64_t first_key, bool with_intensity,
            std::vector<VoxelSum>& sums) {
  std::uint64_t key = first_key;
  Normal normal{};
  for (const std::uint8_t* at = bytes.data(); at != bytes.data() + bytes.size();) {
    VoxelSum voxel;
    const std::uint64_t step = take_number(at);
    key = voxel.key = key + (step >> 1);
    if ((step & 1) != 0) normal = take_normal(at);
    voxel.count = static_cast<std::uint32_t>(take_number(at));
    voxel.set_normal(normal);
    for (std::uint64_t& sum : voxel.offset_sum) sum = take_number(at);
    if (with_intensity) {
      voxel.with_intensity = voxel.count;
      voxel.intensity_sum = unzigzag(take_number(at));
    }
    sums.push_back(voxel);
  }
}

}  // namespace scanway
