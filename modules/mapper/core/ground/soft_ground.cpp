#include "modules/mapper/core/ground/soft_ground.h"

#include <algorithm>

#include "common/math/repeatable.h"

namespace scanway {
namespace {

constexpr double kRoughest = 1.6;  // deviations of the range: mown grass; edges are rougher, but so are blades
constexpr double kTrusted = 20.0;  // points: a roughness of so many counts for half
constexpr double kMostOdds = 8.0;  // log: a single patch does not outvote all around it

Softness softness_of(double log_odds) {
  if (log_odds >= SoftGround::kMargin) return Softness::soft;
  return log_odds <= -SoftGround::kMargin ? Softness::hard : Softness::unknown;
}

}  // namespace

SoftGroundModel::Values SoftGroundModel::values_of(const GroundPatch& patch, double range_sigma_m) {
  const double flat = repeatable::log(patch.cosine);
  const double trust = patch.points / (patch.points + kTrusted);
  const double rough = trust * repeatable::log(std::clamp(patch.roughness_m / range_sigma_m, 0.5, kRoughest));
  return {1.0,         repeatable::log(std::max(patch.intensity, 1.0)), patch.range_m / 10.0, flat, flat * flat, rough,
          rough * flat};
}

double SoftGroundModel::log_odds(const GroundPatch& patch, double range_sigma_m) const {
  const Values values = values_of(patch, range_sigma_m);
  double sum = 0.0;
  for (int i = 0; i < kValues; ++i) sum += weights[i] * values[i];
  return std::clamp(sum, -kMostOdds, kMostOdds);
}

SoftGround::SoftGround(const GroundPatches& patches, double range_sigma_m, const SoftGroundModel& model) {
  std::map<Cell, double> odds;
  for (const auto& [place, patch] : patches.all()) odds.emplace(place, model.log_odds(patch, range_sigma_m));
  for (const auto& [place, own] : odds) {
    double sum = 0.0;
    int count = 0;
    for (int i = 0; i < 9; ++i) {
      const auto other = odds.find({place.x + i % 3 - 1, place.y + i / 3 - 1});
      if (other != odds.end()) sum += other->second, ++count;
    }
    softness_.emplace(place, softness_of((own + sum / count) / 2));
  }
}

Softness SoftGround::at(double x, double y) const {
  const auto found = softness_.find(GroundPatches::place_of(x, y));
  return found != softness_.end() ? found->second : Softness::unknown;
}

}  // namespace scanway
