#include "common/cloud/ply_header.h"

#include <algorithm>

#include "common/cloud/cloud_formats.h"
#include "common/files/printable.h"
#include "common/files/text_lines.h"

namespace scanway::cloud_formats {
namespace {

/// The types by their names of 1994 and the later ones with sizes.
ScalarType scalar_type(std::string_view name, const std::string& file, std::size_t line) {
  constexpr struct {
    std::string_view name;
    ScalarType type;
  } kTypes[] = {{"char", ScalarType::i8},     {"int8", ScalarType::i8},    {"uchar", ScalarType::u8},
                {"uint8", ScalarType::u8},    {"short", ScalarType::i16},  {"int16", ScalarType::i16},
                {"ushort", ScalarType::u16},  {"uint16", ScalarType::u16}, {"int", ScalarType::i32},
                {"int32", ScalarType::i32},   {"uint", ScalarType::u32},   {"uint32", ScalarType::u32},
                {"int64", ScalarType::i64},   {"uint64", ScalarType::u64}, {"float", ScalarType::f32},
                {"float32", ScalarType::f32}, {"double", ScalarType::f64}, {"float64", ScalarType::f64}};
  for (const auto& known : kTypes) {
    if (name == known.name) return known.type;
  }
  refuse_line(file, line, in_quotes(name) + " is no type of a PLY property" + kExportAgain);
}

PlyFormat format_of(std::string_view values, const std::string& file, std::size_t line) {
  const std::string_view name = take_token(values);
  if (name == "ascii") return PlyFormat::ascii;
  if (name == "binary_little_endian") return PlyFormat::binary_little_endian;
  if (name == "binary_big_endian") return PlyFormat::binary_big_endian;
  refuse_line(file, line, in_quotes(name) + " is no format of a PLY file" + kExportAgain);
}

PlyElement element_of(std::string_view values, const std::string& file, std::size_t line) {
  const std::string_view name = take_token(values);
  const auto count = parse_count(take_token(values));
  if (!count) refuse_line(file, line, "element " + in_quotes(name) + " has no count" + kExportAgain);
  return {std::string(name), *count, {}};
}

PlyProperty property_of(std::string_view values, const std::string& file, std::size_t line) {
  PlyProperty property;
  std::string_view type = take_token(values);
  if (type == "list") {
    property.list_count_type = scalar_type(take_token(values), file, line);
    if (*property.list_count_type >= ScalarType::f32) {
      refuse_line(file, line, std::string("the length of a list cannot be a fraction") + kExportAgain);
    }
    type = take_token(values);
  }
  property.type = scalar_type(type, file, line);
  property.name = std::string(take_token(values));
  if (property.name.empty()) refuse_line(file, line, std::string("this property has no name") + kExportAgain);
  return property;
}

}  // namespace

bool PlyElement::has_list() const {
  return std::any_of(properties.begin(), properties.end(), [](const auto& p) { return p.list_count_type.has_value(); });
}

std::size_t PlyElement::least_bytes() const {
  std::size_t bytes = 0;
  for (const PlyProperty& property : properties) bytes += size_of(property.list_count_type.value_or(property.type));
  return bytes;
}

PlyHeader take_ply_header(std::string_view& bytes, const std::string& file) {
  PlyHeader header;
  bool has_format = false;
  TextLines lines(bytes);
  if (lines.next() != "ply") refuse(file, std::string("does not begin with a line \"ply\"") + kExportAgain);
  while (const auto line = lines.next()) {
    std::string_view values = *line;
    const std::string_view key = take_token(values);
    if (key == "comment" || key == "obj_info" || key.empty()) continue;
    if (key == "end_header") {
      if (!has_format) refuse(file, std::string("its PLY header names no format") + kExportAgain);
      header.lines = lines.number();
      bytes = lines.rest();
      return header;
    }
    if (key == "format") {
      header.format = format_of(values, file, lines.number());
      has_format = true;
    } else if (key == "element") {
      header.elements.push_back(element_of(values, file, lines.number()));
    } else if (key == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(property_of(values, file, lines.number()));
    } else {
      refuse_line(file, lines.number(), in_quotes(key) + " does not belong here in a PLY header" + kExportAgain);
    }
  }
  refuse(file, std::string("its PLY header has no end_header; the file is cut") + kExportAgain);
}

}  // namespace scanway::cloud_formats
