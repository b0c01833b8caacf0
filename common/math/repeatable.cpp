#include "common/math/repeatable.h"

#include <array>
#include <cmath>
#include <limits>

namespace scanway::repeatable {
namespace {

constexpr double kLn2High = 0x1.62e42feep-1;  // the first 33 bits of ln 2: k * kLn2High is exact for |k| < 2^20
constexpr double kLn2Low = 0x1.a39ef35793c76p-33;
constexpr double kHalfPiHigh = 0x1.921fb544p0;  // the first 33 bits of pi/2, then the next 33, then the rest
constexpr double kHalfPiMiddle = 0x1.0b4611a6p-34;
constexpr double kHalfPiLow = 0x1.3198a2e037073p-69;

/// Taylor series of sin and cos on [-pi/4, pi/4].
double sin_series(double x) {
  const double z = x * x;
  double s = 0.0;
  for (int n = 17; n >= 3; n -= 2) s = -z / (n * (n - 1)) * (1.0 + s);
  return x + x * s;
}

double cos_series(double x) {
  const double z = x * x;
  double s = 0.0;
  for (int n = 18; n >= 2; n -= 2) s = -z / (n * (n - 1)) * (1.0 + s);
  return 1.0 + s;
}

/// x less the nearest multiple of pi/2; `quadrant` says which (modulo 4).
double reduce(double x, int& quadrant) {
  const double k = std::floor(x / (kPi / 2) + 0.5);
  quadrant = static_cast<int>(static_cast<long long>(k) & 3);
  return ((x - k * kHalfPiHigh) - k * kHalfPiMiddle) - k * kHalfPiLow;
}

double sin_quadrant(double r, int quadrant) {
  switch (quadrant & 3) {
    case 0:
      return sin_series(r);
    case 1:
      return cos_series(r);
    case 2:
      return -sin_series(r);
    default:
      return -cos_series(r);
  }
}

/// atan on [0, 1]: by the addition theorem to within 1/16 of a tabled angle, then by its series.
double atan_unit(double x) {
  constexpr std::array<double, 9> kAngles = {0.0,
                                             0.12435499454676144,
                                             0.24497866312686414,
                                             0.35877067027057225,
                                             0.46364760900080609,
                                             0.55859931534356244,
                                             0.64350110879328437,
                                             0.71882999962162453,
                                             0.78539816339744828};  // atan(k / 8)
  const int k = static_cast<int>(x * 8.0 + 0.5);
  const double c = k / 8.0;
  const double t = (x - c) / (1.0 + x * c);
  const double z = t * t;
  double s = 0.0;
  for (int n = 15; n >= 3; n -= 2) s = -z * (1.0 / n + s);
  return kAngles[static_cast<std::size_t>(k)] + (t + t * s);
}

}  // namespace

double sin(double x) {
  int quadrant = 0;
  const double r = reduce(x, quadrant);
  return sin_quadrant(r, quadrant);
}

double cos(double x) {
  int quadrant = 0;
  const double r = reduce(x, quadrant);
  return sin_quadrant(r, quadrant + 1);
}

double atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return std::numeric_limits<double>::quiet_NaN();
  const double ax = std::fabs(x), ay = std::fabs(y);
  if (ax == 0.0 && ay == 0.0) return 0.0;
  double angle = ay <= ax ? atan_unit(ay / ax) : kPi / 2 - atan_unit(ax / ay);
  if (x < 0.0) angle = kPi - angle;
  return y < 0.0 ? -angle : angle;
}

double exp(double x) {
  if (std::isnan(x)) return x;
  if (x > 709.78) return std::numeric_limits<double>::infinity();
  if (x < -745.2) return 0.0;
  const double k = std::floor(x / (kLn2High + kLn2Low) + 0.5);
  const double r = (x - k * kLn2High) - k * kLn2Low;
  double s = 1.0;
  for (int n = 14; n >= 1; --n) s = 1.0 + r / n * s;
  return std::ldexp(s, static_cast<int>(k));
}

double log(double x) {
  if (std::isnan(x) || x < 0.0) return std::numeric_limits<double>::quiet_NaN();
  if (x == 0.0) return -std::numeric_limits<double>::infinity();
  if (std::isinf(x)) return x;
  int k = 0;
  double m = std::frexp(x, &k);
  if (m < 0.70710678118654752) {
    m *= 2.0;
    --k;
  }
  const double t = (m - 1.0) / (m + 1.0);
  const double z = t * t;
  double s = 0.0;
  for (int n = 23; n >= 3; n -= 2) s = z * (1.0 / n + s);
  return k * kLn2High + ((2.0 * t + 2.0 * t * s) + k * kLn2Low);
}

}  // namespace scanway::repeatable
