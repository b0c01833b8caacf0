#include "modules/mapper/node/line_asker.h"

#include <algorithm>

namespace scanway {
namespace {

// The bridge keeps a line for a minute: 0.25 s, 0.5 s, ... 8 s, 8 s, 8 s, 8 s are 48 s.
constexpr Utime kFirstPause = 250'000;
constexpr int kDoublings = 5;
constexpr int kMostTimes = 10;
// Of one request: what fits into one frame, and what the bridge sends again within a second or two.
constexpr std::size_t kMostStretches = 75;
constexpr std::int64_t kMostLines = 200;

void add_line(line_request_t& request, std::int64_t line) {
  if (!request.end_line.empty() && request.end_line.back() == line) {
    ++request.end_line.back();
    return;
  }
  request.first_line.push_back(line);
  request.end_line.push_back(line + 1);
}

}  // namespace

bool LineAsker::is_due(std::int64_t line, Utime now) const {
  const auto asked = asked_.find(line);
  return asked == asked_.end() || (asked->second.times < kMostTimes && asked->second.next <= now);
}

std::optional<line_request_t> LineAsker::ask(const LineStretches& missing, std::int64_t numbered_since, Utime now) {
  if (numbered_since_ != numbered_since) asked_.clear();
  numbered_since_ = numbered_since;
  line_request_t request{};
  request.utime = now;
  request.numbered_since = numbered_since;
  std::int64_t lines = 0;
  for (const auto& [first, last] : missing) {
    for (std::int64_t line = first; line <= last && lines < kMostLines; ++line) {
      if (request.first_line.size() >= kMostStretches) break;
      if (!is_due(line, now)) continue;
      Asked& asked = asked_[line];
      asked.next = now + (kFirstPause << std::min(asked.times++, kDoublings));
      add_line(request, line);
      ++lines;
    }
  }
  if (lines == 0) return std::nullopt;
  request.nranges = static_cast<std::int32_t>(request.first_line.size());
  ++requests_;
  lines_asked_ += lines;
  return request;
}

void LineAsker::hurry() {
  for (auto& [line, asked] : asked_) asked.next = 0;
}

}  // namespace scanway
