#pragma once

#include <string>
#include <string_view>

#include "common/cloud/point_cloud.h"
#include "common/cloud/read_cloud.h"

/// The readers behind read_cloud(), one a format: `bytes` of a file, whose path `file` is for messages. They give every
/// point, finite or not, and throw InputError.
namespace scanway::cloud_formats {

PointCloud read_pcd(std::string_view bytes, const std::string& file);
PointCloud read_ply(std::string_view bytes, const std::string& file);
PointCloud read_vtk(std::string_view bytes, const std::string& file);
PointCloud read_xyz(std::string_view bytes, const std::string& file);
PointCloud read_3dtk(std::string_view bytes, const std::string& file, CloudNotes& notes);

/// What to do about a damaged header: the end of a problem.
inline constexpr const char* kExportAgain = "; export the cloud again";

/// Throws the InputError "file: problem".
[[noreturn]] void refuse(const std::string& file, const std::string& problem);
/// Throws the InputError "file:line: problem".
[[noreturn]] void refuse_line(const std::string& file, std::size_t line, const std::string& problem);

/// parse_number() of a coordinate in a text file; throws InputError that names the line.
float parse_coordinate(std::string_view token, const std::string& file, std::size_t line);

}  // namespace scanway::cloud_formats
