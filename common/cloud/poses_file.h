#pragma once

#include <map>
#include <string>
#include <string_view>

#include "common/geometry/pose.h"

namespace scanway {

/// Poses of scans, from a text file: one line a scan,
///   name r00 r01 r02 tx r10 r11 r12 ty r20 r21 r22 tz
/// row-major [R|t], p_ref = R p_scan + t, metres; `#` begins a comment. The numbers are used as printed: R is not made
/// orthonormal again.
class PosesFile {
 public:
  /// Throws InputError with file and line for a line without its 12 numbers, a number that is not finite, an R that is
  /// no rotation within 1e-3, and a name that is there twice.
  static PosesFile read(const std::string& path);
  /// The same from text; `path` stands for the file in messages.
  static PosesFile parse(std::string_view text, const std::string& path);

  /// X_ref_scan. Names are compared as scan_name() gives them. Throws InputError when the file has no such line.
  const Pose& pose_of(const std::string& scan) const;
  std::size_t size() const { return poses_.size(); }

 private:
  std::string path_;
  std::map<std::string, Pose> poses_;
};

}  // namespace scanway
