// OctreeFile: the bytes of a .bt file, and cubes of it as files of their own.
#include <array>
#include <charconv>
#include <string>

#include "common/octree/octree_file.h"
#include "common/octree/octree_space.h"

namespace scanway {
namespace {

using namespace octree;

constexpr int kCubeDepth = 9;

std::string header_text(std::size_t size, double resolution_m) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), resolution_m).ptr;
  return std::string(kBinary) + "\n# (feel free to add / change comments, but leave the first line as it is!)\n#\n" +
         "id OcTree\nsize " + std::to_string(size) + "\nres " + std::string(digits.data(), end) + "\ndata\n";
}

}  // namespace

void OctreeFile::append_bt(std::int32_t node, std::string& data, std::size_t& size) const {
  const Inner& inner = nodes_[static_cast<std::size_t>(node)];
  std::array<unsigned, 2> bits{};
  ++size;
  for (std::size_t child = 0; child < 8; ++child) {
    const std::int32_t below = inner.below[child];
    const unsigned kind = below >= 0 ? 3U : below == kOccupied ? 2U : below == kFree ? 1U : 0U;
    bits[child / 4] |= kind << (2 * (child % 4));
    if (kind == 1 || kind == 2) ++size;
  }
  for (const unsigned byte : bits) data.push_back(static_cast<char>(byte));
  for (const std::int32_t below : inner.below) {
    if (below >= 0) append_bt(below, data, size);
  }
}

std::string OctreeFile::bt_bytes() const {
  std::string data;
  std::size_t size = 0;
  append_bt(0, data, size);
  return header_text(size, resolution_m_) + data;
}

/// `path` leads to `child` of `from`; here it becomes a tree of that one branch.
void OctreeFile::cut(const OctreeFile& from, std::int32_t child, std::vector<int>& path,
                     std::map<std::string, std::string>& cubes) const {
  if (child == kUnknown) return;
  if (child >= 0 && path.size() < kCubeDepth) {
    for (int i = 0; i < 8; ++i) {
      path.push_back(i);
      cut(from, from.nodes_[static_cast<std::size_t>(child)].below[static_cast<std::size_t>(i)], path, cubes);
      path.pop_back();
    }
    return;
  }
  OctreeFile branch(from.resolution_m_);
  OctreeLeaf cube = kWhole;
  for (std::size_t step = 0, node = 0; step < path.size(); ++step) {
    cube = part_of(cube, path[step]);
    const bool last = step + 1 == path.size();
    const std::int32_t below = last ? branch.take_over(from, child, kDepth) : static_cast<std::int32_t>(node + 1);
    if (!last) branch.nodes_.emplace_back();
    branch.nodes_[node++].below[static_cast<std::size_t>(path[step])] = below;
  }
  const std::int32_t side = 1 << (kDepth - kCubeDepth);
  std::string key = std::to_string(cube.low[0] / side);
  for (const std::size_t axis : {1, 2}) key.append(",").append(std::to_string(cube.low[axis] / side));
  cubes[key] = branch.bt_bytes();
}

std::map<std::string, std::string> OctreeFile::cubes() const {
  std::map<std::string, std::string> cubes;
  std::vector<int> path;
  cut(*this, 0, path, cubes);
  return cubes;
}

}  // namespace scanway
