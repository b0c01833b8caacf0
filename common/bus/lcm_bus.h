#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>
#include <thread>

#include "common/bus/bus.h"
#include "common/bus/inbox.h"
#include "common/bus/subscriptions.h"

struct _lcm_t;
struct _lcm_recv_buf_t;

namespace scanway {

/// The bus over LCM, with any of its providers. A thread of its own takes what comes and only copies it; LCM's queues
/// have no limit, so that they drop nothing. Handlers run in dispatch(). publish() may be called from any thread.
class LcmBus : public Bus {
 public:
  /// Throws InputError with one line when there can be no bus at `url`.
  explicit LcmBus(const std::string& url);
  ~LcmBus() override;
  LcmBus(const LcmBus&) = delete;
  LcmBus& operator=(const LcmBus&) = delete;

  void publish(std::string_view channel, std::span<const std::uint8_t> bytes, Utime utime) override;
  /// Not while dispatch() runs in another thread.
  void subscribe(std::string_view channel, Handler handler) override;
  /// All channels, for whoever looks on; instead of subscribe(), not beside it.
  void subscribe_all(Handler handler);

  /// Delivers what has come; waits up to `wait` when nothing has. Returns the number delivered.
  std::size_t dispatch(std::chrono::milliseconds wait);

  std::uint64_t failed_publications() const { return failed_publications_; }
  /// What should be set better on this machine, in one line; empty: nothing.
  const std::string& advice() const { return advice_; }

 private:
  static void copy(const _lcm_recv_buf_t* message, const char* channel, void* inbox);
  void receive();
  void listen(const std::string& pattern);

  std::string url_;
  std::string advice_;
  _lcm_t* lcm_;
  Inbox inbox_;
  Subscriptions subscriptions_;
  Handler onlooker_;
  std::atomic<std::uint64_t> failed_publications_ = 0;
  std::atomic<bool> ending_ = false;
  std::thread receiver_;
};

}  // namespace scanway
