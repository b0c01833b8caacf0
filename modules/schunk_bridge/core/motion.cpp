#include "modules/schunk_bridge/core/motion.h"

#include <algorithm>
#include <cmath>

#include "common/math/angle.h"
#include "modules/schunk_bridge/core/protocol.h"

namespace scanway::schunk {
namespace {

constexpr double kTolerance = radians(0.25L);
/// A state from before the movement may come after the module took the command.
constexpr Utime kStartTime = 500'000;
/// A reference run may stand for a moment between two of its parts.
constexpr Utime kStandInReference = 3'000'000;
constexpr Utime kReferenceTime = 120'000'000;
/// A movement that claims to move must get this share of its way in this time.
constexpr Utime kProgressTime = 2'000'000;
constexpr double kProgressShare = 0.05;

Utime to_utime(double seconds) {
  return static_cast<Utime>(std::clamp(seconds, 0.0, 1e6) * static_cast<double>(kMicrosecondsPerSecond));
}

}  // namespace

void Motion::begin(Kind kind, double target, double speed) {
  *this = Motion();
  kind_ = kind;
  outcome_ = Outcome::under_way;
  target_ = target;
  speed_ = speed;
}

void Motion::accept(std::optional<double> seconds, double position, Utime now) {
  accepted_ = now;
  stood_since_ = now;
  progress_position_ = position;
  progress_time_ = now;
  const double expected = std::max(seconds.value_or(0.0), std::fabs(target_ - position) / std::max(speed_, 1e-6));
  deadline_ = now + (kind_ == Kind::reference ? kReferenceTime : to_utime(1.5 * expected + 3.0));
}

Motion::Change Motion::observe(double position, std::uint8_t bits, Utime now) {
  if (!under_way() || !accepted_) return Change::nothing;
  if ((bits & state_bit::kMoving) == 0) return judge_stand(position, bits, now);
  seen_moving_ = true;
  stood_since_ = now;
  if (kind_ != Kind::velocity && now > deadline_) return end(Change::overdue);
  return kind_ == Kind::reference ? Change::nothing : judge_progress(position, now);
}

Motion::Change Motion::judge_stand(double position, std::uint8_t bits, Utime now) {
  const bool settled = seen_moving_ || now - *accepted_ > kStartTime;
  switch (kind_) {
    case Kind::none:
      return Change::nothing;
    case Kind::position:
      if (near_target(position)) return end(Change::reached);
      return settled ? end(Change::blocked) : Change::nothing;
    case Kind::velocity:
      return settled ? end(Change::blocked) : Change::nothing;
    case Kind::reference:
      if (settled && (bits & state_bit::kReferenced)) return end(Change::reached);
      return now - stood_since_ > kStandInReference ? end(Change::blocked) : Change::nothing;
  }
  return Change::nothing;
}

Motion::Change Motion::judge_progress(double position, Utime now) {
  const double least = kProgressShare * speed_ * to_seconds(kProgressTime);
  if (std::fabs(position - progress_position_) >= least) {
    progress_position_ = position;
    progress_time_ = now;
  }
  return now - progress_time_ > kProgressTime ? end(Change::stuck) : Change::nothing;
}

Motion::Change Motion::announce_stand(double position) {
  // The end of a reference run is judged by the state, which says whether the axis is referenced.
  if (!under_way() || !accepted_ || kind_ == Kind::reference) return Change::nothing;
  return end(kind_ == Kind::position && near_target(position) ? Change::reached : Change::blocked);
}

void Motion::fail() {
  if (under_way()) outcome_ = Outcome::failed;
}

Motion::Change Motion::end(Change change) {
  outcome_ = change == Change::reached ? Outcome::reached : Outcome::blocked;
  return change;
}

bool Motion::near_target(double position) const { return std::fabs(position - target_) <= kTolerance; }

}  // namespace scanway::schunk
