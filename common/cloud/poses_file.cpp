#include "common/cloud/poses_file.h"

#include <array>
#include <cmath>

#include "common/cloud/cloud_formats.h"
#include "common/cloud/read_cloud.h"
#include "common/files/printable.h"
#include "common/files/read_file.h"
#include "common/files/text_lines.h"

namespace scanway {
namespace {

using cloud_formats::refuse_line;

constexpr double kRotationTolerance = 1e-3;

bool is_rotation(const Eigen::Matrix3d& R) {
  const Eigen::Matrix3d off = R.transpose() * R - Eigen::Matrix3d::Identity();
  return off.cwiseAbs().maxCoeff() <= kRotationTolerance && R.determinant() > 0.0;
}

/// The 12 numbers after a name.
Pose parse_pose(std::string_view values, const std::string& path, std::size_t line) {
  const std::size_t count = count_tokens(values);
  if (count != 12) {
    refuse_line(path, line,
                std::to_string(count) +
                    " numbers follow the name in place of 12; write the line as `name "
                    "r00 r01 r02 tx r10 r11 r12 ty r20 r21 r22 tz`");
  }
  Pose X_ref_scan = Pose::Identity();
  for (int i = 0; i < 12; ++i) {
    const std::string_view token = take_token(values);
    const auto value = parse_number(token);
    if (!value || !std::isfinite(*value))
      refuse_line(path, line, in_quotes(token) + " is not a finite number; correct it");
    X_ref_scan.matrix()(i / 4, i % 4) = *value;
  }
  if (!is_rotation(X_ref_scan.linear())) {
    refuse_line(path, line, "its 3x3 part is no rotation within 0.001; check the order of the numbers (row-major 3x4)");
  }
  return X_ref_scan;
}

}  // namespace

PosesFile PosesFile::read(const std::string& path) { return parse(read_file(path), path); }

PosesFile PosesFile::parse(std::string_view text, const std::string& path) {
  PosesFile file;
  file.path_ = path;
  TextLines lines(text);
  while (const auto line = lines.next()) {
    std::string_view values = line->substr(0, line->find('#'));
    const std::string_view name = take_token(values);
    if (name.empty()) continue;
    const Pose X_ref_scan = parse_pose(values, path, lines.number());
    if (!file.poses_.emplace(scan_name(std::string(name)), X_ref_scan).second) {
      refuse_line(path, lines.number(), "the scan " + in_quotes(name) + " is there twice; remove one of its lines");
    }
  }
  return file;
}

const Pose& PosesFile::pose_of(const std::string& scan) const {
  const auto found = poses_.find(scan_name(scan));
  if (found != poses_.end()) return found->second;
  cloud_formats::refuse(path_, "has no line for the scan " + in_quotes(scan) + "; add one, or leave that scan out");
}

}  // namespace scanway
