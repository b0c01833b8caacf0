#include "modules/sick_bridge/core/dialogue.h"

#include <algorithm>
#include <utility>

#include "modules/sick_bridge/core/describe.h"
#include "modules/sick_bridge/core/names.h"
#include "modules/sick_bridge/core/scan_geometry.h"

namespace scanway::sick {
namespace {

constexpr Utime kDialectPatience = 2 * kMicrosecondsPerSecond;
// SICK: after power-up and after a change of frequency there may be no answers and no scans for 30 s.
constexpr Utime kSlowPatience = 35 * kMicrosecondsPerSecond;
constexpr Utime kScanPatience = 5 * kMicrosecondsPerSecond;
constexpr Utime kStatusPeriod = 5 * kMicrosecondsPerSecond;

std::string in_words(std::uint32_t frequency, std::uint32_t resolution) {
  const auto decimal = [](std::uint32_t value, std::uint32_t unit) {
    std::string text = std::to_string(static_cast<double>(value) / unit);
    text.erase(text.find_last_not_of('0') + 1);
    return text.back() == '.' ? text.substr(0, text.size() - 1) : text;
  };
  return decimal(frequency, 100) + " Hz with " + decimal(resolution, 10000) + " deg";
}

}  // namespace

Dialogue::Dialogue(const LmsConfig& config, Utime now) : config_(config), tried_(config.first_dialect), began_(now) {
  if (!is_mode_of_lms5xx(config.scan.frequency, config.scan.resolution)) {
    notes_.push_back("no LMS5xx has a mode of " + in_words(config.scan.frequency, config.scan.resolution) +
                     "; choose one of the list in docs/devices.md");
  }
  try_dialect(config.first_dialect, now);
}

void Dialogue::receive(std::span<const std::uint8_t> bytes, Utime now) {
  if (state_ == State::failed) return;
  finder_.push(bytes);
  while (const auto stretch = finder_.next()) {
    if (stretch->whole) handle(*stretch, now);
  }
}

void Dialogue::tick(Utime now) {
  switch (state_) {
    case State::finding_dialect:
      if (finder_.bad_bytes() > 0 && now - began_ > kDialectPatience * 3 / 2) {
        fail("what it sends is neither CoLa-A nor CoLa-B: is this the port of an LMS5xx (2111 or 2112)?");
      } else if (now - began_ > kSlowPatience) {
        fail(
            "it takes the connection and does not answer: is this the port of an LMS5xx (2111 or 2112), and has it "
            "started?");
      } else if (now >= deadline_) {
        try_dialect(tried_ == Dialect::cola_a ? Dialect::cola_b : Dialect::cola_a, now);
      }
      return;
    case State::starting:
      if (now >= deadline_) {
        ++counters_.unanswered;
        finish_step("no answer", now);
      }
      return;
    case State::measuring:
      if (now - last_scan_ > patience_for_scans()) {
        fail("no scan for " + std::to_string((now - last_scan_) / kMicrosecondsPerSecond) + " s");
      } else {
        ask_for_status(now);
      }
      return;
    case State::failed:
      return;
  }
}

std::string Dialogue::take_output() { return std::exchange(output_, {}); }

std::vector<Received> Dialogue::take_received() { return std::exchange(received_, {}); }

std::vector<std::string> Dialogue::take_notes() { return std::exchange(notes_, {}); }

DialogueCounters Dialogue::counters() const {
  DialogueCounters counters = counters_;
  counters.bad_bytes = finder_.bad_bytes();
  return counters;
}

void Dialogue::try_dialect(Dialect dialect, Utime now) {
  tried_ = dialect;
  output_ += read_variable(dialect, "FirmwareVersion").frame;
  deadline_ = now + kDialectPatience;
}

void Dialogue::start(Dialect dialect, Utime now) {
  dialect_ = dialect;
  state_ = State::starting;
  steps_ = start_up_steps(config_, dialect);
  step_ = 0;
  send_step(now);
}

void Dialogue::send_step(Utime now) {
  while (step_ < steps_.size() && steps_[step_].needed && !steps_[step_].needed(info_)) ++step_;
  waiting_ = step_ < steps_.size();
  if (!waiting_) {
    check_model();
    state_ = State::measuring;
    last_scan_ = now;
    next_status_ = now + kStatusPeriod;
    steps_ = status_steps(*dialect_);
    step_ = 0;
    return;
  }
  output_ += steps_[step_].request.frame;
  deadline_ = now + (slowed_down_ ? std::max(steps_[step_].patience, kSlowPatience) : steps_[step_].patience);
  slowed_down_ = slowed_down_ || steps_[step_].slows_down;
}

void Dialogue::finish_step(const std::string& trouble, Utime now) {
  const Step& step = steps_[step_];
  if (!trouble.empty()) {
    const std::string sentence = "the device does not " + step.purpose + ": " + trouble;
    if (step.required) return fail(sentence);
    if (!step.is_question) notes_.push_back(sentence);
  }
  ++step_;
  send_step(now);
}

void Dialogue::ask_for_status(Utime now) {
  if (waiting_ && now >= deadline_) {
    ++counters_.unanswered;
    waiting_ = false;
  }
  if (waiting_ || steps_.empty() || now < next_status_) return;
  step_ = (step_ + 1) % steps_.size();
  output_ += steps_[step_].request.frame;
  waiting_ = true;
  deadline_ = now + steps_[step_].patience;
  next_status_ = now + kStatusPeriod;
}

void Dialogue::handle(const Stretch& stretch, Utime now) {
  ++counters_.telegrams;
  Received received{stretch.bytes, std::nullopt, now};
  try {
    const Telegram telegram = open_frame(stretch.bytes);
    if (state_ == State::finding_dialect) return start(telegram.dialect, now);
    if (is_scan(telegram)) {
      received.scan = parse_scan(telegram);
      handle_scan(received, now);
    } else {
      handle_answer(telegram, now);
    }
  } catch (const BadTelegram& error) {
    if (++counters_.bad_telegrams == 1) notes_.push_back(std::string("a telegram cannot be read: ") + error.what());
  }
  received_.push_back(std::move(received));
}

void Dialogue::handle_scan(Received& received, Utime now) {
  ++counters_.scans;
  last_scan_ = now;
  check_counters(*received.scan);
  if (!std::exchange(first_scan_seen_, true)) check_mode(*received.scan);
}

void Dialogue::handle_answer(const Telegram& telegram, Utime now) {
  const bool refused = telegram.command == "sFA";
  if (refused) ++counters_.errors;
  if (!waiting_) return;
  const Step& step = steps_[step_];
  if (!refused && (telegram.command != step.request.answer || telegram.name != step.request.name)) return;
  std::string trouble;
  if (refused) {
    trouble = error_name(error_code(telegram));
  } else if (step.accept) {
    try {
      trouble = step.accept(telegram, info_);
    } catch (const BadTelegram& error) {
      ++counters_.bad_telegrams;
      trouble = std::string("its answer cannot be read: ") + error.what();
    }
  }
  if (state_ == State::starting) return finish_step(trouble, now);
  waiting_ = false;
  // What the device does not know it will not learn.
  if (refused) steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(step_));
}

void Dialogue::check_mode(const Scan& scan) {
  const auto wanted = find_mode(config_.scan.frequency, config_.scan.resolution);
  if (!wanted || wanted->interlaced || scan.channels_16_bit.empty()) return;
  const std::uint16_t step = scan.channels_16_bit.front().step;
  if (scan.scan_frequency == wanted->frequency && step == wanted->resolution) return;
  notes_.push_back("the scans come at " + in_words(scan.scan_frequency, step) + ", not at the " +
                   in_words(wanted->frequency, wanted->resolution) + " that were asked for");
}

void Dialogue::check_counters(const Scan& scan) {
  counters_.missed_telegrams += telegram_gap_.missing_before(scan.telegram_counter);
  counters_.missed_scans += scan_gap_.missing_before(scan.scan_counter) / std::max<unsigned>(1, config_.content.every);
}

void Dialogue::check_model() {
  if (info_.model.empty() || info_.model.find("LMS5") != std::string::npos) return;
  notes_.push_back("it is '" + info_.model + "', no LMS5xx: its scan modes and its sector are others");
}

Utime Dialogue::patience_for_scans() const {
  if (!first_scan_seen_) return kSlowPatience;
  const Utime period = 100 * kMicrosecondsPerSecond / std::max<Utime>(1, config_.scan.frequency);
  return kScanPatience + 3 * period * config_.content.every;
}

void Dialogue::fail(const std::string& reason) {
  state_ = State::failed;
  failure_ = reason;
}

}  // namespace scanway::sick
