#include "tests/modules/schunk_bridge/support/test_module.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace scanway::test {
namespace {

constexpr double kDegreesPerRadian = 57.295779513082323;
constexpr std::uint8_t kOk1 = 0x4F, kOk2 = 0x4B;

void put_float(std::vector<std::uint8_t>& bytes, float value) {
  std::uint8_t raw[4];
  std::memcpy(raw, &value, 4);
  bytes.insert(bytes.end(), raw, raw + 4);
}

void put_int(std::vector<std::uint8_t>& bytes, double value) {
  const auto whole = static_cast<std::int32_t>(std::llround(value));
  std::uint8_t raw[4];
  std::memcpy(raw, &whole, 4);
  bytes.insert(bytes.end(), raw, raw + 4);
}

void join(std::vector<TestFrame>& out, std::vector<TestFrame> more) { out.insert(out.end(), more.begin(), more.end()); }

}  // namespace

void TestModule::put_number(std::vector<std::uint8_t>& bytes, double degrees) const {
  if (units_ == kMillidegrees) return put_int(bytes, degrees * 1000);
  put_float(bytes, static_cast<float>(units_ == kRadians ? degrees / kDegreesPerRadian : degrees));
}

double TestModule::get_number(const std::vector<std::uint8_t>& bytes, std::size_t at) const {
  if (units_ == kMillidegrees) {
    std::int32_t whole;
    std::memcpy(&whole, bytes.data() + at, 4);
    return whole / 1000.0;
  }
  float value;
  std::memcpy(&value, bytes.data() + at, 4);
  return units_ == kRadians ? static_cast<double>(value) * kDegreesPerRadian : static_cast<double>(value);
}

// The sheet's table of fragments, written out again: "rem code data", rem counts what is still to come.
std::vector<TestFrame> TestModule::send(std::uint16_t kind, const std::vector<std::uint8_t>& message) const {
  const auto id = static_cast<std::uint16_t>(kind + id_);
  std::vector<TestFrame> frames;
  if (message.size() <= 7) {
    TestFrame frame{id, {static_cast<std::uint8_t>(message.size())}};
    frame.bytes.insert(frame.bytes.end(), message.begin(), message.end());
    return {frame};
  }
  std::size_t sent = 0;
  while (sent < message.size()) {
    const std::size_t left = message.size() - sent;
    const std::uint8_t code = sent == 0 ? 0x84 : left > 6 ? 0x85 : 0x86;
    TestFrame frame{id, {static_cast<std::uint8_t>(left), code}};
    for (std::size_t i = 0; i < std::min<std::size_t>(left, 6); ++i) frame.bytes.push_back(message[sent + i]);
    sent += std::min<std::size_t>(left, 6);
    frames.push_back(frame);
  }
  return frames;
}

std::vector<std::uint8_t> TestModule::state_bytes() const {
  std::vector<std::uint8_t> message = {0x95};
  if (mask_ & 1) put_number(message, angle_);
  if (mask_ & 2) put_number(message, moving() && !stuck ? speed_ : 0);
  if (mask_ & 4) put_number(message, 0);
  std::uint8_t bits = moving() ? 0x02 : end_bits_;
  if (referenced_) bits |= 0x01;
  message.push_back(bits);
  message.push_back(error_);
  return message;
}

std::vector<TestFrame> TestModule::handle(const TestFrame& frame, std::int64_t now) {
  if (!powered || now < silent_until_ || frame.id != 0x500 + id_ || frame.bytes.size() < 2) return {};
  advance(now);
  const std::size_t length = frame.bytes[0];
  if (length + 1 > frame.bytes.size() || length == 0) return send(0x700, {0x8A, 0x1D});
  return answer({frame.bytes.begin() + 1, frame.bytes.begin() + 1 + static_cast<long>(length)}, now);
}

std::vector<TestFrame> TestModule::config(const std::vector<std::uint8_t>& message) const {
  if (message.size() == 1) {
    std::vector<std::uint8_t> info(45, 0);
    info[0] = 0x80;
    std::memcpy(info.data() + 1, "PW-70", 5);
    info[13] = 121;  // Firmware 1.21.
    return send(0x700, info);
  }
  std::vector<std::uint8_t> reply = {0x80, message[1]};
  switch (message[1]) {
    case 0x06:
      reply.push_back(units_);
      break;
    case 0x07:
      put_number(reply, 400);
      break;
    case 0x08:
      put_number(reply, -400);
      break;
    case 0x09:
      put_number(reply, 120);
      break;
    default:
      return send(0x700, {0x80, 0x1E});
  }
  return send(0x700, reply);
}

std::vector<TestFrame> TestModule::answer(const std::vector<std::uint8_t>& message, std::int64_t now) {
  const std::uint8_t command = message[0];
  commands.push_back(command);
  const std::vector<std::uint8_t> ok = {command, kOk1, kOk2};
  const bool moves = command == 0x92 || command == 0xB0 || command == 0xB5;
  if (moves && (error_ != 0 || refuses_moves)) return send(0x700, {command, 0x05});
  switch (command) {
    case 0x80:
      return config(message);
    case 0xA0:
      target_speed_ = get_number(message, 1);
      return send(0x700, ok);
    case 0x95: {
      if (message.size() == 6) {
        std::vector<std::uint8_t> raw(message.begin() + 1, message.begin() + 5);
        std::int32_t milliseconds;
        float seconds;
        std::memcpy(&milliseconds, raw.data(), 4);
        std::memcpy(&seconds, raw.data(), 4);
        period_s_ = units_ == kMillidegrees ? milliseconds / 1000.0 : static_cast<double>(seconds);
        mask_ = message[5];
        next_state_ = now + static_cast<std::int64_t>(period_s_ * 1e6);
      }
      return send(0x700, state_bytes());
    }
    case 0x92:
      kind_ = Kind::reference;
      reference_end_ = now + 400'000;
      return send(0x700, ok);
    case 0xB0: {
      if (!referenced_) return send(0x700, {command, 0x06});
      target_ = get_number(message, 1);
      move_targets.push_back(target_);
      kind_ = Kind::position;
      speed_ = target_ < angle_ ? -target_speed_ : target_speed_;
      std::vector<std::uint8_t> reply = {command};
      const double seconds = std::fabs(target_ - angle_) / target_speed_;
      if (units_ == kMillidegrees) {
        put_int(reply, seconds * 1000);
      } else {
        put_float(reply, static_cast<float>(seconds));
      }
      return send(0x700, reply);
    }
    case 0xB5:
      kind_ = Kind::velocity;
      speed_ = get_number(message, 1);
      return send(0x700, ok);
    case 0x91:
      kind_ = Kind::none;
      end_bits_ = 0x60;
      return send(0x700, ok);
    case 0x90:
      kind_ = Kind::none;
      end_bits_ = 0x60;
      error_ = 0xD9;
      return send(0x300, {0x88, 0xD9});
    case 0x8B: {
      error_ = 0;
      auto frames = send(0x700, ok);
      join(frames, send(0x700, {0x8A, 0x08, 0x00}));
      return frames;
    }
    default:
      return send(0x700, {command, 0x04});
  }
}

void TestModule::advance(std::int64_t now) {
  const double seconds = static_cast<double>(now - last_) * 1e-6;
  last_ = now;
  if (stuck || seconds <= 0 || (kind_ != Kind::position && kind_ != Kind::velocity)) return;
  if (blocked) return;
  angle_ += speed_ * seconds;
  if (kind_ == Kind::position && (speed_ > 0 ? angle_ >= target_ : angle_ <= target_)) angle_ = target_;
}

void TestModule::finish_move(std::vector<TestFrame>& out) {
  const bool reached = kind_ == Kind::position && angle_ == target_;
  kind_ = Kind::none;
  end_bits_ = reached ? 0xA0 : 0x60;
  std::vector<std::uint8_t> message = {static_cast<std::uint8_t>(reached ? 0x94 : 0x93)};
  put_number(message, angle_);
  if (impulses) join(out, send(0x700, message));
}

std::vector<TestFrame> TestModule::run(std::int64_t now) {
  std::vector<TestFrame> out;
  if (!powered || now < silent_until_) return out;
  advance(now);
  if (kind_ == Kind::reference && now >= reference_end_) {
    referenced_ = true;
    angle_ = 0;
    finish_move(out);
  } else if (kind_ == Kind::position && (angle_ == target_ || blocked)) {
    finish_move(out);
  }
  if (period_s_ > 0 && now >= next_state_) {
    next_state_ += static_cast<std::int64_t>(period_s_ * 1e6);
    if (next_state_ <= now) next_state_ = now + static_cast<std::int64_t>(period_s_ * 1e6);
    join(out, send(0x700, state_bytes()));
  }
  return out;
}

std::vector<TestFrame> TestModule::reboot(std::int64_t now) {
  kind_ = Kind::none;
  mask_ = 0;
  period_s_ = 0;
  error_ = 0;
  end_bits_ = 0x20;
  referenced_ = false;
  silent_until_ = 0;
  last_ = now;
  return send(0x700, {0x8A, 0x01, 0x00});
}

std::vector<TestFrame> TestModule::fail(std::uint8_t error) {
  kind_ = Kind::none;
  end_bits_ = 0x20;
  error_ = error;
  return send(0x300, {0x88, error});
}

}  // namespace scanway::test
