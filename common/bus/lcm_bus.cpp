#include "common/bus/lcm_bus.h"

#include <lcm/lcm.h>

#include <utility>

#include "common/files/input_error.h"
#include "common/files/printable.h"

#include "common/bus/lcm_url.h"

namespace scanway {
namespace {

// Paced senders and this much room: a reader may sleep for half a second.
constexpr std::size_t kReceiveBuffer = std::size_t{4} << 20;
constexpr int kReceiveWaitMs = 50;
constexpr auto kReconnectWait = std::chrono::milliseconds(500);

// LCM takes a regular expression.
std::string exactly(std::string_view channel) {
  std::string pattern;
  for (const char c : channel) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_') pattern += '\\';
    pattern += c;
  }
  return pattern;
}

}  // namespace

LcmBus::LcmBus(const std::string& url)
    : url_(url), advice_(receive_buffer_advice(url, granted_receive_buffer(kReceiveBuffer))) {
  check_lcm_url(url);
  lcm_ = lcm_create(with_receive_buffer(url, kReceiveBuffer).c_str());
  if (lcm_ == nullptr) {
    throw InputError("--lcm-url " + printable(url) + ": LCM does not start; it may have said why above. Check the " +
                     "URL's options, the network's interface and its firewall");
  }
  receiver_ = std::thread([this] { receive(); });
}

LcmBus::~LcmBus() {
  ending_ = true;
  receiver_.join();
  lcm_destroy(lcm_);
}

void LcmBus::publish(std::string_view channel, std::span<const std::uint8_t> bytes, Utime) {
  const std::string name(channel);
  if (lcm_publish(lcm_, name.c_str(), bytes.data(), static_cast<unsigned>(bytes.size())) != 0) ++failed_publications_;
}

void LcmBus::subscribe(std::string_view channel, Handler handler) {
  const bool heard_already = subscriptions_.has(channel);
  subscriptions_.add(channel, std::move(handler));
  if (heard_already) return;  // LCM would copy each message once a subscription.
  listen(exactly(channel));
}

void LcmBus::subscribe_all(Handler handler) {
  onlooker_ = std::move(handler);
  listen(".*");
}

void LcmBus::listen(const std::string& pattern) {
  lcm_subscription_t* const subscription = lcm_subscribe(lcm_, pattern.c_str(), &LcmBus::copy, &inbox_);
  if (subscription == nullptr) {
    throw InputError("--lcm-url " + printable(url_) + ": LCM cannot listen there; it may have said why above");
  }
  lcm_subscription_set_queue_capacity(subscription, 0);
}

std::size_t LcmBus::dispatch(std::chrono::milliseconds wait) {
  const auto messages = inbox_.take(wait);
  for (const Inbox::Waiting& message : messages) {
    subscriptions_.deliver({message.channel, message.bytes, 0});
    if (onlooker_) onlooker_({message.channel, message.bytes, 0});
  }
  return messages.size();
}

void LcmBus::copy(const lcm_recv_buf_t* message, const char* channel, void* inbox) {
  static_cast<Inbox*>(inbox)->push(channel, {static_cast<const std::uint8_t*>(message->data), message->data_size});
}

void LcmBus::receive() {
  while (!ending_) {
    // Without a connection (tcpq) there is nothing to wait on; lcm_handle() then tries to connect again.
    const bool connected = lcm_get_fileno(lcm_) >= 0;
    const int handled = connected ? lcm_handle_timeout(lcm_, kReceiveWaitMs) : lcm_handle(lcm_);
    if (handled < 0) std::this_thread::sleep_for(kReconnectWait);
  }
}

}  // namespace scanway
