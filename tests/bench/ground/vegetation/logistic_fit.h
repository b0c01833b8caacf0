#pragma once

#include <vector>

#include "tests/bench/ground/vegetation/judged_patches.h"

namespace scanway::bench {

/// The weights under which what the patches are is most probable, grass and all else counting for the same; by Newton's
/// method, drawn towards 0 a little so that there is one answer.
SoftGroundModel fit_model(const std::vector<JudgedPatch>& patches, double range_sigma_m);

}  // namespace scanway::bench
