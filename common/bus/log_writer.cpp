#include "common/bus/log_writer.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "common/bus/log_format.h"

namespace scanway {

namespace {

constexpr std::size_t kFlushAt = std::size_t{1} << 20;

std::string_view as_text(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

LogWriter::LogWriter(std::string path) : file_(std::move(path)) {}

void LogWriter::write(std::string_view channel, std::span<const std::uint8_t> bytes, Utime utime) {
  using namespace log_format;
  if (channel.empty() || channel.size() > kMaxChannelBytes || bytes.size() > INT32_MAX) {
    throw std::invalid_argument("no LCM event: channel '" + std::string(channel) + "', " +
                                std::to_string(bytes.size()) + " bytes");
  }
  std::array<std::uint8_t, kHeaderBytes> header{};
  std::copy(kSync.begin(), kSync.end(), header.begin());
  put(static_cast<std::uint64_t>(events_), &header[kNumberAt]);
  put(static_cast<std::uint64_t>(utime), &header[kUtimeAt]);
  put(static_cast<std::uint32_t>(channel.size()), &header[kChannelLengthAt]);
  put(static_cast<std::uint32_t>(bytes.size()), &header[kDataLengthAt]);
  waiting_ += as_text(header);
  waiting_ += channel;
  waiting_ += as_text(bytes);
  ++events_;
  if (waiting_.size() >= kFlushAt) flush();
}

void LogWriter::flush() {
  file_.write(waiting_);
  waiting_.clear();
}

void LogWriter::close() {
  flush();
  file_.commit();
}

}  // namespace scanway
