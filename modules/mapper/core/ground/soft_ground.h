#pragma once

#include <array>
#include <map>

#include "modules/mapper/core/ground/ground_patches.h"

namespace scanway {

/// How a patch's remission and roughness speak for grass, as log odds: the logistic regression of what the patch shows,
/// after Wurm, Kümmerle, Stachniss and Burgard, "Improving robot navigation in structured outdoor environments by
/// identifying vegetation from laser data" (IROS 2009), who let a support vector machine find the border in the same
/// values: remission, range, angle of incidence.
///
/// What a scanner counts as intensity is its own, so the weights hold for one kind. These are of the simulated LMS500
/// (tests/bench/ground/vegetation prints them); another scanner needs its own.
struct SoftGroundModel {
  /// Of: 1, log intensity, range / 10 m, log cosine, its square, log of the roughness over the range's deviation (the
  /// less, the fewer points it is from), and this once more times log cosine: far out unevenness counts as roughness.
  static constexpr int kValues = 7;
  using Values = std::array<double, kValues>;
  Values weights = {-336.234, 64.277, 5.724, -29.028, -3.882, 41.011, 18.105};

  static Values values_of(const GroundPatch& patch, double range_sigma_m);
  double log_odds(const GroundPatch& patch, double range_sigma_m) const;
};

enum class Softness {
  unknown,  ///< Not seen well enough, or neither for sure.
  hard,
  soft,
};

/// Where one sweep shows low, soft vegetation. A patch is what its own log odds and those of the patches around it on
/// an average say, where they say it by a margin.
class SoftGround {
 public:
  static constexpr double kMargin = 2.2;  ///< Log odds: nine to one.

  SoftGround(const GroundPatches& patches, double range_sigma_m, const SoftGroundModel& model = {});

  Softness at(double x, double y) const;
  const std::map<Cell, Softness>& all() const { return softness_; }  ///< By GroundPatches::place_of.

 private:
  std::map<Cell, Softness> softness_;
};

}  // namespace scanway
