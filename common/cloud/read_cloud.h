#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "common/cloud/point_cloud.h"

namespace scanway {

/// What read_cloud() left out of a cloud, and why.
struct CloudNotes {
  std::size_t not_finite = 0;  ///< A coordinate was NaN or infinite.
  std::size_t no_return = 0;   ///< Marks of the scanner for "no return".

  /// "left out 12 points that are not finite"; empty when nothing was left out.
  std::string sentence() const;
};

/// The points of a cloud file, in metres and the file's right-handed frame, told by its content first and by its name's
/// end second; any of them may be compressed with zstd (`.zst`). docs/cloud-files.md says what of each format is read.
///   PCD 0.6, 0.7         ascii, binary, binary_compressed
///   PLY 1.0              ascii, binary of either byte order
///   VTK legacy           POINTS of any dataset, ASCII and BINARY
///   3DTK `.3d`           text in centimetres, left-handed (x right, y up, z forward): turned into metres, x forward,
///                        y left, z up. The scanner's no-return marks are left out.
///   `.xyz` `.txt` `.asc` text: x y z [intensity ...]
/// Points that are not finite are left out; an intensity that is not finite becomes 0. Throws InputError, one line that
/// names the place, for a file that is damaged or holds no point. Memory stays a small multiple of the file's size.
PointCloud read_cloud(const std::string& path, CloudNotes* notes = nullptr);

/// The same for a file that shall be a scan. Throws InputError for fewer than kMinScanPoints points too: they span no
/// surface, so there is nothing to register.
PointCloud read_scan(const std::string& path, CloudNotes* notes = nullptr);
constexpr std::size_t kMinScanPoints = 3;

/// What read_cloud() gives, from the bytes of such a file, not compressed; `path` stands for it.
PointCloud parse_cloud(std::string_view bytes, const std::string& path, CloudNotes* notes = nullptr);

/// The name of the scan in a file: without folder, `.zst` and the ends named above ("a/scan000.3d.zst": "scan000").
std::string scan_name(const std::string& path);

}  // namespace scanway
