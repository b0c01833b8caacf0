// OctreeFile: from the bytes of a .bt or .ot file.
#include <cstring>
#include <optional>

#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "common/files/text_lines.h"
#include "common/octree/octree_file.h"
#include "common/octree/octree_space.h"

namespace scanway {
namespace {

using namespace octree;

constexpr double kFinest = 1e-4, kCoarsest = 1e3;  // metres

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

}  // namespace scanway
