#include "common/config/yaml_writer.h"

#include "common/config/units.h"

namespace scanway {
namespace {

std::string list_text(std::span<const double> values, std::string_view key) {
  std::string list;
  for (const double value : values) list += (list.empty() ? "" : ", ") + text_from_si(value, unit_of(key));
  return "[" + list + "]";
}

std::string yaml_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) result += (c == '"' || c == '\\') ? std::string{'\\', c} : std::string{c};
  return result + '"';
}

}  // namespace

void YamlWriter::line(std::string_view key, std::string_view value) {
  yaml_ += indent_ + std::string(key) + ":" + (value.empty() ? "" : " ") + std::string(value) + "\n";
}

void YamlWriter::begin_section(std::string_view name) {
  line(name, "");
  indent_ += "  ";
}

void YamlWriter::end_section() { indent_.resize(indent_.size() - 2); }

void YamlWriter::number(std::string_view key, double& value, Range) { line(key, text_from_si(value, unit_of(key))); }

void YamlWriter::whole_number(std::string_view key, int& value, Range) { line(key, std::to_string(value)); }

void YamlWriter::boolean(std::string_view key, bool& value) { line(key, value ? "true" : "false"); }

void YamlWriter::text(std::string_view key, std::string& value) { line(key, yaml_string(value)); }

void YamlWriter::numbers(std::string_view key, std::span<double> values, Range) { line(key, list_text(values, key)); }

void YamlWriter::points(std::string_view key, std::vector<Eigen::Vector2d>& points, PointsCheck) {
  std::string list;
  for (const Eigen::Vector2d& point : points) {
    list += (list.empty() ? "" : ", ") + list_text({point.data(), 2}, key);
  }
  line(key, "[" + list + "]");
}

void YamlWriter::choice(std::string_view key, int& index, std::span<const std::string_view> names) {
  line(key, names[static_cast<std::size_t>(index)]);
}

}  // namespace scanway
