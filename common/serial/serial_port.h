#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "common/files/file_descriptor.h"

namespace scanway {

/// A serial port (RS-232, USB serial, a pseudo-terminal): raw bytes, 8 data bits, no parity, 1 stop bit, no flow
/// control. Every error is an InputError of one line that names the port and says what to do; after an error of read()
/// or write() the port is gone, and a new one has to be opened.
class SerialPort {
 public:
  /// Opens the port for this process alone. `baud` is one of the rates that termios knows, 1200 to 4000000.
  SerialPort(std::string path, int baud);

  /// Changes the rate and throws away what was received at the old one.
  void set_baud(int baud);
  /// Waits at most `timeout_ms` for bytes. Returns how many it put at the beginning of `buffer`; 0: none came.
  std::size_t read(std::span<std::uint8_t> buffer, int timeout_ms);
  /// Hands all bytes to the port. Throws, too, when the port does not take them for half a second.
  void write(std::span<const std::uint8_t> bytes);

  const std::string& path() const { return path_; }
  int baud() const { return baud_; }
  /// For poll(): readable when read() would return bytes.
  int descriptor() const { return port_.get(); }

 private:
  std::string path_;
  int baud_ = 0;
  FileDescriptor port_;
};

}  // namespace scanway
