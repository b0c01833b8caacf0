#include <algorithm>
#include <array>
#include <optional>

#include "common/cloud/cloud_formats.h"
#include "common/cloud/scalar_columns.h"
#include "common/files/printable.h"
#include "common/files/text_lines.h"

namespace scanway::cloud_formats {
namespace {

std::optional<ScalarType> scalar_type(std::string_view name) {
  constexpr struct {
    std::string_view name;
    ScalarType type;
  } kTypes[] = {
      {"float", ScalarType::f32},         {"double", ScalarType::f64},       {"char", ScalarType::i8},
      {"unsigned_char", ScalarType::u8},  {"short", ScalarType::i16},        {"unsigned_short", ScalarType::u16},
      {"int", ScalarType::i32},           {"unsigned_int", ScalarType::u32}, {"long", ScalarType::i64},
      {"unsigned_long", ScalarType::u64}, {"vtktypeint64", ScalarType::i64}, {"vtktypeuint64", ScalarType::u64}};
  for (const auto& known : kTypes) {
    if (name == known.name) return known.type;
  }
  return std::nullopt;
}

/// The data that follow a line, in either of the two forms.
class VtkData {
 public:
  VtkData(std::string_view bytes, std::size_t lines_before, bool binary, const std::string& file)
      : rest_(bytes), line_(lines_before + 1), binary_(binary), file_(file) {}

  PointCloud points(std::uint64_t count, ScalarType type) {
    if (count > most(type) / 3) refuse_cut(count);
    return binary_ ? binary_points(count, type) : ascii_points(count);
  }

  void skip(std::uint64_t count, ScalarType type) {
    if (count > most(type)) refuse_cut(count);
    if (binary_) return rest_.remove_prefix(count * size_of(type));
    for (std::uint64_t i = 0; i < count; ++i) {
      if (next_token().empty()) refuse_cut(count);
    }
  }

  std::string_view rest() const { return rest_; }
  std::size_t line() const { return line_; }

 private:
  /// How many numbers there can be.
  std::uint64_t most(ScalarType type) const { return binary_ ? rest_.size() / size_of(type) : rest_.size() / 2 + 1; }

  PointCloud binary_points(std::uint64_t count, ScalarType type) const {
    const std::size_t size = size_of(type);
    const auto column = [&](std::size_t axis) {
      return ScalarColumn{rest_.data() + axis * size, 3 * size, type, true};
    };
    return gather_columns(count, {column(0), column(1), column(2)}, nullptr);
  }

  PointCloud ascii_points(std::uint64_t count) {
    PointCloud cloud;
    cloud.points.reserve(count);
    while (cloud.size() < count) {
      Eigen::Vector3f p;
      for (int axis = 0; axis < 3; ++axis) {
        const std::string_view token = next_token();
        if (token.empty()) refuse_cut(count);
        p[axis] = parse_coordinate(token, file_, line_);
      }
      cloud.points.push_back(p);
    }
    return cloud;
  }

  /// The next token on this line or a later one.
  std::string_view next_token() {
    while (!rest_.empty() &&
           (rest_.front() == ' ' || rest_.front() == '\t' || rest_.front() == '\r' || rest_.front() == '\n')) {
      if (rest_.front() == '\n') ++line_;
      rest_.remove_prefix(1);
    }
    return take_token(rest_);
  }

  [[noreturn]] void refuse_cut(std::uint64_t count) const {
    refuse(file_, "promises " + std::to_string(count) + " points or numbers, but ends before the last of them; it is " +
                      "cut or damaged, copy it again");
  }

  std::string_view rest_;
  std::size_t line_;
  bool binary_;
  const std::string& file_;
};

/// The lines up to POINTS ("VTK File Formats", legacy).
class VtkParser {
 public:
  VtkParser(std::string_view bytes, const std::string& file) : lines_(bytes), file_(file) {}

  PointCloud parse() {
    parse_head();
    while (const auto line = lines_.next()) {
      std::string_view values = *line;
      const std::string_view key = take_token(values);
      if (key == "POINTS") return parse_points(values);
      if (key == "FIELD") {
        skip_field(values);
      } else if (key == "METADATA") {
        skip_metadata();
      } else if (!key.empty() && key != "DATASET" && key != "DIMENSIONS") {
        refuse_line(file_, number(), in_quotes(key) + " in place of POINTS; export the cloud as POLYDATA");
      }
    }
    refuse(file_, "has no POINTS; it is cut, or is no cloud: export it as POLYDATA");
  }

 private:
  /// The version, a title, and the form of the data.
  void parse_head() {
    lines_.next();
    lines_.next();
    const auto form = lines_.next();
    if (form != "ASCII" && form != "BINARY") {
      refuse_line(file_, 3, in_quotes(form.value_or("")) + " in place of ASCII or BINARY; export the cloud again");
    }
    binary_ = form == "BINARY";
  }

  PointCloud parse_points(std::string_view values) {
    const std::string_view count_token = take_token(values);
    const auto count = parse_count(count_token);
    if (!count)
      refuse_line(file_, number(), in_quotes(count_token) + " is no number of points; export the cloud again");
    const std::string_view type_token = take_token(values);
    const auto type = scalar_type(type_token);
    if (!type) refuse_line(file_, number(), in_quotes(type_token) + " is no type of VTK points; export them as float");
    return VtkData(lines_.rest(), lines_.number(), binary_, file_).points(*count, *type);
  }

  /// After "FIELD name arrays", for each array: a line "name components tuples type", and its data.
  void skip_field(std::string_view values) {
    take_token(values);
    const std::uint64_t arrays = parse_count(take_token(values)).value_or(0);
    for (std::uint64_t i = 0; i < arrays; ++i) skip_array();
  }

  void skip_array() {
    auto line = lines_.next();
    while (line && is_blank(*line)) line = lines_.next();
    std::string_view values = line.value_or("");
    take_token(values);
    const auto components = parse_count(take_token(values));
    const auto tuples = parse_count(take_token(values));
    const auto type = scalar_type(take_token(values));
    std::uint64_t count = 0;
    if (!components || !tuples || !type || __builtin_mul_overflow(*components, *tuples, &count)) {
      refuse_line(file_, number(), "this is no array of a FIELD; the file is cut or damaged, export the cloud again");
    }
    VtkData data(lines_.rest(), number(), binary_, file_);
    data.skip(count, *type);
    lines_ = TextLines(data.rest(), data.line() - 1);
  }

  /// To the next blank line.
  void skip_metadata() {
    auto line = lines_.next();
    while (line && !is_blank(*line)) line = lines_.next();
  }

  std::size_t number() const { return lines_.number(); }

  TextLines lines_;
  const std::string& file_;
  bool binary_ = false;
};

}  // namespace

PointCloud read_vtk(std::string_view bytes, const std::string& file) { return VtkParser(bytes, file).parse(); }

}  // namespace scanway::cloud_formats
