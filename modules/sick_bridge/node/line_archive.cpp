#include "modules/sick_bridge/node/line_archive.h"

#include <algorithm>
#include <utility>

namespace scanway::sick {
namespace {

// What a request makes up at will counts as so many, so that no counter overflows.
constexpr std::int64_t kMostUnknown = 1'000'000;

std::size_t bytes_of(const std::vector<LineArchive::Message>& messages) {
  std::size_t bytes = 0;
  for (const auto& message : messages) bytes += message.size();
  return bytes;
}

}  // namespace

LineArchive::LineArchive(const ArchiveLimits& limits)
    : limits_(limits), bucket_(limits.bytes_per_second, limits.burst_bytes) {}

void LineArchive::keep(std::vector<Message> messages, SteadyTime now) {
  bytes_ += bytes_of(messages);
  lines_.push_back({std::move(messages), now, 0});
  forget(now);
}

void LineArchive::ask(std::int64_t first, std::int64_t end_asked, SteadyTime now) {
  forget(now);
  first = std::max<std::int64_t>(first, 0);
  if (end_asked <= first) return;
  counters_.lines_too_old += std::max<std::int64_t>(0, std::min(end_asked, first_) - first);
  counters_.lines_unknown += std::clamp<std::int64_t>(end_asked - std::max(first, end()), 0, kMostUnknown);
  for (std::int64_t number = std::max(first, first_); number < std::min(end_asked, end()); ++number) {
    const SteadyTime resent = line(number).resent;
    if (resent == 0 || now - resent >= limits_.pause) wanted_.insert(number);
  }
}

void LineArchive::pump(SteadyTime now, const std::function<void(const Message&)>& send) {
  forget(now);
  bucket_.refill(now);
  while (!wanted_.empty()) {
    Line& wanted = line(*wanted_.begin());
    if (!bucket_.take(static_cast<double>(bytes_of(wanted.messages)))) return;
    for (const Message& message : wanted.messages) send(message);
    wanted.resent = now;
    ++counters_.lines_resent;
    wanted_.erase(wanted_.begin());
  }
}

void LineArchive::forget(SteadyTime now) {
  while (!lines_.empty() && (now - lines_.front().kept > limits_.age || bytes_ > limits_.bytes)) {
    bytes_ -= bytes_of(lines_.front().messages);
    lines_.pop_front();
    counters_.lines_too_old += static_cast<std::int64_t>(wanted_.erase(first_++));
  }
}

}  // namespace scanway::sick
