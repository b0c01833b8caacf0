#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace scanway {

/// The numbers that make sense for a key, in the key's own unit.
struct Range {
  double lowest;
  double highest;
};

/// Takes the description of a configuration, one call a key: to read it from a file, to write it, to list its keys.
/// So a key is described once, in one line, and a reader and a writer cannot disagree. Keys end in their unit
/// (units.h); values are in SI units and radians.
class Fields {
 public:
  /// What is wrong with a list of corners, or an empty text.
  using PointsCheck = std::string (*)(const std::vector<Eigen::Vector2d>&);

  virtual ~Fields() = default;

  virtual void begin_section(std::string_view name) = 0;
  virtual void end_section() = 0;

  virtual void number(std::string_view key, double& value, Range range) = 0;
  virtual void whole_number(std::string_view key, int& value, Range range) = 0;
  virtual void boolean(std::string_view key, bool& value) = 0;
  virtual void text(std::string_view key, std::string& value) = 0;
  /// As many numbers as `values` holds.
  virtual void numbers(std::string_view key, std::span<double> values, Range range) = 0;
  virtual void points(std::string_view key, std::vector<Eigen::Vector2d>& points, PointsCheck problem_of) = 0;
  /// `index` into `names`.
  virtual void choice(std::string_view key, int& index, std::span<const std::string_view> names) = 0;

  /// An enum whose values count from 0 in the order of `names`.
  template <class Enum>
  void enumeration(std::string_view key, Enum& value, std::span<const std::string_view> names) {
    int index = static_cast<int>(value);
    choice(key, index, names);
    value = static_cast<Enum>(index);
  }
};

}  // namespace scanway
