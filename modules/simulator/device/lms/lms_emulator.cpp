#include "modules/simulator/device/lms/lms_emulator.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

namespace scanway::simulator {
namespace {

// What an LMS511 says of itself, as recorded.
constexpr std::string_view kIdent = "LMS511_FieldEval", kFirmware = "V1.80    ", kLocation = "SN 18110550";
constexpr std::uint32_t kOperatingHours = 0x4AB, kPowerOns = 99;
constexpr unsigned kOutputs = 0x38;

constexpr unsigned kDenied = 1, kNoMethod = 2, kNoVariable = 3, kTooFewValues = 8, kNoCommand = 12, kNoEvent = 15;

constexpr std::int64_t kMostWaiting = 1000;  // Scans, after a pause; earlier ones are lost, as the counter says.
constexpr std::int64_t kAtATime = 8;         // Scans; the other devices have their turn in between.

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
  const ScanMode& mode = mirror_.mode();
  if (name == "LMPscancfg") {
    return out.u32(mode.frequency).u16(1).u32(mode.resolution).i32(mode.start_angle).i32(mode.stop_angle).frame();
  }
  if (name == "LMPoutputRange") {
    return out.u16(1).u32(mode.resolution).i32(mirror_.sector_start()).i32(mirror_.sector_stop()).frame();
  }
  if (name == "LMDscandatacfg") {
    content_.write(out);
    return out.frame();
  }
  if (name == "LMDscandata") return encode(scan(mirror_.last_sent_before(now), now), request.cola, "sRA");
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
    content_ = ScanContent::read(values);
  } else if (name == "LMPoutputRange") {
    values.u16();
    values.u32();
    const std::int32_t start = values.i32();
    mirror_.set_sector(start, values.i32());
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
  if (measuring_ != (name == "LMCstartmeas")) next_turn_ = mirror_.last_sent_before(now) + 1;
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
    mirror_.set_mode(wanted);
    next_turn_ = mirror_.last_sent_before(now) + 1;
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
    next_turn_ = mirror_.last_sent_before(now) + 1;
  }
  return TelegramWriter(request.cola, "sEA", name).u8(on).frame();
}

std::vector<std::string> LmsEmulator::tick(Utime now) {
  std::vector<std::string> frames;
  if (!measuring_ || !subscribed_) return frames;
  const std::int64_t last = mirror_.last_sent_before(now);
  if (const std::int64_t late = last - kMostWaiting - next_turn_; late > 0) {
    next_turn_ += late;
    dropped_ += late / content_.every;
  }
  for (const std::int64_t end = std::min(last + 1, next_turn_ + kAtATime); next_turn_ < end; ++next_turn_) {
    if (next_turn_ % content_.every != 0) continue;
    frames.push_back(encode(scan(next_turn_, now), cola_));
    first_after_run_ = false;
  }
  return frames;
}

ScanTelegram LmsEmulator::scan(std::int64_t number, Utime now) {
  constexpr unsigned kAllEchoes = 1;
  const MirrorTurn turn = mirror_.turn(number);
  const ScannedLine line = look_(turn);
  const auto told = [&](Utime time) { return static_cast<Utime>(static_cast<double>(time) / speed_); };
  const auto told_rate = [&](double rate) { return static_cast<std::uint32_t>(std::lround(rate * speed_)); };
  ScanTelegram scan;
  scan.status = (first_after_run_ ? 1U : 0U) | status_of(window_);
  scan.telegram_counter = telegrams_++;
  scan.scan_counter = static_cast<std::uint16_t>(number);
  scan.start_us = static_cast<std::uint32_t>(told(turn.start));
  scan.sent_us = static_cast<std::uint32_t>(told(std::min(now, mirror_.sent_at(number))));
  scan.outputs = kOutputs;
  scan.scan_frequency = told_rate(mirror_.mode().frequency);
  scan.measurement_frequency = told_rate(mirror_.mode().measurement_frequency());
  if (content_.encoders != 0) scan.encoders.resize(1);
  add_channels(scan, line, turn, echo_filter_ == kAllEchoes ? 5 : 1, content_.remission != 0);
  if (content_.time != 0) scan.date = date_of(turn.start + clock_offset_);
  return scan;
}

}  // namespace scanway::simulator
