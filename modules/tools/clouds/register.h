#pragma once

#include <array>
#include <optional>
#include <string>

namespace scanway::tools {

struct RegisterOptions {
  std::string source;
  std::string target;
  std::optional<std::array<double, 4>> orientation_wxyz;  ///< R_target_source as a tracker would give it.
  bool json = false;
};

/// `scanway register`: the pose of one cloud in another's frame, with a verdict. Returns 0 whatever the verdict.
/// Throws InputError.
int run_register(const RegisterOptions& options);

}  // namespace scanway::tools
