#include <algorithm>
#include <array>
#include <cstring>

#include "common/cloud/cloud_formats.h"
#include "common/cloud/lzf.h"
#include "common/cloud/pcd_header.h"
#include "common/cloud/scalar_columns.h"
#include "common/files/printable.h"
#include "common/files/text_lines.h"

namespace scanway::cloud_formats {
namespace {

CloudFields fields_of(const PcdHeader& header, const std::string& file) {
  std::vector<std::string> names;
  for (const PcdField& field : header.fields) names.push_back(field.name);
  CloudFields fields = choose_fields(names, file);
  for (const std::size_t index : fields.xyz) {
    if (header.fields[index].count == 1) continue;
    refuse(file, "field " + names[index] + " has COUNT " + std::to_string(header.fields[index].count) +
                     " in place of 1; export the cloud again");
  }
  if (fields.intensity && header.fields[*fields.intensity].count != 1) fields.intensity.reset();
  return fields;
}

[[noreturn]] void refuse_length(const PcdHeader& header, const std::string& file, std::uint64_t there) {
  refuse(file, "promises " + std::to_string(header.points) + " points of " + std::to_string(header.point_bytes) +
                   " bytes, but " + std::to_string(there) +
                   " bytes follow its header; it is cut or damaged, copy it again");
}

/// Points that lie `stride(field)` bytes apart, each field's first at `begin(field)`.
template <class Begin, class Stride>
PointCloud gather(const PcdHeader& header, const CloudFields& chosen, const Begin& begin, const Stride& stride) {
  const auto column = [&](std::size_t index) {
    const PcdField& field = header.fields[index];
    return ScalarColumn{begin(field), stride(field), field.type, false};
  };
  const ScalarColumn intensity = chosen.intensity ? column(*chosen.intensity) : ScalarColumn{};
  return gather_columns(header.points, {column(chosen.xyz[0]), column(chosen.xyz[1]), column(chosen.xyz[2])},
                        chosen.intensity ? &intensity : nullptr);
}

PointCloud read_binary(const PcdHeader& header, const CloudFields& chosen, std::string_view bytes,
                       const std::string& file) {
  if (header.points > bytes.size() / header.point_bytes) refuse_length(header, file, bytes.size());
  return gather(
      header, chosen, [&](const PcdField& field) { return bytes.data() + field.offset; },
      [&](const PcdField&) { return header.point_bytes; });
}

/// Two lengths (uint32: compressed, then not compressed) and LZF data of the fields one after the other.
PointCloud read_compressed(const PcdHeader& header, const CloudFields& chosen, std::string_view bytes,
                           const std::string& file) {
  std::array<std::uint32_t, 2> lengths{};
  if (bytes.size() < sizeof(lengths)) refuse(file, "ends within its header; it is cut, copy it again");
  std::memcpy(lengths.data(), bytes.data(), sizeof(lengths));
  bytes.remove_prefix(sizeof(lengths));
  if (lengths[0] > bytes.size()) {
    refuse(file, "promises " + std::to_string(lengths[0]) + " bytes of compressed points, but " +
                     std::to_string(bytes.size()) + " follow; it is cut, copy it again");
  }
  const bool fits = header.points == lengths[1] / header.point_bytes && lengths[1] % header.point_bytes == 0;
  if (!fits) refuse_length(header, file, lengths[1]);
  if (lengths[1] > lengths[0] * kLzfMaxExpansion) refuse(file, "its compressed points are damaged; copy it again");
  std::string raw(lengths[1], '\0');
  if (!lzf_decompress(bytes.substr(0, lengths[0]), raw.data(), raw.size())) {
    refuse(file, "its compressed points are damaged; copy it again");
  }
  return gather(
      header, chosen, [&](const PcdField& field) { return raw.data() + field.offset * header.points; },
      [&](const PcdField& field) { return field.bytes(); });
}

/// One point a line. The numbers of a line that nobody needs are counted, not read.
class AsciiPoint {
 public:
  AsciiPoint(const PcdHeader& header, const CloudFields& chosen) : numbers_(header.point_numbers) {
    for (std::size_t axis = 0; axis < 3; ++axis) wanted_[axis] = header.fields[chosen.xyz[axis]].index;
    wanted_[3] = chosen.intensity ? header.fields[*chosen.intensity].index : numbers_;
  }

  /// x, y, z and, if the file has it, intensity.
  std::array<float, 4> parse(std::string_view line, const std::string& file, std::size_t number) const {
    std::array<float, 4> values{};
    std::size_t index = 0;
    for (std::string_view token = take_token(line); !token.empty(); token = take_token(line), ++index) {
      const auto place = std::find(wanted_.begin(), wanted_.end(), index);
      if (place == wanted_.end() || index >= numbers_) continue;
      values[static_cast<std::size_t>(place - wanted_.begin())] = parse_coordinate(token, file, number);
    }
    if (index != numbers_) {
      refuse_line(file, number,
                  "this point has " + std::to_string(index) + " numbers in place of " + std::to_string(numbers_) +
                      "; the file is cut or damaged, export it again");
    }
    return values;
  }

 private:
  std::size_t numbers_;
  std::array<std::size_t, 4> wanted_{};
};

PointCloud read_ascii(const PcdHeader& header, const CloudFields& chosen, std::string_view bytes,
                      const std::string& file) {
  const AsciiPoint point(header, chosen);
  PointCloud cloud;
  const std::size_t most = std::min<std::uint64_t>(header.points, bytes.size() / 6 + 1);  // "0 0 0\n"
  cloud.points.reserve(most);
  if (chosen.intensity) cloud.intensity.reserve(most);
  TextLines lines(bytes, header.lines);
  while (const auto line = lines.next()) {
    if (is_blank(*line)) continue;
    const std::size_t number = lines.number();
    if (cloud.size() == header.points) {
      refuse_line(file, number, "there are more points than the header's POINTS; export the cloud again");
    }
    const std::array<float, 4> values = point.parse(*line, file, number);
    cloud.points.emplace_back(values[0], values[1], values[2]);
    if (chosen.intensity) cloud.intensity.push_back(values[3]);
  }
  if (cloud.size() < header.points) {
    refuse(file, "promises " + std::to_string(header.points) + " points and holds " + std::to_string(cloud.size()) +
                     "; it is cut, copy it again");
  }
  return cloud;
}

}  // namespace

PointCloud read_pcd(std::string_view bytes, const std::string& file) {
  const PcdHeader header = take_pcd_header(bytes, file);
  const CloudFields chosen = fields_of(header, file);
  if (header.points == 0) return {};
  switch (header.data) {
    case PcdData::ascii:
      return read_ascii(header, chosen, bytes, file);
    case PcdData::binary:
      return read_binary(header, chosen, bytes, file);
    case PcdData::binary_compressed:
      break;
  }
  return read_compressed(header, chosen, bytes, file);
}

}  // namespace scanway::cloud_formats
