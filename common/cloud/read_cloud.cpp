#include "common/cloud/read_cloud.h"

#include <array>
#include <cmath>
#include <filesystem>

#include "common/cloud/cloud_formats.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "common/files/read_file.h"
#include "common/files/text_lines.h"

namespace scanway {
namespace {

constexpr std::array<std::string_view, 7> kEndings = {".pcd", ".ply", ".vtk", ".3d", ".xyz", ".txt", ".asc"};

std::string lower_extension(const std::string& name) {
  std::string extension = std::filesystem::path(name).extension().string();
  for (char& c : extension) c = (c >= 'A' && c <= 'Z') ? static_cast<char>(c - 'A' + 'a') : c;
  return extension;
}

std::string without_extension(const std::string& name, std::string_view extension) {
  return name.substr(0, name.size() - extension.size());
}

std::string without_zst(const std::string& name) {
  return lower_extension(name) == ".zst" ? without_extension(name, ".zst") : name;
}

PointCloud read_any(std::string_view bytes, const std::string& path, CloudNotes& notes) {
  if (bytes.empty()) cloud_formats::refuse(path, "is empty (0 bytes); export the cloud again");
  if (bytes.starts_with("# .PCD")) return cloud_formats::read_pcd(bytes, path);
  if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return cloud_formats::read_ply(bytes, path);
  if (bytes.starts_with("# vtk DataFile")) return cloud_formats::read_vtk(bytes, path);
  const std::string extension = lower_extension(without_zst(path));
  if (extension == ".pcd") return cloud_formats::read_pcd(bytes, path);
  if (extension == ".ply") return cloud_formats::read_ply(bytes, path);
  if (extension == ".vtk") return cloud_formats::read_vtk(bytes, path);
  if (extension == ".3d") return cloud_formats::read_3dtk(bytes, path, notes);
  if (extension == ".xyz" || extension == ".txt" || extension == ".asc") return cloud_formats::read_xyz(bytes, path);
  cloud_formats::refuse(path, "is no cloud that Scanway reads; give a .pcd, .ply, .vtk, .3d, .xyz, .txt or .asc file");
}

/// Leaves out the points that are not finite, in place.
void keep_finite(PointCloud& cloud, CloudNotes& notes) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f& p = cloud.points[i];
    if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z())) continue;
    cloud.points[kept] = p;
    if (!cloud.intensity.empty()) cloud.intensity[kept] = std::isfinite(cloud.intensity[i]) ? cloud.intensity[i] : 0.0f;
    ++kept;
  }
  notes.not_finite += cloud.size() - kept;
  cloud.points.resize(kept);
  if (!cloud.intensity.empty()) cloud.intensity.resize(kept);
}

}  // namespace

std::string CloudNotes::sentence() const {
  std::string text;
  if (not_finite > 0) text = "left out " + std::to_string(not_finite) + " points that are not finite";
  if (no_return > 0) {
    text += (text.empty() ? "left out " : ", and ") + std::to_string(no_return) + " marks of no return";
  }
  return text;
}

PointCloud read_scan(const std::string& path, CloudNotes* notes) {
  PointCloud cloud = read_cloud(path, notes);
  if (cloud.size() >= kMinScanPoints) return cloud;
  throw InputError(printable(path) + ": a scan of only " + std::to_string(cloud.size()) +
                   (cloud.size() == 1 ? " point" : " points") + "; record it again, or leave it out");
}

PointCloud read_cloud(const std::string& path, CloudNotes* notes) {
  return parse_cloud(read_file_decompressed(path), path, notes);
}

PointCloud parse_cloud(std::string_view bytes, const std::string& path, CloudNotes* notes) {
  CloudNotes own;
  CloudNotes& noted = notes != nullptr ? *notes : own;
  noted = {};
  PointCloud cloud = read_any(bytes, path, noted);
  if (cloud.empty() && noted.no_return == 0) cloud_formats::refuse(path, "holds no point; export the cloud again");
  const std::size_t points = cloud.size();
  keep_finite(cloud, noted);
  if (cloud.empty()) {
    cloud_formats::refuse(path, "holds no finite point (" + std::to_string(points) + " points, " + noted.sentence() +
                                    "); export the cloud again");
  }
  return cloud;
}

std::string scan_name(const std::string& path) {
  const std::string name = without_zst(std::filesystem::path(path).filename().string());
  const std::string extension = lower_extension(name);
  for (const std::string_view ending : kEndings) {
    if (extension == ending) return without_extension(name, ending);
  }
  return name;
}

namespace cloud_formats {

void refuse(const std::string& file, const std::string& problem) { throw InputError(printable(file) + ": " + problem); }

void refuse_line(const std::string& file, std::size_t line, const std::string& problem) {
  throw InputError(printable(file) + ":" + std::to_string(line) + ": " + problem);
}

float parse_coordinate(std::string_view token, const std::string& file, std::size_t line) {
  const std::optional<double> value = parse_number(token);
  if (!value) refuse_line(file, line, in_quotes(token) + " is not a number; export the cloud again");
  return static_cast<float>(*value);
}

}  // namespace cloud_formats
}  // namespace scanway
