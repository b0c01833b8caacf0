#include "modules/simulator/device/lms/telegram.h"

#include <algorithm>
#include <bit>
#include <cstdio>

#include "common/bytes/big_endian.h"

namespace scanway::simulator {
namespace {

constexpr char kStx = '\x02', kEtx = '\x03';
constexpr std::size_t kHead = 8, kLongest = 4096;

char checksum(std::string_view body) {
  char sum = 0;
  for (const char c : body) sum = static_cast<char>(sum ^ c);
  return sum;
}

std::string framed(Cola cola, const std::string& body) {
  if (cola == Cola::a) return kStx + body + kEtx;
  std::string frame(4, kStx);
  append_big_endian(frame, body.size(), 4);
  return frame + body + checksum(body);
}

std::uint32_t big_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (const char c : bytes) value = value << 8 | static_cast<std::uint8_t>(c);
  return value;
}

std::string hex(const char* format, std::uint32_t value) {
  char text[16];
  std::snprintf(text, sizeof text, format, static_cast<unsigned>(value));
  return text;
}

}  // namespace

TelegramWriter::TelegramWriter(Cola cola, std::string_view command, std::string_view name) : cola_(cola) {
  body_ = std::string(command) + ' ' + std::string(name);
  if (cola == Cola::b) body_ += ' ';  // Even where nothing follows.
}

TelegramWriter& TelegramWriter::number(std::uint32_t value, int size) {
  if (cola_ == Cola::b) {
    append_big_endian(body_, value, size);
  } else {
    body_ += hex(" %X", value);
  }
  return *this;
}

TelegramWriter& TelegramWriter::f32(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  if (cola_ == Cola::b) return u32(bits);
  body_ += hex(" %08X", bits);
  return *this;
}

TelegramWriter& TelegramWriter::characters(std::string_view text) {
  if (cola_ == Cola::a) body_ += ' ';
  body_ += text;
  return *this;
}

std::string TelegramWriter::frame() const { return framed(cola_, body_); }

std::string error_telegram(Cola cola, unsigned code) {
  std::string body = "sFA";
  if (cola == Cola::a) {
    body += hex(" %X", code);
  } else {
    append_big_endian(body, code, 2);  // Recorded: no blank before it.
  }
  return framed(cola, body);
}

std::uint32_t HostValues::number(std::size_t size) {
  if (cola_ == Cola::a) return text_number();
  if (left_.size() < size) throw ValueMissing();
  const std::uint32_t value = big_endian(left_.substr(0, size));
  left_.remove_prefix(size);
  return value;
}

/// "9C4" is hexadecimal, "+2500" and "-50000" are decimal.
std::uint32_t HostValues::text_number() {
  left_.remove_prefix(std::min(left_.find_first_not_of(' '), left_.size()));
  const std::string token(left_.substr(0, left_.find(' ')));
  left_.remove_prefix(token.size());
  const bool decimal = token.starts_with('+') || token.starts_with('-');
  const std::string_view digits = decimal ? "0123456789" : "0123456789ABCDEFabcdef";
  const std::string_view number = std::string_view(token).substr(decimal ? 1 : 0);
  if (number.empty() || number.size() > 10 || number.find_first_not_of(digits) != number.npos) throw ValueMissing();
  return static_cast<std::uint32_t>(std::stoll(token, nullptr, decimal ? 10 : 16));
}

std::optional<HostRequest> HostRequests::next() {
  HostRequest request;
  while (const auto body = next_body(request.cola)) {
    if (body->size() < 5 || (*body)[3] != ' ') continue;
    const std::size_t blank = body->find(' ', 4);
    request.command = body->substr(0, 3);
    request.name = body->substr(4, blank == body->npos ? blank : blank - 4);
    request.values = blank == body->npos ? "" : body->substr(blank + 1);
    return request;
  }
  return std::nullopt;
}

std::optional<std::string> HostRequests::next_body(Cola& cola) {
  for (;; waiting_.erase(0, 1)) {
    waiting_.erase(0, std::min(waiting_.find(kStx), waiting_.size()));
    if (waiting_.size() < 2) return std::nullopt;
    if (waiting_[1] != kStx) {
      const std::size_t end = waiting_.find(kEtx);
      if (end == waiting_.npos && waiting_.size() < kLongest) return std::nullopt;
      if (end == waiting_.npos) continue;
      const std::string body = waiting_.substr(1, end - 1);
      waiting_.erase(0, end + 1);
      cola = Cola::a;
      return body;
    }
    if (waiting_.size() < kHead) return std::nullopt;
    const std::size_t length = big_endian(std::string_view(waiting_).substr(4, 4));
    if (!waiting_.starts_with(std::string(4, kStx)) || length > kLongest) continue;
    if (waiting_.size() < kHead + length + 1) return std::nullopt;
    const std::string body = waiting_.substr(kHead, length);
    if (checksum(body) != waiting_[kHead + length]) continue;
    waiting_.erase(0, kHead + length + 1);
    cola = Cola::b;
    return body;
  }
}

}  // namespace scanway::simulator
