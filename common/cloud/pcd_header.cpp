#include "common/cloud/pcd_header.h"

#include <array>
#include <map>
#include <optional>

#include "common/cloud/cloud_formats.h"
#include "common/files/printable.h"
#include "common/files/text_lines.h"

namespace scanway::cloud_formats {
namespace {

/// The entries of the header by key: what follows each, and the line it stands in.
struct Entry {
  std::string_view values;
  std::size_t line = 0;
};
using Entries = std::map<std::string_view, Entry>;

bool is_key(std::string_view token) {
  constexpr std::array<std::string_view, 11> kKeys = {"VERSION", "FIELDS", "COLUMNS",   "SIZE",   "TYPE", "COUNT",
                                                      "WIDTH",   "HEIGHT", "VIEWPOINT", "POINTS", "DATA"};
  for (const std::string_view key : kKeys) {
    if (token == key) return true;
  }
  return false;
}

/// All entries up to and with DATA.
Entries take_entries(TextLines& lines, const std::string& file) {
  Entries entries;
  while (const auto line = lines.next()) {
    std::string_view values = *line;
    std::string_view key = take_token(values);
    if (key.empty() || key.starts_with('#')) continue;
    if (!is_key(key)) refuse_line(file, lines.number(), in_quotes(key) + " is no entry of a PCD header" + kExportAgain);
    if (key == "COLUMNS") key = "FIELDS";  // Its name before version 0.7.
    if (!entries.emplace(key, Entry{values, lines.number()}).second) {
      refuse_line(file, lines.number(), "the header has " + std::string(key) + " twice" + kExportAgain);
    }
    if (key == "DATA") return entries;
  }
  refuse(file, std::string("its PCD header ends without a DATA line; the file is cut") + kExportAgain);
}

const Entry& required(const Entries& entries, std::string_view key, const std::string& file) {
  const auto found = entries.find(key);
  if (found == entries.end()) refuse(file, "its PCD header has no " + std::string(key) + kExportAgain);
  return found->second;
}

std::optional<ScalarType> scalar_type(std::string_view letter, std::string_view size) {
  constexpr struct {
    std::string_view letter, size;
    ScalarType type;
  } kTypes[] = {{"F", "4", ScalarType::f32}, {"F", "8", ScalarType::f64}, {"I", "1", ScalarType::i8},
                {"I", "2", ScalarType::i16}, {"I", "4", ScalarType::i32}, {"I", "8", ScalarType::i64},
                {"U", "1", ScalarType::u8},  {"U", "2", ScalarType::u16}, {"U", "4", ScalarType::u32},
                {"U", "8", ScalarType::u64}};
  for (const auto& known : kTypes) {
    if (letter == known.letter && size == known.size) return known.type;
  }
  return std::nullopt;
}

std::vector<PcdField> fields_of(const Entries& entries, const std::string& file) {
  Entry names = required(entries, "FIELDS", file);
  Entry sizes = required(entries, "SIZE", file);
  Entry types = required(entries, "TYPE", file);
  Entry counts = entries.contains("COUNT") ? entries.at("COUNT") : Entry{};
  const std::size_t number = count_tokens(names.values);
  for (const Entry* entry : {&sizes, &types, &counts}) {
    if (entry->line == 0 || count_tokens(entry->values) == number) continue;
    refuse_line(file, entry->line,
                "this line has not one value for each of the " + std::to_string(number) + " FIELDS" + kExportAgain);
  }
  std::vector<PcdField> fields;
  while (fields.size() < number) {
    PcdField field{.name = std::string(take_token(names.values))};
    const std::string_view size = take_token(sizes.values);
    const std::string_view letter = take_token(types.values);
    const auto type = scalar_type(letter, size);
    if (!type) {
      refuse_line(file, types.line,
                  "field " + in_quotes(field.name) + " has the unknown TYPE " + in_quotes(letter) + " of SIZE " +
                      in_quotes(size) + kExportAgain);
    }
    field.type = *type;
    const auto count = counts.line == 0 ? std::optional<std::uint64_t>(1) : parse_count(take_token(counts.values));
    if (!count || *count > UINT32_MAX) {
      refuse_line(file, counts.line,
                  "field " + in_quotes(field.name) + " has no COUNT that makes sense" + kExportAgain);
    }
    field.count = *count;
    fields.push_back(std::move(field));
  }
  return fields;
}

std::uint64_t count_of(const Entries& entries, std::string_view key, const std::string& file) {
  Entry entry = required(entries, key, file);
  const std::string_view token = take_token(entry.values);
  const auto count = parse_count(token);
  if (!count) refuse_line(file, entry.line, in_quotes(token) + " is no number of points" + kExportAgain);
  return *count;
}

/// POINTS, or WIDTH times HEIGHT; both must agree where both are there.
std::uint64_t points_of(const Entries& entries, const std::string& file) {
  if (!entries.contains("WIDTH") && entries.contains("POINTS")) return count_of(entries, "POINTS", file);
  const std::uint64_t width = count_of(entries, "WIDTH", file);
  const std::uint64_t height = entries.contains("HEIGHT") ? count_of(entries, "HEIGHT", file) : 1;
  std::uint64_t product = 0;
  const bool overflow = __builtin_mul_overflow(width, height, &product);
  const std::uint64_t points = entries.contains("POINTS") ? count_of(entries, "POINTS", file) : product;
  if (overflow || product != points) {
    refuse(file, "its PCD header says WIDTH " + std::to_string(width) + ", HEIGHT " + std::to_string(height) +
                     " and POINTS " + std::to_string(points) + ", which do not fit together" + kExportAgain);
  }
  return points;
}

PcdData data_of(const Entries& entries, const std::string& file) {
  Entry entry = required(entries, "DATA", file);
  const std::string_view token = take_token(entry.values);
  if (token == "ascii") return PcdData::ascii;
  if (token == "binary") return PcdData::binary;
  if (token == "binary_compressed") return PcdData::binary_compressed;
  refuse_line(file, entry.line,
              "DATA " + in_quotes(token) + " is not known; write it as ascii, binary or binary_compressed");
}

}  // namespace

PcdHeader take_pcd_header(std::string_view& bytes, const std::string& file) {
  TextLines lines(bytes);
  const Entries entries = take_entries(lines, file);
  PcdHeader header;
  header.fields = fields_of(entries, file);
  for (PcdField& field : header.fields) {
    field.offset = header.point_bytes;
    field.index = header.point_numbers;
    header.point_bytes += field.bytes();  // At most 2^35 a field, and a field takes a byte of the file: no overflow.
    header.point_numbers += field.count;
  }
  header.points = points_of(entries, file);
  header.data = data_of(entries, file);
  header.lines = lines.number();
  bytes = lines.rest();
  return header;
}

}  // namespace scanway::cloud_formats
