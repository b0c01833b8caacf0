#pragma once

#include <cstdint>
#include <vector>

namespace scanway::test {

/// A frame as the test module knows it.
struct TestFrame {
  std::uint16_t id = 0;
  std::vector<std::uint8_t> bytes;
};

/// A module of the PW-70 as the protocol sheet describes it, with an encoder of its own: nothing here comes from the
/// bridge. It moves at constant speed. Angles in degrees, times in microseconds.
class TestModule {
 public:
  enum Units : std::uint8_t { kRadians = 3, kDegrees = 4, kMillidegrees = 9, kMillimetres = 0 };

  TestModule(std::uint8_t id, Units units, bool referenced) : id_(id), units_(units), referenced_(referenced) {}

  /// What it sends when a frame comes.
  std::vector<TestFrame> handle(const TestFrame& frame, std::int64_t now);
  /// What it sends unasked by now.
  std::vector<TestFrame> run(std::int64_t now);

  // What befalls it.
  std::vector<TestFrame> reboot(std::int64_t now);
  std::vector<TestFrame> fail(std::uint8_t error);
  /// The clock that it is told, that is.
  void clock_was_set(std::int64_t now) { next_state_ = last_ = now; }
  bool powered = true;   ///< Without power it neither hears nor says anything.
  bool stuck = false;    ///< It says that it moves, and does not.
  bool blocked = false;  ///< It stops at once.
  bool impulses = true;  ///< Whether it announces the end of moves.
  bool refuses_moves = false;

  double angle() const { return angle_; }
  double tilt_by(double degrees) { return angle_ += degrees; }
  bool moving() const { return kind_ != Kind::none; }
  double speed() const { return speed_; }
  std::uint8_t error() const { return error_; }
  std::vector<std::uint8_t> commands;  ///< The command bytes that came, in order.
  std::vector<double> move_targets;    ///< Of MOVE POS.

 private:
  enum class Kind { none, reference, position, velocity };

  void put_number(std::vector<std::uint8_t>& bytes, double degrees) const;
  double get_number(const std::vector<std::uint8_t>& bytes, std::size_t at) const;
  void advance(std::int64_t now);
  void finish_move(std::vector<TestFrame>& out);
  std::vector<std::uint8_t> state_bytes() const;
  std::vector<TestFrame> send(std::uint16_t kind, const std::vector<std::uint8_t>& message) const;
  std::vector<TestFrame> config(const std::vector<std::uint8_t>& message) const;
  std::vector<TestFrame> answer(const std::vector<std::uint8_t>& message, std::int64_t now);

  std::uint8_t id_;
  Units units_;
  bool referenced_;
  std::uint8_t error_ = 0;
  std::uint8_t end_bits_ = 0x20;
  std::uint8_t mask_ = 0;
  double period_s_ = 0;
  std::int64_t next_state_ = 0, last_ = 0, reference_end_ = 0, silent_until_ = 0;
  double angle_ = 10.0, target_ = 0, target_speed_ = 10.0, speed_ = 0;
  Kind kind_ = Kind::none;
};

}  // namespace scanway::test
