#include "modules/simulator/device/lms/lms_emulator.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "common/random/random.h"

namespace scanway::simulator {
namespace {

// What an LMS511 says of itself, as recorded.
constexpr std::string_view kIdent = "LMS511_FieldEval", kFirmware = "V1.80    ", kLocation = "SN 18110550";
constexpr std::uint32_t kOperatingHours = 0x4AB, kPowerOns = 99;
constexpr unsigned kOutputs = 0x38;

constexpr unsigned kDenied = 1, kNoMethod = 2, kNoVariable = 3, kTooFewValues = 8, kNoCommand = 12, kNoEvent = 15;

constexpr Utime kAfterLastBeam = 18'900;     // Recorded scans are sent 40.2 to 41.0 ms after their first beam.
constexpr std::int64_t kMostWaiting = 1000;  // Scans, after a pause; earlier ones are lost, as the counter says.
constexpr std::int64_t kAtATime = 8;         // Scans; the other devices have their turn in between.
constexpr double kJitter_us = 80.0;          // Recorded scans come every 39.7 to 40.4 ms.

unsigned level_of(unsigned level, std::uint32_t password) {
  const bool right = (level == 2 && password == 0xB21ACE26) || (level == 3 && password == 0xF4724744) ||
                     (level == 4 && password == 0x81BE23AA);
  return right ? 1 : 0;
}

/// "field012": an evaluation field, of which there are thirty.
bool is_field(const std::string& name) {
  return name.size() == 8 && name.starts_with("field0") && name[6] >= '0' && name[6] <= '2' && name[7] >= '0' &&
         name[7] <= '9';
}

unsigned status_of(LmsEmulator::Window window) {
  constexpr unsigned kPollutionWarning = 2, kPollutionError = 4;
  if (window == LmsEmulator::Window::clean) return 0;
  return window == LmsEmulator::Window::dirt_error ? kPollutionError : kPollutionWarning;
}

}  // namespace

std::string LmsEmulator::receive(std::string_view bytes, Utime now) {
  requests_.push(bytes);
  std::string answers;
  while (const auto request = requests_.next()) {
    try {
      answers += answer(*request, now);
    } catch (const ValueMissing&) {
      answers += error_telegram(request->cola, kTooFewValues);
    }
  }
  return answers;
}

void LmsEmulator::hang_up() {
  logged_in_ = subscribed_ = false;
  requests_ = {};
}

void LmsEmulator::reboot() {
  hang_up();
  measuring_ = true;
  first_after_run_ = false;
  clock_offset_ = next_turn_ = 0;
  telegrams_ = 0;
}

std::string LmsEmulator::answer(const HostRequest& request, Utime now) {
  if (request.command == "sRN") return read(request, now);
  if (request.command == "sWN") return write(request);
  if (request.command == "sMN") return call(request, now);
  if (request.command == "sEN") return subscribe(request, now);
  return error_telegram(request.cola, kNoCommand);
}

std::string LmsEmulator::read(const HostRequest& request, Utime now) {
  constexpr unsigned kBusy = 0, kReady = 1, kIsMeasuring = 7, kIdle = 3;
  const std::string& name = request.name;
  TelegramWriter out(request.cola, "sRA", name);
  if (name == "DeviceIdent") return out.text(kIdent).text(kFirmware).frame();
  if (name == "FirmwareVersion") return out.text(kFirmware).frame();
  if (name == "LocationName") return out.text(kLocation).frame();
  if (name == "SCdevicestate") return out.u8(logged_in_ ? kBusy : kReady).frame();
  if (name == "ODoprh") return out.u32(kOperatingHours).frame();
  if (name == "ODpwrc") return out.u32(kPowerOns).frame();
  if (name == "LCMstate") return out.u8(static_cast<unsigned>(window_)).frame();
  if (name == "FREchoFilter") return out.u8(echo_filter_).frame();
  if (name == "LMPscancfg") {
    out.u32(mode_.frequency).u16(1).u32(mode_.resolution).i32(mode_.start_angle).i32(mode_.stop_angle);
    return out.frame();
  }
  if (name == "LMPoutputRange") {
    return out.u16(1).u32(mode_.resolution).i32(sector_start_).i32(sector_stop_).frame();
  }
  if (name == "LMDscandatacfg") {
    write_content(out);
    return out.frame();
  }
  if (name == "LMDscandata") return encode(scan(last_turn_before(now), now), request.cola, "sRA");
  if (name == "LIDinputstate") {
    out.u16(0).u32(static_cast<std::uint32_t>(now)).u32(0).u16(1);
    write_date(out, date_of(now + clock_offset_));
    return out.frame();
  }
  if (name == "STlms") {
    const ScannerDate date = date_of(now + clock_offset_);
    char time[32], day[32];
    std::snprintf(time, sizeof time, "%02u:%02u:%02u", date.hour, date.minute, date.second);
    std::snprintf(day, sizeof day, "%02u.%02u.%04u", date.day, date.month, date.year);
    return out.u16(measuring_ ? kIsMeasuring : kIdle).u8(0).text(time).text(day).u8(0).u8(0).u8(0).frame();
  }
  if (const auto kept = kept_.find(name); kept != kept_.end()) return out.characters(kept->second).frame();
  if (is_field(name)) return out.u8(0).frame();
  return error_telegram(request.cola, kNoVariable);
}

std::string LmsEmulator::write(const HostRequest& request) {
  HostValues values(request);
  const std::string& name = request.name;
  const bool known = name == "FREchoFilter" || name == "LMDscandatacfg" || name == "LMPoutputRange" ||
                     name == "EIHstCola" || name == "LICsrc" || name == "LICencset";
  if (!known) return error_telegram(request.cola, kNoVariable);
  if (!logged_in_) return error_telegram(request.cola, kDenied);
  if (name == "FREchoFilter") {
    echo_filter_ = values.u8();
  } else if (name == "LMDscandatacfg") {
    read_content(values);
  } else if (name == "LMPoutputRange") {
    values.u16();
    values.u32();
    sector_start_ = values.i32();
    sector_stop_ = values.i32();
  } else {
    values.u8();
  }
  return TelegramWriter(request.cola, "sWA", name).frame();
}

std::string LmsEmulator::call(const HostRequest& request, Utime now) {
  HostValues values(request);
  const std::string& name = request.name;
  TelegramWriter out(request.cola, "sAN", name);
  if (name == "SetAccessMode") {
    const unsigned level = values.u8();
    logged_in_ = level_of(level, values.u32()) == 1;
    return out.u8(logged_in_ ? 1 : 0).frame();
  }
  if (name == "Run") {
    first_after_run_ = true;
    logged_in_ = false;
    return out.u8(1).frame();
  }
  const bool known = name == "mLMPsetscancfg" || name == "mEEwriteall" || name == "LSPsetdatetime" ||
                     name == "LMCstartmeas" || name == "LMCstopmeas";
  if (!known) return error_telegram(request.cola, kNoMethod);
  if (!logged_in_) return error_telegram(request.cola, kDenied);
  if (name == "mLMPsetscancfg") return set_mode(request, now);
  if (name == "mEEwriteall") return out.u8(1).frame();
  if (name == "LSPsetdatetime") {
    using namespace std::chrono;
    const auto y = static_cast<int>(values.u16());
    const unsigned month = values.u8(), day = values.u8(), h = values.u8(), min = values.u8(), s = values.u8();
    const sys_days date = year(y) / std::chrono::month(month) / std::chrono::day(day);
    const microseconds since = date.time_since_epoch() + hours(h) + minutes(min) + seconds(s);
    clock_offset_ = since.count() + values.u32() - now;
    return out.u8(1).frame();
  }
  if (measuring_ != (name == "LMCstartmeas")) next_turn_ = last_turn_before(now) + 1;
  measuring_ = name == "LMCstartmeas";
  return out.u8(0).frame();
}

std::string LmsEmulator::set_mode(const HostRequest& request, Utime now) {
  HostValues values(request);
  ScanMode wanted;
  wanted.frequency = values.u32();
  values.u16();
  wanted.resolution = values.u32();
  wanted.start_angle = values.i32();
  wanted.stop_angle = values.i32();
  const unsigned error = scan_mode_error(wanted);
  if (error == 0) {
    mode_ = wanted;
    next_turn_ = last_turn_before(now) + 1;
  }
  TelegramWriter out(request.cola, "sAN", request.name);
  out.u8(error).u32(wanted.frequency).u16(1).u32(wanted.resolution).i32(wanted.start_angle).i32(wanted.stop_angle);
  return out.frame();
}

std::string LmsEmulator::subscribe(const HostRequest& request, Utime now) {
  const std::string& name = request.name;
  // Of the others nothing ever changes here, so that no event of them comes.
  const bool known = name == "LMDscandata" || name == "LFErec" || name == "LIDoutputstate" || name == "LIDinputstate";
  if (!known) return error_telegram(request.cola, kNoEvent);
  const unsigned on = HostValues(request).u8() == 0 ? 0 : 1;
  if (name == "LMDscandata") {
    subscribed_ = on == 1;
    cola_ = request.cola;
    next_turn_ = last_turn_before(now) + 1;
  }
  return TelegramWriter(request.cola, "sEA", name).u8(on).frame();
}

void LmsEmulator::write_content(TelegramWriter& out) const {
  out.bits(content_.channels).u8(content_.remission).u8(content_.remission_resolution).u8(content_.unit);
  out.bits(content_.encoders).u8(content_.position).u8(content_.name).u8(content_.comment).u8(content_.time);
  out.u16(content_.every);
}

void LmsEmulator::read_content(HostValues& values) {
  Content next;
  next.channels = values.bits();
  next.remission = values.u8();
  next.remission_resolution = values.u8();
  next.unit = values.u8();
  next.encoders = values.bits();
  next.position = values.u8();
  next.name = values.u8();
  next.comment = values.u8();
  next.time = values.u8();
  next.every = std::max(1U, values.u16());
  content_ = next;
}

Utime LmsEmulator::start_of(std::int64_t number) const {
  Random random(static_cast<std::uint64_t>(number) * 0x9E3779B97F4A7C15U);
  return std::llround(static_cast<double>(number) * mode_.period_us() + kJitter_us * (2.0 * random.uniform() - 1.0));
}

/// The last one that has been sent, or would have been.
std::int64_t LmsEmulator::last_turn_before(Utime now) const {
  auto turn = static_cast<std::int64_t>(static_cast<double>(now) / mode_.period_us()) + 1;
  const auto field_us = static_cast<Utime>(mode_.period_us() * 190.0 / 360.0);
  while (turn > 0 && start_of(turn) + field_us + kAfterLastBeam > now) --turn;
  return turn;
}

std::vector<std::string> LmsEmulator::tick(Utime now) {
  std::vector<std::string> frames;
  if (!measuring_ || !subscribed_) return frames;
  const std::int64_t last = last_turn_before(now);
  next_turn_ = std::max(next_turn_, last - kMostWaiting);
  for (const std::int64_t end = std::min(last + 1, next_turn_ + kAtATime); next_turn_ < end; ++next_turn_) {
    if (next_turn_ % content_.every != 0) continue;
    frames.push_back(encode(scan(next_turn_, now), cola_));
    first_after_run_ = false;
  }
  return frames;
}

ScanTelegram LmsEmulator::scan(std::int64_t turn, Utime now) {
  constexpr unsigned kAllEchoes = 1;
  MirrorTurn mirror;
  mirror.number = turn;
  mirror.start = start_of(turn);
  mirror.sector = sector_of(mode_, sector_start_, sector_stop_);
  mirror.step_deg = mode_.step_deg();
  mirror.beam_period_us = mode_.period_us() * mirror.step_deg / 360.0;
  const ScannedLine line = look_(mirror);

  ScanTelegram scan;
  scan.status = (first_after_run_ ? 1U : 0U) | status_of(window_);
  scan.telegram_counter = telegrams_++;
  scan.scan_counter = static_cast<std::uint16_t>(turn);
  const auto told = [&](Utime time) { return static_cast<Utime>(static_cast<double>(time) / speed_); };
  const auto told_rate = [&](double rate) { return static_cast<std::uint32_t>(std::lround(rate * speed_)); };
  scan.start_us = static_cast<std::uint32_t>(told(mirror.start));
  const auto field_us = static_cast<Utime>(mode_.period_us() * 190.0 / 360.0);
  scan.sent_us = static_cast<std::uint32_t>(told(std::min(now, mirror.start + field_us + kAfterLastBeam)));
  scan.outputs = kOutputs;
  scan.scan_frequency = told_rate(mode_.frequency);
  scan.measurement_frequency = told_rate(mode_.measurement_frequency());
  if (content_.encoders != 0) scan.encoders.resize(1);
  ScanTelegram::Channel channel;
  channel.start_angle = static_cast<std::int32_t>(std::lround(mirror.sector.start_deg * 1e4));
  channel.angular_step = static_cast<std::uint16_t>(mode_.resolution);
  for (int echo = 1; echo <= (echo_filter_ == kAllEchoes ? 5 : 1); ++echo) {
    // There is one echo of each beam: the others are empty.
    const auto beams = static_cast<std::size_t>(mirror.sector.beams);
    channel.content = "DIST" + std::to_string(echo);
    channel.scale = static_cast<float>(line.scale);
    channel.counts = echo == 1 ? line.ranges : std::vector<std::uint16_t>(beams);
    scan.ranges.push_back(channel);
    if (content_.remission == 0) continue;
    channel.content = "RSSI" + std::to_string(echo);
    channel.scale = 1.0F;
    channel.counts.assign(beams, 0);
    if (echo == 1) channel.counts.assign(line.remissions.begin(), line.remissions.end());
    scan.remissions.push_back(channel);
  }
  if (content_.time != 0) scan.date = date_of(mirror.start + clock_offset_);
  return scan;
}

}  // namespace scanway::simulator
