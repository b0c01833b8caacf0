#include "modules/sick_bridge/node/sick_node.h"

#include <fmt/format.h>

#include <utility>

#include "bot_core/raw_t.hpp"
#include "common/bus/channels.h"
#include "common/clock/host_time.h"
#include "common/messages/codec.h"
#include "modules/sick_bridge/core/names.h"
#include "modules/sick_bridge/node/line_message.h"
#include "scanway/line_request_t.hpp"

namespace scanway::sick {
namespace {

constexpr unsigned kStateReady = 1;  // Of SCdevicestate; 0, busy, is said while somebody is logged in.

std::int64_t count(std::uint64_t value) { return static_cast<std::int64_t>(value); }

std::string welcome_of(const LmsDevice& device) {
  const DeviceInfo& info = device.dialogue()->info();
  const auto dialect = device.dialogue()->dialect();
  return fmt::format("{}: {} {} sends scans ({})", device.name(), info.model.empty() ? "the scanner" : info.model,
                     info.firmware, dialect ? name_of(*dialect) : "?");
}

}  // namespace

SickNode::SickNode(Bus& bus, LmsDevice& device, Utime numbered_since, const SickOptions& options)
    : bus_(bus), device_(device), numbered_since_(numbered_since), options_(options), archive_(options.archive) {
  bus_.subscribe(channel::kLineRequest.name, [this](const BusMessage& message) { take_request(message); });
}

std::vector<std::string> SickNode::run(int timeout_ms) {
  LmsNews news = device_.run(timeout_ms);
  if (device_.connections() != connection_) {
    connection_ = device_.connections();
    works_ = false;
    complaint_.clear();
  }
  if (!news.notes.empty()) complaint_ = news.notes.back();
  if (options_.raw) {
    for (const auto& frame : news.frames) publish_raw(frame);
  }
  for (const TimedScan& timed : news.scans) publish(timed);
  archive_.pump(steady_now(), [this](const auto& message) { bus_.publish(channel::kLaserLine.name, message, 0); });
  return std::move(news.notes);
}

std::string SickNode::take_welcome() { return std::exchange(welcome_, {}); }

std::string SickNode::summary() const {
  if (!device_.trouble().empty()) return device_.trouble();
  if (!works_ || device_.dialogue() == nullptr) return device_.name() + ": no scans yet";
  std::vector<std::string> sentences;
  if (device_status_ != 0) sentences.push_back("the scanner reports " + device_status_text(device_status_));
  const DeviceInfo& info = device_.dialogue()->info();
  if (info.contamination.value_or(0) != 0) {
    sentences.push_back("dirt on the scanner's window: " + contamination_name(*info.contamination));
  }
  if (info.device_state.value_or(kStateReady) > kStateReady) {
    sentences.push_back("the scanner's state is " + device_state_name(*info.device_state));
  }
  if (!complaint_.empty()) sentences.push_back(complaint_);
  return fmt::format("{}", fmt::join(sentences, "; "));
}

std::map<std::string, std::int64_t> SickNode::counters() const {
  const DialogueCounters device = device_.counters();
  const ArchiveCounters& archive = archive_.counters();
  const DeviceInfo info = device_.dialogue() != nullptr ? device_.dialogue()->info() : DeviceInfo{};
  return {{"sick_lines", lines_},
          {"sick_line_pieces", pieces_},
          {"sick_missed_scans", count(device.missed_scans)},
          {"sick_missed_telegrams", count(device.missed_telegrams)},
          {"sick_unusable_scans", unusable_scans_},
          {"sick_bad_telegrams", count(device.bad_telegrams)},
          {"sick_bad_bytes", count(device.bad_bytes)},
          {"sick_errors", count(device.errors)},
          {"sick_unanswered", count(device.unanswered)},
          {"sick_connections", device_.connections()},
          {"sick_clock_jumps", device_.clock_jumps()},
          {"sick_device_status", device_status_},
          {"sick_contamination", info.contamination.value_or(0)},
          {"sick_requests", requests_},
          {"sick_bad_requests", bad_requests_},
          {"sick_requests_of_other_numberings", other_numberings_},
          {"sick_lines_resent", archive.lines_resent},
          {"sick_lines_too_old", archive.lines_too_old},
          {"sick_lines_unknown", archive.lines_unknown},
          {"sick_lines_waiting", count(archive_.waiting())}};
}

void SickNode::take_request(const BusMessage& message) {
  try {
    // Of one frame, so that one request can make this process do only so much.
    if (message.bytes.size() > kMaxLineBytes) throw BadMessage("longer than one frame");
    const auto request = decode<line_request_t>(message.bytes);
    ++requests_;
    if (request.numbered_since != numbered_since_) {
      ++other_numberings_;
      return;
    }
    const SteadyTime now = steady_now();
    for (std::size_t i = 0; i < request.first_line.size(); ++i) {
      archive_.ask(request.first_line[i], request.end_line[i], now);
    }
  } catch (const BadMessage&) {
    ++bad_requests_;
  }
}

void SickNode::publish(const TimedScan& timed) {
  device_status_ = timed.scan.device_status;
  if (device_.dialogue() != nullptr && !std::exchange(works_, true)) welcome_ = welcome_of(device_);
  publish_line(timed);
  if (!options_.laser_scan) return;
  bus_.publish(channel::kLaserScan.name, encode(lidar_message(timed.scan, timed.utime)), timed.utime);
}

void SickNode::publish_line(const TimedScan& timed) {
  std::vector<LineArchive::Message> messages;
  for (const laser_line_t& piece : line_messages(timed.scan, {lines_, numbered_since_, timed.utime})) {
    messages.push_back(encode(piece));
    bus_.publish(channel::kLaserLine.name, messages.back(), timed.utime);
  }
  if (messages.empty()) {
    ++unusable_scans_;
    return;
  }
  ++lines_;
  pieces_ += count(messages.size());
  archive_.keep(std::move(messages), steady_now());
}

void SickNode::publish_raw(const std::vector<std::uint8_t>& frame) {
  bot_core::raw_t message{};
  message.utime = host_now();
  message.length = static_cast<std::int32_t>(frame.size());
  message.data = frame;
  bus_.publish(channel::kLaserRaw.name, encode(message), message.utime);
}

}  // namespace scanway::sick
