#include "common/config/yaml_reader.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include "common/config/nearest_key.h"
#include "common/config/units.h"
#include "common/config/yaml_document.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"

namespace scanway {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

std::string shown(const YAML::Node& node) {
  if (node.IsScalar()) return in_quotes(node.Scalar());
  if (node.IsNull()) return "empty";
  return node.IsSequence() ? "a list" : "a section";
}

std::string number_text(double value) { return text_from_si(value, std::nullopt); }

std::string range_text(Range range) { return number_text(range.lowest) + " to " + number_text(range.highest); }

std::string unit_text(std::string_view key) {
  const auto unit = unit_of(key);
  return unit ? std::string(" ").append(unit->name) : std::string();
}

bool is_text(const std::string& text) { return !text.empty() && text.size() <= 255 && printable(text) == text; }

}  // namespace

YamlReader::YamlReader(const YAML::Node& mapping, std::string name) : name_(printable(name)) {
  sections_.push_back({"", mapping});
  list_entries(mapping, "");
}

void YamlReader::list_entries(const YAML::Node& mapping, const std::string& prefix) {
  std::set<std::string> seen;
  for (const auto& item : mapping) {
    if (!item.first.IsScalar()) fail(prefix + "?", item.first, "has a key that is no word");
    const std::string key = prefix + item.first.Scalar();
    if (!seen.insert(key).second) fail(key, item.first, "stands twice: leave one");
    entries_.push_back({key, item.first, item.second});
  }
}

void YamlReader::begin_section(std::string_view name) {
  const YAML::Node node = value_of(name);
  const std::string key = full(name);
  const bool given = node.IsDefined() && !node.IsNull();
  if (given && !node.IsMap()) fail(key, node, "must be a section with `key: value` lines below it");
  sections_.push_back({key + ".", given ? node : YAML::Node(YAML::NodeType::Map)});
  if (given) list_entries(node, key + ".");
}

void YamlReader::end_section() { sections_.pop_back(); }

YAML::Node YamlReader::value_of(std::string_view key) {
  known_.push_back(full(key));
  const auto entry = std::ranges::find(entries_, known_.back(), &Entry::key);
  return entry == entries_.end() ? YAML::Node(YAML::NodeType::Undefined) : entry->value;
}

double YamlReader::number_from(const YAML::Node& node, std::string_view key, Range range) const {
  const auto unit = unit_of(key);
  const auto in_si = [&](const std::string& text) { return si_from_text(text, unit).value_or(kNotANumber); };
  const double value = node.IsScalar() ? in_si(node.Scalar()) : kNotANumber;
  if (value >= in_si(number_text(range.lowest)) && value <= in_si(number_text(range.highest))) return value;
  fail(full(key), node, "must be a number from " + range_text(range) + unit_text(key) + ", not " + shown(node));
}

void YamlReader::number(std::string_view key, double& value, Range range) {
  if (const YAML::Node node = value_of(key); node.IsDefined()) value = number_from(node, key, range);
}

void YamlReader::whole_number(std::string_view key, int& value, Range range) {
  const YAML::Node node = value_of(key);
  if (!node.IsDefined()) return;
  const std::string text = node.IsScalar() ? node.Scalar() : "";
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = error == std::errc{} && !text.empty() && end == text.data() + text.size();
  if (!whole || number < range.lowest || number > range.highest) {
    fail(full(key), node, "must be a whole number from " + range_text(range) + ", not " + shown(node));
  }
  value = number;
}

void YamlReader::boolean(std::string_view key, bool& value) {
  const YAML::Node node = value_of(key);
  if (!node.IsDefined()) return;
  const std::string text = node.IsScalar() ? node.Scalar() : "";
  if (text != "true" && text != "false") fail(full(key), node, "must be true or false, not " + shown(node));
  value = text == "true";
}

void YamlReader::text(std::string_view key, std::string& value) {
  const YAML::Node node = value_of(key);
  if (!node.IsDefined()) return;
  if (!node.IsScalar() || !is_text(node.Scalar())) {
    fail(full(key), node, "must be 1 to 255 printable bytes of text, not " + shown(node));
  }
  value = node.Scalar();
}

void YamlReader::numbers(std::string_view key, std::span<double> values, Range range) {
  const YAML::Node node = value_of(key);
  if (!node.IsDefined()) return;
  if (!node.IsSequence() || node.size() != values.size()) {
    fail(full(key), node, "must be a list of " + std::to_string(values.size()) + " numbers, not " + shown(node));
  }
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = number_from(node[i], key, range);
}

void YamlReader::points(std::string_view key, std::vector<Eigen::Vector2d>& points, PointsCheck problem_of) {
  const YAML::Node node = value_of(key);
  if (!node.IsDefined()) return;
  const std::string wanted = "must be a list of corners [[x, y], [x, y], ...], not ";
  if (!node.IsSequence()) fail(full(key), node, wanted + shown(node));
  constexpr Range kAnywhere = {-1e6, 1e6};
  points.clear();
  for (const YAML::Node& point : node) {
    if (!point.IsSequence() || point.size() != 2) fail(full(key), point, wanted + "a list with " + shown(point));
    points.emplace_back(number_from(point[0], key, kAnywhere), number_from(point[1], key, kAnywhere));
  }
  if (const std::string problem = problem_of(points); !problem.empty()) fail(full(key), node, problem);
}

void YamlReader::choice(std::string_view key, int& index, std::span<const std::string_view> names) {
  const YAML::Node node = value_of(key);
  if (!node.IsDefined()) return;
  const auto name = std::ranges::find(names, std::string_view(node.IsScalar() ? node.Scalar() : ""));
  if (name == names.end()) {
    std::string wanted;
    for (const std::string_view possible : names) wanted += (wanted.empty() ? "" : " or ") + std::string(possible);
    fail(full(key), node, "must be " + wanted + ", not " + shown(node));
  }
  index = static_cast<int>(name - names.begin());
}

void YamlReader::finish() const {
  for (const Entry& entry : entries_) {
    if (std::ranges::find(known_, entry.key) == known_.end()) fail_unknown(entry);
  }
}

void YamlReader::fail_unknown(const Entry& entry) const {
  const std::string right_unit = key_with_other_unit(entry.key, known_);
  const std::string nearest = nearest_key(entry.key, known_);
  std::string advice = "remove it";
  if (!right_unit.empty()) {
    advice = "it is given in" + unit_text(right_unit) + ": write " + right_unit;
  } else if (!nearest.empty()) {
    advice = "did you mean " + nearest + "?";
  }
  const int line = line_of(entry.key_node);
  throw InputError(name_ + ": unknown key " + printable(entry.key) + " (line " + std::to_string(line) + "): " + advice);
}

void YamlReader::fail(std::string_view key, const YAML::Node& node, const std::string& what) const {
  const int line = line_of(node);
  const std::string where = line > 0 ? " (line " + std::to_string(line) + ")" : "";
  throw InputError(name_ + ": " + printable(key) + where + " " + what);
}

}  // namespace scanway
