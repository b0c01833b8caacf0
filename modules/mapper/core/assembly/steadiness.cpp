#include "modules/mapper/core/assembly/steadiness.h"

#include "common/geometry/pose.h"

namespace scanway {
namespace {

/// The mean of orientations that lie close together: the normalised sum of their quaternions on one side.
class MeanOrientation {
 public:
  void add(const Eigen::Quaterniond& q) {
    const Eigen::Vector4d v = q.coeffs();
    sum_ += sum_.dot(v) < 0.0 ? Eigen::Vector4d(-v) : v;
  }
  bool any() const { return sum_.squaredNorm() > 0.0; }
  Eigen::Quaterniond mean() const { return Eigen::Quaterniond(Eigen::Vector4d(sum_ / sum_.norm())); }

 private:
  Eigen::Vector4d sum_ = Eigen::Vector4d::Zero();
};

}  // namespace

Steadiness steadiness_of(const std::vector<Orientation>& orientations, Utime begin, Utime end) {
  Steadiness result;
  MeanOrientation all, second;
  std::optional<Eigen::Quaterniond> first_second;
  Utime second_begins = begin;
  const auto close_second = [&] {
    if (!second.any()) return;
    if (!first_second) first_second = second.mean();
    const double turn = rotation_angle((first_second->conjugate() * second.mean()).toRotationMatrix());
    result.largest_turn_rad = std::max(result.largest_turn_rad, turn);
    if (turn > kTurnIsMovement_rad && !result.moved) {
      result.moved = true;
      result.moved_at = second_begins;
    }
    second = MeanOrientation{};
  };
  for (const Orientation& orientation : orientations) {
    if (orientation.utime < begin || orientation.utime > end) continue;
    if (orientation.utime - second_begins >= kMicrosecondsPerSecond) {
      close_second();
      second_begins = orientation.utime;
    }
    second.add(orientation.R_world_base);
    all.add(orientation.R_world_base);
    ++result.orientations;
  }
  close_second();
  if (all.any()) result.R_world_base = all.mean();
  return result;
}

}  // namespace scanway
