#include "modules/sick_bridge/device/lms_device.h"

#include <utility>

#include "common/clock/host_time.h"

namespace scanway::sick {
namespace {

constexpr Utime kConnectPatience = 5 * kMicrosecondsPerSecond;

void add(DialogueCounters& sum, const DialogueCounters& more) {
  sum.telegrams += more.telegrams;
  sum.scans += more.scans;
  sum.missed_scans += more.missed_scans;
  sum.missed_telegrams += more.missed_telegrams;
  sum.bad_telegrams += more.bad_telegrams;
  sum.bad_bytes += more.bad_bytes;
  sum.errors += more.errors;
  sum.unanswered += more.unanswered;
}

}  // namespace

LmsDevice::LmsDevice(const LmsAddress& address, const LmsConfig& config)
    : config_(config), client_(address.host, address.port) {}

LmsNews LmsDevice::run(int timeout_ms) {
  LmsNews news;
  connect_if_due(steady_now());
  const auto bytes = client_.poll(timeout_ms);
  const Utime now = steady_now();
  if (client_.state() == TcpClient::State::connected || !bytes.empty()) talk(bytes, now, news);
  if (dialogue_ && dialogue_->state() == Dialogue::State::failed) {
    give_up(client_.name() + ": " + dialogue_->failure(), now, news);
  } else if (!client_.trouble().empty()) {
    give_up(client_.trouble(), now, news);
  } else if (client_.state() == TcpClient::State::connecting && now - connecting_since_ > kConnectPatience) {
    give_up(client_.name() + ": no connection within 5 s; check the address, the cable and the power", now, news);
  }
  return news;
}

DialogueCounters LmsDevice::counters() const {
  DialogueCounters sum = earlier_;
  if (dialogue_) add(sum, dialogue_->counters());
  return sum;
}

void LmsDevice::connect_if_due(Utime now) {
  if (client_.state() != TcpClient::State::closed || !client_.trouble().empty() || !back_off_.due(now)) return;
  connecting_since_ = now;
  client_.connect();
}

void LmsDevice::talk(const std::vector<std::uint8_t>& bytes, Utime now, LmsNews& news) {
  if (!dialogue_) {
    ++connections_;
    clock_.restart();
    dialogue_.emplace(config_, now);
  }
  dialogue_->receive(bytes, now);
  dialogue_->tick(now);
  client_.send(dialogue_->take_output());
  collect(news);
}

void LmsDevice::collect(LmsNews& news) {
  const Utime arrival = host_now();
  for (Received& received : dialogue_->take_received()) {
    news.frames.push_back(std::move(received.frame));
    if (!received.scan) continue;
    // The telegram left when the device says so; only the way since then is unknown.
    clock_.observe(received.scan->transmission_time_us, arrival);
    const auto utime = clock_.to_host(received.scan->start_time_us);
    news.scans.push_back({std::move(*received.scan), utime.value_or(arrival)});
    back_off_.succeeded();
  }
  for (std::string& note : dialogue_->take_notes()) news.notes.push_back(client_.name() + ": " + note);
}

void LmsDevice::give_up(const std::string& reason, Utime now, LmsNews& news) {
  if (back_off_.failed(reason, now)) news.notes.push_back(reason);
  if (dialogue_) add(earlier_, dialogue_->counters());
  dialogue_.reset();
  client_.close();
}

}  // namespace scanway::sick
