#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace scanway {

/// A cube of an OctoMap that is free or occupied as a whole.
struct OctreeLeaf {
  std::array<std::int32_t, 3> low{};  ///< Voxel at its lowest corner: covers [low, low + side) times the resolution.
  std::int32_t side = 1;              ///< In voxels.
  bool occupied = false;
};

/// An OctoMap as its files hold it (octomap::OcTree's .bt and .ot), each part of it free, occupied or unknown.
class OctreeFile {
 public:
  /// `name` stands for the file in messages. Takes at most some twenty times the file's size of memory. Throws
  /// InputError for what is no such file, or is damaged.
  OctreeFile(std::string_view bytes, const std::string& name);

  double resolution_m() const { return resolution_m_; }
  void for_each_leaf(const std::function<void(const OctreeLeaf&)>& visit) const;

  /// The same with no leaf finer than `voxel_m`: of a coarser cube, occupied where any part of it is, else free where
  /// any part is known, as OctoMap's inner nodes have it.
  OctreeFile coarsened(double voxel_m) const;
  /// The .bt file.
  std::string bt_bytes() const;
  /// Cubes of 128 voxels a side as .bt files of their own (a larger leaf is one too), by the cube's number "x,y,z".
  std::map<std::string, std::string> cubes() const;
  /// Takes over what `cube` (one of cubes()) knows.
  void join(const OctreeFile& cube);

 private:
  /// What is below an inner node: another inner node's index, or one of these.
  enum Child : std::int32_t { kUnknown = -1, kFree = -2, kOccupied = -3 };
  struct Inner {
    std::array<std::int32_t, 8> below = {kUnknown, kUnknown, kUnknown, kUnknown,
                                         kUnknown, kUnknown, kUnknown, kUnknown};
  };
  class Reader;

  explicit OctreeFile(double resolution_m) : resolution_m_(resolution_m), nodes_(1) {}
  void visit_below(std::int32_t node, const OctreeLeaf& cube,
                   const std::function<void(const OctreeLeaf&)>& visit) const;
  std::int32_t take_over(const OctreeFile& from, std::int32_t child, int levels);
  std::int32_t state_below(std::int32_t child) const;
  void append_bt(std::int32_t node, std::string& data, std::size_t& size) const;
  void cut(const OctreeFile& from, std::int32_t child, std::vector<int>& path,
           std::map<std::string, std::string>& cubes) const;

  double resolution_m_ = 0.0;
  std::vector<Inner> nodes_;  // The first is the root.
};

}  // namespace scanway
