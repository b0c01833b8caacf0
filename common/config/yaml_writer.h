#pragma once

#include <string>

#include "common/config/fields.h"

namespace scanway {

/// Writes a configuration as YAML: every key, numbers in the shortest form that reads back to the last bit.
class YamlWriter : public Fields {
 public:
  void begin_section(std::string_view name) override;
  void end_section() override;
  void number(std::string_view key, double& value, Range range) override;
  void whole_number(std::string_view key, int& value, Range range) override;
  void boolean(std::string_view key, bool& value) override;
  void text(std::string_view key, std::string& value) override;
  void numbers(std::string_view key, std::span<double> values, Range range) override;
  void points(std::string_view key, std::vector<Eigen::Vector2d>& points, PointsCheck problem_of) override;
  void choice(std::string_view key, int& index, std::span<const std::string_view> names) override;

  const std::string& yaml() const { return yaml_; }

 private:
  void line(std::string_view key, std::string_view value);

  std::string yaml_;
  std::string indent_;
};

}  // namespace scanway
