#include "common/serial/serial_port.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "common/files/input_error.h"

namespace scanway {
namespace {

constexpr int kWriteTimeoutMs = 500;

struct Rate {
  int baud;
  speed_t speed;
};

constexpr Rate kRates[] = {
    {1200, B1200},       {2400, B2400},       {4800, B4800},       {9600, B9600},       {19200, B19200},
    {38400, B38400},     {57600, B57600},     {115200, B115200},   {230400, B230400},   {460800, B460800},
    {500000, B500000},   {576000, B576000},   {921600, B921600},   {1000000, B1000000}, {1152000, B1152000},
    {1500000, B1500000}, {2000000, B2000000}, {2500000, B2500000}, {3000000, B3000000}, {4000000, B4000000},
};

speed_t speed_of(int baud, const std::string& path) {
  for (const Rate& rate : kRates) {
    if (rate.baud == baud) return rate.speed;
  }
  throw InputError(path + ": " + std::to_string(baud) +
                   " baud is no rate of a serial port; use a common one, such as 38400 or 115200");
}

std::string advice(int error) {
  switch (error) {
    case ENOENT:
    case ENODEV:
    case ENXIO:
      return "; is the device plugged in and switched on? (ls /dev/serial/by-id)";
    case EACCES:
    case EPERM:
      return "; add the user to the group dialout";
    case EWOULDBLOCK:
    case EBUSY:
      return "; another program uses it: stop that one";
    default:
      return "; check the cable and the name of the port";
  }
}

[[noreturn]] void fail(const std::string& path, const char* what, int error) {
  throw InputError(path + ": " + what + ": " + reason_of(error) + advice(error));
}

/// Waits until the port is ready for `events`. False: not within the time.
bool ready(int descriptor, short events, int timeout_ms) {
  pollfd waiting{descriptor, events, 0};
  const int count = poll(&waiting, 1, timeout_ms);
  return count > 0;
}

}  // namespace

SerialPort::SerialPort(std::string path, int baud) : path_(std::move(path)) {
  speed_of(baud, path_);
  port_ = FileDescriptor(open(path_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (!port_.is_open()) fail(path_, "the serial port cannot be opened", errno);
  if (isatty(descriptor()) == 0) {
    throw InputError(path_ + ": this is no serial port; give the name of one, such as /dev/ttyUSB0");
  }
  if (flock(descriptor(), LOCK_EX | LOCK_NB) != 0) fail(path_, "the serial port cannot be opened", errno);
  set_baud(baud);
}

void SerialPort::set_baud(int baud) {
  const speed_t speed = speed_of(baud, path_);
  termios settings{};
  if (tcgetattr(descriptor(), &settings) != 0) fail(path_, "its settings cannot be read", errno);
  cfmakeraw(&settings);
  settings.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS | PARENB);
  settings.c_cflag |= CS8 | CLOCAL | CREAD;
  settings.c_iflag &= ~static_cast<tcflag_t>(IXOFF | IXANY);
  settings.c_cc[VMIN] = 0;
  settings.c_cc[VTIME] = 0;
  cfsetispeed(&settings, speed);
  cfsetospeed(&settings, speed);
  if (tcsetattr(descriptor(), TCSANOW, &settings) != 0) fail(path_, "its settings cannot be changed", errno);
  // tcsetattr() is content when any one of the settings was taken.
  termios taken{};
  if (tcgetattr(descriptor(), &taken) != 0 || cfgetospeed(&taken) != speed) {
    throw InputError(path_ + ": the port does not do " + std::to_string(baud) +
                     " baud; choose another rate or adapter");
  }
  tcflush(descriptor(), TCIFLUSH);
  baud_ = baud;
}

std::size_t SerialPort::read(std::span<std::uint8_t> buffer, int timeout_ms) {
  if (!ready(descriptor(), POLLIN, timeout_ms)) return 0;
  const ssize_t count = ::read(descriptor(), buffer.data(), buffer.size());
  if (count > 0) return static_cast<std::size_t>(count);
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return 0;
  // A port that poll() calls readable and that has nothing to read has hung up.
  fail(path_, "the serial port is gone", count < 0 ? errno : ENODEV);
}

void SerialPort::write(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor(), bytes.data(), bytes.size());
    if (count > 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    } else if (count < 0 && errno != EAGAIN && errno != EINTR) {
      fail(path_, "the serial port is gone", errno);
    } else if (!ready(descriptor(), POLLOUT, kWriteTimeoutMs)) {
      throw InputError(path_ + ": the serial port takes no more bytes; check the adapter and unplug it once");
    }
  }
}

}  // namespace scanway
