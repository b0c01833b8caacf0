#include "common/octree/octree_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>

#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "common/files/text_lines.h"

namespace scanway {
namespace {

constexpr int kDepth = 16;
constexpr int kCubeDepth = 9;
constexpr std::int32_t kCentre = 1 << (kDepth - 1);  // The voxel at the map's origin.
constexpr double kFinest = 1e-4, kCoarsest = 1e3;    // metres
constexpr std::string_view kBinary = "# Octomap OcTree binary file", kFull = "# Octomap OcTree file";

struct Header {
  bool is_binary = false;
  std::uint64_t size = 0;
  double resolution_m = 0.0;
  std::string_view data;
};

[[noreturn]] void fail_octree(const std::string& name, const std::string& what) {
  throw InputError(printable(name) + ": " + what);
}

Header header_of(std::string_view bytes, const std::string& name) {
  Header header;
  header.is_binary = bytes.starts_with(kBinary);
  if (!header.is_binary && !bytes.starts_with(kFull)) {
    fail_octree(name, "is no OctoMap: it begins with neither '" + std::string(kBinary) + "' nor '" +
                          std::string(kFull) + "'; name a .bt or .ot file");
  }
  TextLines lines(bytes);
  for (std::optional<std::string_view> line; (line = lines.next()) && *line != "data";) {
    std::string_view rest = *line;
    const std::string_view key = take_token(rest), value = take_token(rest);
    if (key == "id" && value != "OcTree")
      fail_octree(name, "holds a tree of the kind " + in_quotes(value) + ", not OcTree");
    if (key == "size") header.size = parse_count(value).value_or(0);
    if (key == "res") header.resolution_m = parse_number(value).value_or(0.0);
  }
  header.data = lines.rest();
  if (!(header.resolution_m >= kFinest && header.resolution_m <= kCoarsest)) {
    fail_octree(name, "its header has no line res with a resolution in metres; write the map again");
  }
  return header;
}

std::string header_text(std::size_t size, double resolution_m) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), resolution_m).ptr;
  return std::string(kBinary) + "\n# (feel free to add / change comments, but leave the first line as it is!)\n#\n" +
         "id OcTree\nsize " + std::to_string(size) + "\nres " + std::string(digits.data(), end) + "\ndata\n";
}

OctreeLeaf part_of(const OctreeLeaf& cube, int child) {
  OctreeLeaf part{cube.low, cube.side / 2, false};
  for (int axis = 0; axis < 3; ++axis) part.low[static_cast<std::size_t>(axis)] += (child >> axis & 1) * part.side;
  return part;
}

}  // namespace

/// Reads depth first, as the files are written, never deeper than a tree is.
class OctreeFile::Reader {
 public:
  Reader(std::string_view data, const std::string& name, std::vector<Inner>& nodes)
      : data_(data), name_(name), nodes_(nodes) {}

  void read_binary(std::size_t node, int depth) {
    const std::string_view bits = take(2);
    for (std::size_t child = 0; child < 8; ++child) {
      const int byte = static_cast<unsigned char>(bits[child / 4]);
      const int kind = byte >> (2 * (child % 4)) & 3;
      if (kind == 1) nodes_[node].below[child] = kFree;
      if (kind == 2) nodes_[node].below[child] = kOccupied;
      if (kind == 3) read_binary(add_below(node, child, depth), depth + 1);
    }
  }

  /// Of a node its log-odds, and which children it has.
  std::int32_t read_full(int depth) {
    const std::string_view bytes = take(5);
    float log_odds = 0.0F;
    std::memcpy(&log_odds, bytes.data(), sizeof log_odds);
    const int children = static_cast<unsigned char>(bytes[4]);
    if (children == 0) return log_odds >= 0.0F ? kOccupied : kFree;
    check(depth);
    const std::size_t node = nodes_.size();
    nodes_.emplace_back();
    for (std::size_t child = 0; child < 8; ++child) {
      if (children >> child & 1) {
        const std::int32_t below = read_full(depth + 1);
        nodes_[node].below[child] = below;
      }
    }
    return static_cast<std::int32_t>(node);
  }

 private:
  std::string_view take(std::size_t count) {
    if (data_.size() < count) fail_octree(name_, "ends in the middle of the tree; copy the file again");
    const std::string_view taken = data_.substr(0, count);
    data_.remove_prefix(count);
    return taken;
  }
  void check(int depth) const {
    if (depth >= kDepth) fail_octree(name_, "is damaged: a branch of its tree is deeper than 16; copy the file again");
  }
  std::size_t add_below(std::size_t node, std::size_t child, int depth) {
    check(depth + 1);
    nodes_[node].below[child] = static_cast<std::int32_t>(nodes_.size());
    nodes_.emplace_back();
    return nodes_.size() - 1;
  }

  std::string_view data_;
  const std::string& name_;
  std::vector<Inner>& nodes_;
};

OctreeFile::OctreeFile(std::string_view bytes, const std::string& name) {
  const Header header = header_of(bytes, name);
  resolution_m_ = header.resolution_m;
  Reader reader(header.data, name, nodes_);
  if (header.is_binary) nodes_.resize(1);
  if (header.is_binary && header.size > 0) reader.read_binary(0, 0);
  if (!header.is_binary && header.size > 0 && reader.read_full(0) < 0) nodes_.clear();  // One leaf is the whole space.
  if (nodes_.empty()) nodes_.resize(1);
}

void OctreeFile::for_each_leaf(const std::function<void(const OctreeLeaf&)>& visit) const {
  visit_below(0, {{-kCentre, -kCentre, -kCentre}, 1 << kDepth, false}, visit);
}

void OctreeFile::visit_below(std::int32_t node, const OctreeLeaf& cube,
                             const std::function<void(const OctreeLeaf&)>& visit) const {
  for (int child = 0; child < 8; ++child) {
    const std::int32_t below = nodes_[static_cast<std::size_t>(node)].below[static_cast<std::size_t>(child)];
    OctreeLeaf part = part_of(cube, child);
    part.occupied = below == kOccupied;
    if (below >= 0) visit_below(below, part, visit);
    if (below == kFree || below == kOccupied) visit(part);
  }
}

std::int32_t OctreeFile::state_below(std::int32_t child) const {
  if (child < 0) return child;
  std::int32_t state = kUnknown;
  for (const std::int32_t below : nodes_[static_cast<std::size_t>(child)].below) {
    state = std::min(state, state_below(below));  // Occupied goes before free, free before unknown.
  }
  return state;
}

/// What `child` of `from` is here, with so many levels below it. Eight leaves that are alike are one.
std::int32_t OctreeFile::take_over(const OctreeFile& from, std::int32_t child, int levels) {
  if (child < 0 || levels == 0) return from.state_below(child);
  const auto index = static_cast<std::int32_t>(nodes_.size());
  nodes_.emplace_back();
  Inner inner;
  for (std::size_t i = 0; i < 8; ++i) {
    inner.below[i] = take_over(from, from.nodes_[static_cast<std::size_t>(child)].below[i], levels - 1);
  }
  const bool alike = std::all_of(inner.below.begin(), inner.below.end(),
                                 [&](std::int32_t below) { return below == inner.below[0] && below < 0; });
  if (alike) {
    nodes_.resize(static_cast<std::size_t>(index));
    return inner.below[0];
  }
  nodes_[static_cast<std::size_t>(index)] = inner;
  return index;
}

OctreeFile OctreeFile::coarsened(double voxel_m) const {
  int levels = kDepth;
  for (double edge = 2.0 * resolution_m_; edge <= voxel_m * (1.0 + 1e-9) && levels > 1; edge *= 2.0) --levels;
  OctreeFile coarse(resolution_m_);
  for (std::size_t i = 0; i < 8; ++i) {
    const std::int32_t below = coarse.take_over(*this, nodes_[0].below[i], levels - 1);
    coarse.nodes_[0].below[i] = below;
  }
  return coarse;
}

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
  OctreeLeaf cube{{-kCentre, -kCentre, -kCentre}, 1 << kDepth, false};
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

void OctreeFile::join(const OctreeFile& cube) {
  const std::function<std::int32_t(std::int32_t, std::int32_t)> joined = [&](std::int32_t mine, std::int32_t other) {
    if (mine < 0 && mine != kUnknown) return mine;
    if (other < 0) return mine == kUnknown ? other : mine;
    if (mine == kUnknown) return take_over(cube, other, kDepth);
    for (std::size_t i = 0; i < 8; ++i) {
      const std::int32_t below = joined(nodes_[static_cast<std::size_t>(mine)].below[i],
                                        cube.nodes_[static_cast<std::size_t>(other)].below[i]);
      nodes_[static_cast<std::size_t>(mine)].below[i] = below;
    }
    return mine;
  };
  joined(0, 0);
}

}  // namespace scanway
