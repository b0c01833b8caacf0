#pragma once

#include <cstdint>
#include <optional>

#include "common/time/utime.h"

namespace scanway::schunk {

/// A movement of an axis, from the command to its end, judged by the states that come in. Modules announce the end of a
/// move, too; but announcements can be switched off, and states come anyway.
class Motion {
 public:
  enum class Kind : std::uint8_t { none, reference, position, velocity };
  enum class Outcome : std::uint8_t { none, under_way, reached, blocked, failed };
  enum class Change : std::uint8_t { nothing, reached, blocked, stuck, overdue };

  void begin(Kind kind, double target, double speed);
  /// The module took the command. `seconds`: how long it will take, if the module said so.
  void accept(std::optional<double> seconds, double position, Utime now);
  /// Where the axis is, and its state bits. Returns how that ends the movement, if it does.
  Change observe(double position, std::uint8_t bits, Utime now);
  /// The module announces that the axis stands at `position`.
  Change announce_stand(double position);
  /// The movement is over for another reason: a stop, an error, a refusal, a silence.
  void fail();

  Kind kind() const { return kind_; }
  Outcome outcome() const { return outcome_; }
  bool under_way() const { return outcome_ == Outcome::under_way; }
  bool accepted() const { return accepted_.has_value(); }
  double target() const { return target_; }

 private:
  Change end(Change change);
  Change judge_stand(double position, std::uint8_t bits, Utime now);
  Change judge_progress(double position, Utime now);
  bool near_target(double position) const;

  Kind kind_ = Kind::none;
  Outcome outcome_ = Outcome::none;
  double target_ = 0, speed_ = 0;
  std::optional<Utime> accepted_;
  bool seen_moving_ = false;
  Utime stood_since_ = 0;
  Utime deadline_ = 0;
  double progress_position_ = 0;
  Utime progress_time_ = 0;
};

}  // namespace scanway::schunk
