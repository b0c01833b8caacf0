#include "modules/sick_bridge/device/lms_device.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <functional>

#include "modules/sick_bridge/device/probe.h"
#include "tests/modules/sick_bridge/scripted_lms.h"

namespace scanway::test {
namespace {

/// A device on the loopback interface, in this process: `answer` says what it sends for what it gets.
class LoopbackServer {
 public:
  using Answer = std::function<std::string(const std::string&)>;

  explicit LoopbackServer(Answer answer) : answer_(std::move(answer)) {
    listener_ = FileDescriptor(socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    if (bind(listener_.get(), reinterpret_cast<sockaddr*>(&address), size) != 0 || listen(listener_.get(), 4) != 0 ||
        getsockname(listener_.get(), reinterpret_cast<sockaddr*>(&address), &size) != 0) {
      ADD_FAILURE() << "no socket on the loopback interface";
    }
    port_ = ntohs(address.sin_port);
  }

  std::uint16_t port() const { return port_; }

  void run() {
    if (!client_.is_open()) client_ = FileDescriptor(accept4(listener_.get(), nullptr, nullptr, SOCK_NONBLOCK));
    if (!client_.is_open()) return;
    char bytes[4096];
    const ssize_t count = recv(client_.get(), bytes, sizeof bytes, 0);
    if (count == 0) client_.close();
    if (count > 0) send(answer_({bytes, static_cast<std::size_t>(count)}));
  }

  void send(const std::string& bytes) {
    for (std::size_t at = 0; at < bytes.size();) {
      const ssize_t count = ::send(client_.get(), bytes.data() + at, bytes.size() - at, MSG_NOSIGNAL);
      if (count <= 0) break;
      at += static_cast<std::size_t>(count);
    }
  }

  void hang_up() { client_.close(); }
  void stop_listening() { listener_.close(); }

 private:
  Answer answer_;
  FileDescriptor listener_, client_;
  std::uint16_t port_ = 0;
};

sick::LmsAddress address_of(const LoopbackServer& server) { return {"127.0.0.1", server.port()}; }

/// Runs both until `done` says so, at most `rounds` times.
template <class Done>
sick::LmsNews run(sick::LmsDevice& device, LoopbackServer& server, const Done& done, int rounds = 4000) {
  sick::LmsNews all;
  for (int i = 0; i < rounds && !done(all); ++i) {
    server.run();
    sick::LmsNews news = device.run(1);
    for (auto& scan : news.scans) all.scans.push_back(std::move(scan));
    for (auto& frame : news.frames) all.frames.push_back(std::move(frame));
    for (auto& note : news.notes) all.notes.push_back(std::move(note));
  }
  return all;
}

TEST(LmsDevice, TheRecordedLms511OverASocket) {
  SKIP_WITHOUT_LMS_DATA();
  ScriptedLms script;
  LoopbackServer server([&](const std::string& bytes) { return script.answer(bytes); });
  sick::LmsDevice device(address_of(server), {});
  const auto news = run(device, server, [](const auto& all) { return all.scans.size() >= 5; });
  ASSERT_EQ(news.scans.size(), 5U);
  EXPECT_TRUE(device.measuring());
  EXPECT_EQ(news.scans[0].scan.telegram_counter, 54098);
  // Each was measured some 41 ms before the device sent it, and it was sent before it came.
  const Utime now =
      std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::system_clock::now().time_since_epoch())
          .count();
  for (const auto& timed : news.scans) {
    EXPECT_LT(timed.utime, now - (timed.scan.transmission_time_us - timed.scan.start_time_us) + 1);
    EXPECT_GT(timed.utime, now - 60 * kMicrosecondsPerSecond);
  }
}

TEST(LmsDevice, ComesBackByItselfWhenTheDeviceHangsUp) {
  SKIP_WITHOUT_LMS_DATA();
  ScriptedLms script;
  LoopbackServer server([&](const std::string& bytes) { return script.answer(bytes); });
  sick::LmsDevice device(address_of(server), {});
  run(device, server, [](const auto& all) { return !all.scans.empty(); });
  ASSERT_TRUE(device.measuring());
  server.hang_up();
  const auto news = run(device, server, [](const auto& all) { return !all.scans.empty(); });
  EXPECT_EQ(device.connections(), 2);
  EXPECT_FALSE(news.scans.empty());
  ASSERT_FALSE(news.notes.empty());
  EXPECT_NE(news.notes[0].find("the device closed the connection"), std::string::npos);
}

TEST(LmsDevice, AnAbsentDeviceIsOneLineNotOneAnAttempt) {
  LoopbackServer server([](const std::string&) { return std::string(); });
  server.stop_listening();
  sick::LmsDevice device(address_of(server), {});
  std::vector<std::string> notes;
  for (int i = 0; i < 30; ++i) {
    for (const auto& note : device.run(50).notes) notes.push_back(note);
  }
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("Connection refused; is that the port of the device (2112 or 2111)"), std::string::npos);
}

TEST(LmsProbe, SaysWhyThereAreNoScans) {
  LoopbackServer server([](const std::string&) { return std::string(); });
  server.stop_listening();
  const auto result = sick::probe_lms(address_of(server), {}, 5);
  EXPECT_FALSE(result.works);
  EXPECT_EQ(result.lines.size(), 2U);
}

}  // namespace
}  // namespace scanway::test
