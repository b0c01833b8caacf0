#pragma once

#include <array>

#include "modules/mapper/core/registration/normals.h"

namespace scanway::registration {

constexpr int kFpfhBins = 33;  ///< Three angles of 11 bins each.
using Fpfh = std::array<float, kFpfhBins>;

/// Fast point feature histograms: Rusu, Blodow, Beetz: Fast Point Feature Histograms (FPFH) for 3D Registration, ICRA
/// 2009, with the conventions of PCL's FPFHEstimation: each third sums to 100, pairs weigh 1 / d^2 in the second pass.
/// Points without a normal are left out; a point without any pair has a histogram of zeros.
std::vector<Fpfh> compute_fpfh(const Points& points, const Normals& normals, const Neighbourhoods& neighbourhoods);

}  // namespace scanway::registration
