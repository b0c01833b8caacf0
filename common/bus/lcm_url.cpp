#include "common/bus/lcm_url.h"

#include <arpa/inet.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "common/files/file_descriptor.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"

namespace scanway {
namespace {

constexpr const char* kDefaultUrl = "udpm://239.255.76.67:7667?ttl=0";
constexpr const char* kDefaultHost = "239.255.76.67";
constexpr std::size_t kEnoughBuffer = std::size_t{1} << 20;
constexpr std::uint16_t kDefaultPort = 7667;

struct Url {
  std::string provider;
  std::string host;
  std::uint16_t port = kDefaultPort;
};

[[noreturn]] void refuse(const std::string& url, const std::string& why) {
  throw InputError("--lcm-url " + printable(url) + ": " + why);
}

std::uint16_t port_of(const std::string& url, std::string_view text) {
  std::uint16_t port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  if (error != std::errc() || end != text.data() + text.size() || port == 0) {
    refuse(url, in_quotes(text) + " is no port; give one from 1 to 65535, as in " + kDefaultUrl);
  }
  return port;
}

Url parse(const std::string& url) {
  const std::size_t colon = url.find("://");
  if (colon == std::string::npos) refuse(url, std::string("not an LCM URL; give one like ") + kDefaultUrl);
  Url parsed;
  parsed.provider = url.substr(0, colon);
  std::string place = url.substr(colon + 3);
  place = place.substr(0, place.find('?'));
  const std::size_t port = place.rfind(':');
  parsed.host = place.substr(0, port);
  if (parsed.provider == "udpm" || parsed.provider == "mpudpm" || parsed.provider == "tcpq") {
    if (port != std::string::npos) parsed.port = port_of(url, std::string_view(place).substr(port + 1));
  } else if (parsed.provider != "memq") {
    refuse(url, "LCM has no provider " + in_quotes(parsed.provider) + " that is a bus; take udpm, tcpq or memq");
  }
  return parsed;
}

void check_multicast(const std::string& url, const Url& parsed) {
  sockaddr_in group{};
  group.sin_family = AF_INET;
  group.sin_port = htons(parsed.port);
  const std::string host = parsed.host.empty() ? kDefaultHost : parsed.host;
  if (inet_pton(AF_INET, host.c_str(), &group.sin_addr) != 1 || !IN_MULTICAST(ntohl(group.sin_addr.s_addr))) {
    refuse(url, in_quotes(host) + " is no multicast address; take one from 224.0.0.0 to 239.255.255.255");
  }
  const FileDescriptor probe(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  if (!probe.is_open()) refuse(url, "no UDP socket: " + reason_of(errno));
  if (::connect(probe.get(), reinterpret_cast<const sockaddr*>(&group), sizeof group) == 0) return;
  refuse(url, "no route for multicast (" + reason_of(errno) +
                  "); for one machine: ip link set lo up; ip route add 224.0.0.0/4 dev lo. For several: the same with "
                  "the network's interface, and ttl=1 in the URL");
}

void check_server(const std::string& url, const Url& parsed) {
  if (parsed.host.empty()) refuse(url, "names no server; give tcpq://HOST:PORT");
  addrinfo hints{};
  hints.ai_family = AF_INET;
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int error = ::getaddrinfo(parsed.host.c_str(), std::to_string(parsed.port).c_str(), &hints, &found);
  if (error != 0) refuse(url, "host " + in_quotes(parsed.host) + " is not known: " + gai_strerror(error));
  const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> addresses(found, ::freeaddrinfo);
  const FileDescriptor probe(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  if (probe.is_open() && ::connect(probe.get(), found->ai_addr, found->ai_addrlen) == 0) return;
  refuse(url, "no LCM server answers there (" + reason_of(errno) +
                  "); start one: java -cp /usr/share/java/lcm.jar lcm.lcm.TCPService " + std::to_string(parsed.port));
}

}  // namespace

std::string lcm_url(const std::string& chosen) {
  if (!chosen.empty()) return chosen;
  const char* const environment = std::getenv("LCM_DEFAULT_URL");
  return environment != nullptr && *environment != '\0' ? environment : kDefaultUrl;
}

void check_lcm_url(const std::string& url) {
  const Url parsed = parse(url);
  if (parsed.provider == "tcpq") check_server(url, parsed);
  if (parsed.provider == "udpm" || parsed.provider == "mpudpm") check_multicast(url, parsed);
}

std::string with_receive_buffer(const std::string& url, std::size_t bytes) {
  if (!url.starts_with("udpm://") || url.find("recv_buf_size=") != std::string::npos) return url;
  return url + (url.find('?') == std::string::npos ? "?" : "&") + "recv_buf_size=" + std::to_string(bytes);
}

std::string receive_buffer_advice(const std::string& url, std::size_t granted) {
  if (!url.starts_with("udpm") || granted >= kEnoughBuffer) return {};
  return "the kernel gives a receive buffer of only " + std::to_string(granted / 1024) +
         " kB, bursts may be lost; mend it: sysctl -w net.core.rmem_max=8388608";
}

std::size_t granted_receive_buffer(std::size_t bytes) {
  const FileDescriptor probe(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  int size = static_cast<int>(bytes);
  socklen_t length = sizeof size;
  ::setsockopt(probe.get(), SOL_SOCKET, SO_RCVBUF, &size, sizeof size);
  if (::getsockopt(probe.get(), SOL_SOCKET, SO_RCVBUF, &size, &length) != 0) return 0;
  return static_cast<std::size_t>(size) / 2;  // The kernel doubles what it grants, for its own book-keeping.
}

}  // namespace scanway
