#include "modules/simulator/device/ends/terminal_end.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "common/files/input_error.h"

namespace scanway::simulator {
namespace {

constexpr int kMostUnread = 3000;  // Bytes; a terminal holds 4096.

constexpr std::pair<speed_t, int> kRates[] = {{B9600, 9600},     {B19200, 19200},   {B38400, 38400},
                                              {B57600, 57600},   {B115200, 115200}, {B230400, 230400},
                                              {B460800, 460800}, {B921600, 921600}};

[[noreturn]] void refuse(const std::string& link, const std::string& what) { throw InputError(link + ": " + what); }

void make_link(const std::string& target, const std::string& link) {
  struct stat status {};
  if (lstat(link.c_str(), &status) == 0) {
    if (!S_ISLNK(status.st_mode)) refuse(link, "there is a file of another kind; choose another name");
    unlink(link.c_str());
  }
  if (symlink(target.c_str(), link.c_str()) != 0) refuse(link, "cannot be made: " + reason_of(errno));
}

}  // namespace

TerminalEnd::TerminalEnd(std::string link)
    : link_(std::move(link)), device_(posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)) {
  if (!device_.is_open() || grantpt(device_.get()) != 0 || unlockpt(device_.get()) != 0) {
    refuse(link_, "no pseudo-terminal: " + reason_of(errno));
  }
  const std::string name = ptsname(device_.get());
  // Held open, so that the line stays when the host closes its end; and raw, since a serial line does not echo.
  host_ = FileDescriptor(open(name.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  termios settings{};
  tcgetattr(host_.get(), &settings);
  cfmakeraw(&settings);
  tcsetattr(host_.get(), TCSANOW, &settings);
  make_link(name, link_);
}

TerminalEnd::~TerminalEnd() { unlink(link_.c_str()); }

std::vector<std::uint8_t> TerminalEnd::hear() {
  std::vector<std::uint8_t> bytes(1024);
  const ssize_t count = read(device_.get(), bytes.data(), bytes.size());
  bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  return bytes;
}

bool TerminalEnd::say(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return true;
  int unread = 0;
  if (ioctl(host_.get(), FIONREAD, &unread) == 0 && unread > kMostUnread) {
    tcflush(host_.get(), TCIFLUSH);  // A line keeps nothing for who does not listen.
    return false;
  }
  return write(device_.get(), bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
}

int TerminalEnd::baud() const {
  termios settings{};
  tcgetattr(host_.get(), &settings);
  for (const auto& [code, rate] : kRates) {
    if (cfgetospeed(&settings) == code) return rate;
  }
  return 0;
}

}  // namespace scanway::simulator
