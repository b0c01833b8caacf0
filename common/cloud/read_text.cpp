#include <array>
#include <optional>

#include "common/cloud/cloud_formats.h"
#include "common/files/printable.h"
#include "common/files/text_lines.h"

namespace scanway::cloud_formats {
namespace {

bool is_comment(std::string_view token) { return token.starts_with('#') || token.starts_with("//"); }

/// One point a line, the same number of columns in all of them. A fourth column that is the last is the intensity;
/// of more columns nobody knows what they are.
PointCloud read_columns(std::string_view bytes, const std::string& file) {
  PointCloud cloud;
  std::size_t columns = 0;
  TextLines lines(bytes);
  while (const auto line = lines.next()) {
    std::string_view rest = *line;
    std::array<float, 4> values{};
    std::size_t count = 0;
    for (std::string_view token = take_token(rest); !token.empty(); token = take_token(rest), ++count) {
      if (count == 0 && is_comment(token)) break;
      const float value = parse_coordinate(token, file, lines.number());
      if (count < 4) values[count] = value;
    }
    if (count == 0) continue;
    if (columns == 0) columns = count;
    if (count < 3 || count != columns) {
      refuse_line(file, lines.number(),
                  "this line has " + std::to_string(count) + " numbers in place of " +
                      (columns < 3 ? "x y z" : std::to_string(columns)) +
                      "; the file is cut or damaged, export it again");
    }
    cloud.points.emplace_back(values[0], values[1], values[2]);
    if (columns == 4) cloud.intensity.push_back(values[3]);
  }
  return cloud;
}

/// 3DTK's scanners count ranges in millimetres in 16 bits: one without a return is stored at the largest, 32,767 mm, or
/// at the scanner itself.
bool is_no_return(const Eigen::Vector3f& p) {
  const float range_m = p.norm();
  return range_m < 0.30f || (range_m > 32.7f && range_m < 32.8f);
}

}  // namespace

PointCloud read_xyz(std::string_view bytes, const std::string& file) { return read_columns(bytes, file); }

PointCloud read_3dtk(std::string_view bytes, const std::string& file, CloudNotes& notes) {
  const PointCloud raw = read_columns(bytes, file);
  PointCloud cloud;
  cloud.points.reserve(raw.size());
  cloud.intensity.reserve(raw.intensity.size());
  for (std::size_t i = 0; i < raw.size(); ++i) {
    const Eigen::Vector3f& q = raw.points[i];  // Centimetres: x right, y up, z forward.
    const Eigen::Vector3f p = Eigen::Vector3f(q.z(), -q.x(), q.y()) / 100.0f;
    if (is_no_return(p)) {
      ++notes.no_return;
      continue;
    }
    cloud.points.push_back(p);
    if (!raw.intensity.empty()) cloud.intensity.push_back(raw.intensity[i]);
  }
  return cloud;
}

}  // namespace scanway::cloud_formats
