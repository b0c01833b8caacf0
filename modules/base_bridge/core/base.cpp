#include "modules/base_bridge/core/base.h"

#include <cmath>
#include <iterator>
#include <utility>

namespace scanway::erratic {
namespace {

constexpr Utime kBetweenPackets = 15'000;  // The robot buffers little.
constexpr Utime kAskAgain = 100'000;
constexpr Utime kTimeForBaud = 1'000'000;
constexpr Utime kTimeToIdentify = 3'000'000;

}  // namespace

Base::Base(const BaseConfig& config) : config_(config), finder_(make_packet_finder()), drive_(config.drive) {}

void Base::port_opened(Utime now) {
  finder_ = make_packet_finder();
  phase_ = Phase::searching;
  bauds_tried_ = 0;
  bytes_while_searching_ = 0;
  since_ = now;
  asked_.reset();
  has_pose_ = false;
  opening_.clear();
  drive_.shut_down(now);
}

void Base::receive(Bytes bytes, Utime now) {
  if (phase_ == Phase::searching) bytes_while_searching_ += bytes.size();
  finder_.push(bytes);
  while (const auto stretch = finder_.next()) {
    if (!stretch->whole) {
      counters_.bad_bytes += stretch->length;
      continue;
    }
    ++counters_.packets;
    heard_ = now;
    if (phase_ == Phase::searching) {
      phase_ = Phase::identifying;
      since_ = now;
    }
    take(read_report(payload_of(stretch->bytes)), now);
  }
}

void Base::take(const Report& report, Utime now) {
  if (const auto* motors = std::get_if<MotorReport>(&report)) {
    take_motors(*motors, now);
  } else if (const auto* configuration = std::get_if<ConfigurationReport>(&report)) {
    configuration_ = *configuration;
    odometry_.set_metres_per_count(configuration->metres_per_count());
    if (phase_ == Phase::identifying) open(now);
  } else if (std::holds_alternative<MalformedReport>(report)) {
    ++counters_.malformed;
  } else {
    if (const auto* text = std::get_if<TextReport>(&report)) {
      tell(BaseEvent::Kind::text, now, "the base says: " + text->text);
    }
    reports_.push_back(report);
  }
}

void Base::take_motors(const MotorReport& report, Utime now) {
  motors_ = report;
  if (phase_ != Phase::running) return;
  has_pose_ = true;
  switch (odometry_.add(report, now)) {
    case Odometry::Step::first:
    case Odometry::Step::added:
      break;
    case Odometry::Step::dropped:
      ++counters_.dropped_steps;
      tell(BaseEvent::Kind::odometry_gap, now, "the base's odometry jumped: the step does not count");
      break;
    case Odometry::Step::continued:
      tell(BaseEvent::Kind::odometry_gap, now, "the base's odometry has a gap: what was driven in it does not count");
      break;
    case Odometry::Step::restarted:
      tell(BaseEvent::Kind::odometry_gap, now, "the base has restarted: its odometry goes on from where it was");
      break;
  }
  const bool stalls = report.left_stall || report.right_stall;
  if (stalls && !stalled_) tell(BaseEvent::Kind::stalled, now, "a wheel of the base is stalled: free it");
  stalled_ = stalls;
}

void Base::open(Utime now) {
  phase_ = Phase::running;
  since_ = now;
  has_pose_ = told_absence_ = false;
  // Whoever drove it last may have gone without a stop.
  opening_ = {make_command(Command::open_controller), make_command(Command::pulse), make_command(Command::stop),
              make_command(Command::enable_motors, 0)};
  if (const int limit = config_.max_acceleration_mm_s2; limit > 0) {
    opening_.push_back(make_command(Command::set_max_trans_acc, limit));
    opening_.push_back(make_command(Command::set_max_trans_acc, -limit));
  }
  if (const int limit = config_.max_turn_acceleration_deg_s2; limit > 0) {
    opening_.push_back(make_command(Command::set_max_rot_acc, limit));
    opening_.push_back(make_command(Command::set_max_rot_acc, -limit));
  }
  if (config_.sonar) opening_.push_back(make_command(Command::set_sonar, 1));
  if (config_.analog) opening_.push_back(make_command(Command::set_analog, 1));
  drive_.reset();
  odometry_.was_away();
  const std::string what = configuration_
                               ? configuration_->name + ", " + configuration_->type + " " + configuration_->subtype
                               : std::string("it does not say what it is, taken for Rev E");
  tell(BaseEvent::Kind::found, now, "the base answers at " + std::to_string(baud()) + " baud: " + what);
}

void Base::search(Utime now) {
  if (phase_ == Phase::identifying && now - *since_ > kTimeToIdentify) return open(now);
  if (!asked_ || now - *asked_ >= kAskAgain) {
    asked_ = now;
    opening_ = {make_command(Command::configuration)};
  }
  if (phase_ == Phase::identifying || now - *since_ < kTimeForBaud) return;
  since_ = now;
  baud_ = (baud_ + 1) % std::size(kBauds);
  finder_ = make_packet_finder();
  if (++bauds_tried_ < static_cast<int>(std::size(kBauds)) || told_absence_) return;
  told_absence_ = true;
  tell(BaseEvent::Kind::lost, now,
       bytes_while_searching_ > 0
           ? "no packet of an ERA-Mobi base at 38400 or 115200 baud, only other bytes: is this the right port?"
           : "the base does not answer at 38400 or 115200 baud: check its power, the cable and the port");
}

void Base::watch_clock(Utime now) {
  if (now < ticked_) {
    // Measured by it, a velocity would hold for however long the clock was set back.
    since_ = now;
    heard_ = now;
    asked_.reset();
    sent_.reset();
    drive_.clock_was_set(now);
    tell(BaseEvent::Kind::text, now, "the clock was set back: the base is stopped");
  }
  ticked_ = now;
}

void Base::tick(Utime now) {
  watch_clock(now);
  if (!since_) since_ = now;
  if (phase_ != Phase::searching && now - heard_ > config_.silence) {
    ++counters_.times_lost;
    tell(BaseEvent::Kind::lost, now, "the base has fallen silent: check its power and the cable");
    port_opened(now);
    told_absence_ = true;
  }
  if (phase_ != Phase::running) return search(now);
  if (drive_.tick(now)) tell(BaseEvent::Kind::motors_off, now, "no command for the base any more: stopped, motors off");
}

Packet Base::next_packet(Utime now) {
  if (sent_ && now - *sent_ < kBetweenPackets && now >= *sent_) return {};
  Packet packet;
  if (!opening_.empty()) {
    packet = std::move(opening_.front());
    opening_.pop_front();
  } else if (!drive_.empty()) {
    packet = drive_.take();
  }
  if (!packet.empty()) sent_ = now;
  return packet;
}

std::string Base::drive(double speed_m_s, double turn_rate_rad_s, Utime now) {
  if (!std::isfinite(speed_m_s) || !std::isfinite(turn_rate_rad_s)) {
    drive_.stop(now);
    return "the command holds a speed that is no number";
  }
  if (!ready()) return "the base does not answer";
  drive_.set(speed_m_s, turn_rate_rad_s, now);
  return {};
}

std::vector<Packet> Base::farewell() {
  return {make_command(Command::stop), make_command(Command::enable_motors, 0),
          make_command(Command::close_controller)};
}

void Base::tell(BaseEvent::Kind kind, Utime now, std::string text) { events_.push_back({kind, now, std::move(text)}); }

std::vector<Report> Base::take_reports() { return std::exchange(reports_, {}); }

std::vector<BaseEvent> Base::take_events() { return std::exchange(events_, {}); }

}  // namespace scanway::erratic
