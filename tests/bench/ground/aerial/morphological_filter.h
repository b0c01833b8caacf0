#pragma once

#include <vector>

#include "tests/bench/ground/aerial/sample.h"

namespace scanway::bench {

/// PCL's ProgressiveMorphologicalFilter (Zhang et al. 2003) with the parameters of PCL's tutorial, which is written for
/// samp11.
std::vector<bool> morphological_filter(const Sample& sample);

}  // namespace scanway::bench
