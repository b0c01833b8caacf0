#include "modules/xsens_bridge/core/dialogue.h"

#include <utility>

#include "modules/xsens_bridge/core/item.h"

namespace scanway::xsens {
namespace {

constexpr Utime kAnswerPatience = kMicrosecondsPerSecond / 2;
constexpr Utime kDataPatience = 2 * kMicrosecondsPerSecond;
// Messages under way come before the answer, so the tracker is asked more often; a reboot takes some seconds.
constexpr int kTriesOfGoToConfig = 20;
constexpr unsigned kNotImplemented = 4;
constexpr std::uint32_t kPeriodClock = 115200;  // Periods are in parts of a second.
constexpr std::uint16_t kEveryMessage = 0xFFFF;

std::uint16_t id_of(Quantity quantity) { return static_cast<std::uint16_t>(quantity); }

}  // namespace

Dialogue::Dialogue(const TrackerConfig& config, Utime now) : config_(config) { begin(now); }

void Dialogue::receive(std::span<const std::uint8_t> bytes, Utime now) {
  if (state_ == State::failed) return;
  finder_.push(bytes);
  while (const auto stretch = finder_.next()) {
    if (stretch->whole) handle(*stretch, now);
  }
}

void Dialogue::tick(Utime now) {
  if (state_ == State::measuring && now - last_data_ > kDataPatience) {
    return fail("no measurements for " + std::to_string(kDataPatience / kMicrosecondsPerSecond) + " s");
  }
  if (state_ != State::configuring || now < deadline_) return;
  ++counters_.unanswered;
  if (--tries_left_ > 0) {
    output_.insert(output_.end(), steps_[step_].request.begin(), steps_[step_].request.end());
    deadline_ = now + kAnswerPatience;
  } else {
    finish_step("no answer", now);
  }
}

std::vector<std::uint8_t> Dialogue::take_output() { return std::exchange(output_, {}); }

std::vector<DataMessage> Dialogue::take_data() { return std::exchange(data_, {}); }

std::vector<std::string> Dialogue::take_notes() { return std::exchange(notes_, {}); }

TrackerCounters Dialogue::counters() const {
  TrackerCounters counters = counters_;
  counters.bad_bytes = finder_.bad_bytes();
  return counters;
}

void Dialogue::begin(Utime now) {
  state_ = State::configuring;
  steps_ = {{"go to configuration", make_frame(kGoToConfig), kGoToConfig + 1, kTriesOfGoToConfig, true, {}}};
  step_ = 0;
  add_questions();
  send_step(now);
}

void Dialogue::add_questions() {
  steps_.push_back({"tell its identity", make_frame(kReqDeviceId), kDeviceId, 3, false, [this](const Message& answer) {
                      info_.device_id = parse_device_id(answer);
                      return std::string();
                    }});
  steps_.push_back(
      {"tell its product code", make_frame(kReqProductCode), kProductCode, 3, false, [this](const Message& answer) {
         info_.product_code = parse_product_code(answer);
         return std::string();
       }});
  steps_.push_back({"tell its firmware", make_frame(kReqFirmware), kFirmware, 3, false, [this](const Message& answer) {
                      info_.firmware = parse_firmware(answer);
                      return std::string();
                    }});
  // The question by which the generations differ: older trackers do not know the message.
  steps_.push_back({"tell its output", make_frame(kSetOutputConfiguration), kOutputConfiguration, 3, true,
                    [this](const Message& answer) {
                      info_.legacy = answer.mid == kError;
                      info_.legacy ? add_legacy_settings() : add_current_settings();
                      add_start();
                      return std::string();
                    }});
}

void Dialogue::add_current_settings() {
  steps_.push_back({"take the output that is wanted", set_output_configuration(wanted_output()), kOutputConfiguration,
                    3, true, [this](const Message& answer) { return accept_output_configuration(answer); }});
}

void Dialogue::add_legacy_settings() {
  info_.layout = {kModeCalibrated | kModeOrientation, kSettingCounter};
  const auto set = [this](const char* purpose, Mid mid, std::uint32_t value, int size) {
    steps_.push_back({purpose, set_number(mid, value, size), static_cast<std::uint8_t>(mid + 1), 3, true, {}});
  };
  set("take the period", kSetPeriod, kPeriodClock / std::max<std::uint32_t>(1, config_.rate_hz), 2);
  set("take the skip factor", kSetOutputSkipFactor, 0, 2);
  set("take the output mode", kSetOutputMode, info_.layout.mode, 2);
  set("take the output settings", kSetOutputSettings, info_.layout.settings, 4);
  steps_.push_back({"tell its configuration", make_frame(kReqConfiguration), kConfiguration, 3, true,
                    [this](const Message& answer) { return accept_configuration(answer); }});
}

void Dialogue::add_start() {
  steps_.push_back({"go to measurement", make_frame(kGoToMeasurement), kGoToMeasurement + 1, 3, true, {}});
}

void Dialogue::send_step(Utime now) {
  if (step_ == steps_.size()) {
    state_ = State::measuring;
    last_data_ = now;
    return;
  }
  const auto& request = steps_[step_].request;
  output_.insert(output_.end(), request.begin(), request.end());
  tries_left_ = steps_[step_].tries;
  deadline_ = now + kAnswerPatience;
}

void Dialogue::finish_step(const std::string& trouble, Utime now) {
  const Step& step = steps_[step_];
  if (!trouble.empty()) {
    const std::string sentence = "the tracker does not " + step.purpose + ": " + trouble;
    if (step.required) return fail(sentence);
    notes_.push_back(sentence);
  }
  ++step_;
  send_step(now);
}

void Dialogue::handle(const Stretch& stretch, Utime now) {
  ++counters_.messages;
  Message message = open_frame(stretch.bytes);
  if (message.mid == kWakeUp) {
    ++counters_.wake_ups;
    const auto answer = make_frame(kWakeUpAck);
    output_.insert(output_.end(), answer.begin(), answer.end());
    return begin(now);
  }
  if (message.mid == kMtData || message.mid == kMtData2) {
    if (state_ != State::measuring) return;
    ++counters_.data_messages;
    last_data_ = now;
    data_.push_back({std::move(message), stretch.bytes.size(), now});
    return;
  }
  handle_answer(message, now);
}

void Dialogue::handle_answer(const Message& message, Utime now) {
  const bool refused = message.mid == kError;
  if (refused) ++counters_.errors;
  if (state_ != State::configuring) {
    if (refused && !message.data.empty()) notes_.push_back("the tracker reports: " + error_name(message.data[0]));
    return;
  }
  // Copied: what an answer means may add further steps.
  const Step step = steps_[step_];
  const bool no_such_message = refused && !message.data.empty() && message.data[0] == kNotImplemented;
  const bool tells_generation = no_such_message && step.answer == kOutputConfiguration && step.request.size() == 5;
  if (!refused && message.mid != step.answer) return;
  // An error at this point belongs to something earlier: every tracker knows GoToConfig, which is asked again.
  if (refused && step.request == make_frame(kGoToConfig)) return;
  std::string trouble;
  try {
    if (refused && !tells_generation) {
      trouble = error_name(parse_error(message));
    } else if (step.accept) {
      trouble = step.accept(message);
    }
  } catch (const BadMessage& error) {
    trouble = error.what();
  }
  finish_step(trouble, now);
}

/// Trackers answer with the list that they really use, some with none.
std::string Dialogue::accept_output_configuration(const Message& answer) {
  if (answer.data.empty() || parse_output_configuration(answer) == wanted_output()) return {};
  notes_.push_back("the tracker measures something else than it was asked for; see `scanway-xsens --probe`");
  return {};
}

std::string Dialogue::accept_configuration(const Message& answer) {
  const Configuration configuration = parse_configuration(answer);
  if (configuration.layout != info_.layout) return "its output mode is another than it was given";
  if (configuration.mtdata_length != length_of(info_.layout)) return "its messages have another length than its mode";
  return {};
}

std::vector<OutputEntry> Dialogue::wanted_output() const {
  return {{id_of(Quantity::packet_counter), kEveryMessage}, {id_of(Quantity::sample_time_fine), kEveryMessage},
          {id_of(Quantity::quaternion), config_.rate_hz},   {id_of(Quantity::acceleration), config_.rate_hz},
          {id_of(Quantity::rate_of_turn), config_.rate_hz}, {id_of(Quantity::magnetic_field), config_.rate_hz},
          {id_of(Quantity::status_word), kEveryMessage}};
}

void Dialogue::fail(const std::string& reason) {
  state_ = State::failed;
  failure_ = reason;
}

}  // namespace scanway::xsens
