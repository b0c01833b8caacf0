#include "tests/live/tool/relay.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include "common/clock/steady_time.h"
#include "common/files/file_descriptor.h"
#include "common/random/random.h"

namespace scanway::test {
namespace {

using Datagram = std::vector<char>;
constexpr int kBuffer = 8 << 20;
constexpr std::size_t kLcmHeader = 8;

volatile std::sig_atomic_t ending = 0;

void require(bool done, const char* what) {
  if (!done) throw std::runtime_error(std::string("relay: ") + what);
}

/// One of the two groups: what others say there, and what the relay says there.
class Group {
 public:
  explicit Group(const std::string& text)
      : in_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)), out_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    const std::size_t colon = text.find(':');
    require(colon != std::string::npos, "a group is ADDRESS:PORT");
    group_.sin_family = AF_INET;
    group_.sin_port = htons(static_cast<std::uint16_t>(std::stoi(text.substr(colon + 1))));
    require(::inet_pton(AF_INET, text.substr(0, colon).c_str(), &group_.sin_addr) == 1, "no address");
    const int on = 1;
    ::setsockopt(in_.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    ::setsockopt(in_.get(), SOL_SOCKET, SO_RCVBUF, &kBuffer, sizeof kBuffer);
    require(::bind(in_.get(), reinterpret_cast<const sockaddr*>(&group_), sizeof group_) == 0, "bind");
    const ip_mreq membership{group_.sin_addr, {htonl(INADDR_ANY)}};
    require(::setsockopt(in_.get(), IPPROTO_IP, IP_ADD_MEMBERSHIP, &membership, sizeof membership) == 0, "join");
    require(::connect(out_.get(), reinterpret_cast<const sockaddr*>(&group_), sizeof group_) == 0, "connect");
    const unsigned char stays_here = 0;
    ::setsockopt(out_.get(), IPPROTO_IP, IP_MULTICAST_TTL, &stays_here, sizeof stays_here);
    sockaddr_in mine{};
    socklen_t size = sizeof mine;
    ::getsockname(out_.get(), reinterpret_cast<sockaddr*>(&mine), &size);
    own_port_ = mine.sin_port;
  }

  int descriptor() const { return in_.get(); }
  /// What somebody else said; false: nothing more at the moment.
  bool hear(Datagram& datagram) const {
    for (;;) {
      datagram.resize(65536);
      sockaddr_in from{};
      socklen_t size = sizeof from;
      const ssize_t length = ::recvfrom(in_.get(), datagram.data(), datagram.size(), MSG_DONTWAIT,
                                        reinterpret_cast<sockaddr*>(&from), &size);
      if (length < 0) return false;
      datagram.resize(static_cast<std::size_t>(length));
      if (from.sin_port != own_port_) return true;
    }
  }
  void say(const Datagram& datagram) const { ::send(out_.get(), datagram.data(), datagram.size(), 0); }

 private:
  FileDescriptor in_, out_;
  sockaddr_in group_{};
  in_port_t own_port_ = 0;
};

std::string channel_of(const Datagram& datagram) {
  if (datagram.size() <= kLcmHeader) return "-";
  const auto end = std::find(datagram.begin() + kLcmHeader, datagram.end(), '\0');
  return {datagram.begin() + kLcmHeader, end};
}

/// What happens on the way from one group to the other.
class Way {
 public:
  Way(std::string name, const Group& from, const Group& to, const RelayOptions& options)
      : name_(std::move(name)), from_(from), to_(to), options_(options), random_(options.seed) {}

  void carry(SteadyTime now) {
    for (Datagram datagram; from_.hear(datagram); ++number_) {
      const std::string channel = channel_of(datagram);
      ++fates_[{"SENT", channel}];
      if (random_.uniform() < options_.lost) {
        ++fates_[{"LOST", channel}];
        continue;
      }
      if (random_.uniform() < options_.twice) {
        ++fates_[{"TWICE", channel}];
        hold(datagram, now);
      }
      hold(datagram, now);
    }
    for (; !held_.empty() && held_.begin()->first <= now; held_.erase(held_.begin())) {
      const Held& next = held_.begin()->second;
      if (next.number < newest_) ++fates_[{"OVERTAKEN", channel_of(next.datagram)}];
      newest_ = std::max(newest_, next.number);
      to_.say(next.datagram);
    }
  }
  void print() const {
    for (const auto& [fate, number] : fates_) {
      std::printf("%s %s %s %ld\n", name_.c_str(), fate.first.c_str(), fate.second.c_str(), number);
    }
  }

 private:
  struct Held {
    long number;  // In the order of arrival.
    Datagram datagram;
  };

  void hold(const Datagram& datagram, SteadyTime now) {
    const auto until = now + static_cast<SteadyTime>(random_.uniform() * options_.held_ms * 1000.0);
    held_.emplace(until, Held{number_, datagram});
  }

  std::string name_;
  const Group& from_;
  const Group& to_;
  RelayOptions options_;
  Random random_;
  std::multimap<SteadyTime, Held> held_;
  long number_ = 0, newest_ = 0;
  std::map<std::pair<std::string, std::string>, long> fates_;
};

}  // namespace

int relay(const std::string& group_a, const std::string& group_b, const RelayOptions& options) {
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { ending = 1; });
  const Group a(group_a), b(group_b);
  Way ab("ab", a, b, options), ba("ba", b, a, options);
  while (ending == 0) {
    pollfd ready[] = {{a.descriptor(), POLLIN, 0}, {b.descriptor(), POLLIN, 0}};
    ::poll(ready, 2, 1);
    ab.carry(steady_now());
    ba.carry(steady_now());
  }
  ab.print();
  ba.print();
  return 0;
}

}  // namespace scanway::test
