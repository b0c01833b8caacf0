#include "modules/tools/spy/screen.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <sstream>

namespace scanway::tools {
namespace {

constexpr const char* kHome = "\033[H";
constexpr const char* kClearRestOfLine = "\033[K";
constexpr const char* kClearBelow = "\033[J";

/// At most `columns` characters; a character may be several bytes.
std::string cut_to(const std::string& line, std::size_t columns) {
  std::size_t shown = 0, end = 0;
  while (end < line.size()) {
    const bool begins = (static_cast<unsigned char>(line[end]) & 0xC0) != 0x80;
    if (begins && ++shown > columns) break;
    ++end;
  }
  return line.substr(0, end);
}

}  // namespace

Screen::Screen() : terminal_(isatty(STDOUT_FILENO) == 1) {}

void Screen::show(const std::string& text) const {
  winsize size{};
  if (!terminal_ || ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_row == 0 || size.ws_col == 0) {
    std::fputs(text.c_str(), stdout);
    std::fflush(stdout);
    return;
  }
  std::istringstream lines(text);
  std::string line, picture = kHome;
  for (int row = 0; row + 1 < size.ws_row && std::getline(lines, line); ++row) {
    picture += cut_to(line, size.ws_col) + kClearRestOfLine + "\r\n";
  }
  picture += kClearBelow;
  std::fputs(picture.c_str(), stdout);
  std::fflush(stdout);
}

}  // namespace scanway::tools
