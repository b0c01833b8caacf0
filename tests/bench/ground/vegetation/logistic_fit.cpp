#include "tests/bench/ground/vegetation/logistic_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace scanway::bench {

SoftGroundModel fit_model(const std::vector<JudgedPatch>& patches, double range_sigma_m) {
  constexpr int n = SoftGroundModel::kValues;
  using Vector = Eigen::Matrix<double, n, 1>;
  using Matrix = Eigen::Matrix<double, n, n>;
  const double grass =
      static_cast<double>(std::count_if(patches.begin(), patches.end(), [](const auto& p) { return p.grass(); }));
  const double other = static_cast<double>(patches.size()) - grass;
  Vector w = Vector::Zero();
  for (int round = 0; round < 30; ++round) {
    Vector gradient = -1e-7 * w;
    Matrix hessian = 1e-7 * Matrix::Identity();
    for (const JudgedPatch& patch : patches) {
      const SoftGroundModel::Values values = SoftGroundModel::values_of(patch.patch, range_sigma_m);
      const Vector x = Eigen::Map<const Vector>(values.data());
      const double p = 1.0 / (1.0 + std::exp(-w.dot(x)));
      const double weight = patch.grass() ? 0.5 / grass : 0.5 / other;
      gradient += weight * ((patch.grass() ? 1.0 : 0.0) - p) * x;
      hessian += weight * p * (1.0 - p) * x * x.transpose();
    }
    w += hessian.ldlt().solve(gradient);
  }
  SoftGroundModel model;
  for (int i = 0; i < n; ++i) model.weights[i] = w[i];
  return model;
}

}  // namespace scanway::bench
