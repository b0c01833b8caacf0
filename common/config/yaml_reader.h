#pragma once

#include <set>
#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "common/config/fields.h"

namespace scanway {

/// Reads a configuration from a YAML mapping. Keys that the file lacks leave their value as it is. finish() rejects
/// keys that nobody asked for. Every fault throws InputError that names the file, the key and its line.
class YamlReader : public Fields {
 public:
  /// `name` stands for the file in messages.
  YamlReader(const YAML::Node& mapping, std::string name);

  void begin_section(std::string_view name) override;
  void end_section() override;
  void number(std::string_view key, double& value, Range range) override;
  void whole_number(std::string_view key, int& value, Range range) override;
  void boolean(std::string_view key, bool& value) override;
  void text(std::string_view key, std::string& value) override;
  void numbers(std::string_view key, std::span<double> values, Range range) override;
  void points(std::string_view key, std::vector<Eigen::Vector2d>& points, PointsCheck problem_of) override;
  void choice(std::string_view key, int& index, std::span<const std::string_view> names) override;

  void finish() const;

 private:
  struct Section {
    std::string prefix;  ///< Of its keys in messages: "body.".
    YAML::Node mapping;
  };
  struct Entry {
    std::string key;  ///< Dotted.
    YAML::Node key_node, value;
  };

  /// The value of `key` in the present section; undefined when the file lacks it.
  YAML::Node value_of(std::string_view key);
  void list_entries(const YAML::Node& mapping, const std::string& prefix);
  double number_from(const YAML::Node& node, std::string_view key, Range range) const;
  std::string full(std::string_view key) const { return sections_.back().prefix + std::string(key); }
  [[noreturn]] void fail(std::string_view key, const YAML::Node& node, const std::string& what) const;
  [[noreturn]] void fail_unknown(const Entry& entry) const;

  std::string name_;
  std::vector<Section> sections_;
  std::vector<std::string> known_;  ///< Dotted keys that were asked for, sections too.
  std::vector<Entry> entries_;      ///< All keys of the sections that were begun.
};

}  // namespace scanway
