#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace scanway::tools {

struct ImportCloudsOptions {
  std::vector<std::string> files;
  std::string poses;        ///< Reference poses; empty: none.
  std::string orientation;  ///< Orientations of the same form, when there are no reference poses; empty: none.
  std::string output;
  std::string robot;  ///< Robot file; empty: the built-in ERA-Mobi.
  double heading_sigma_deg = 0.0;
  double tilt_sigma_deg = 0.0;
  std::uint64_t seed = 1;
  std::optional<double> sensor_height_m;
  std::optional<std::pair<double, double>> goal_m;  ///< In the map frame.
};

/// `scanway import clouds`: a log of sweeps from cloud files. Throws InputError; no log is left then.
int run_import_clouds(const ImportCloudsOptions& options);

}  // namespace scanway::tools
