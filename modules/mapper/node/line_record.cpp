#include "modules/mapper/node/line_record.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "common/messages/bad_message.h"
#include "modules/mapper/node/raw_input.h"

namespace scanway {
namespace {

constexpr Utime kInFlight = 100'000;  // From a line's end to the arrival of its last piece.

}  // namespace

void LineRecord::add(const laser_line_t& line) {
  const LinePiece piece = piece_of(line);
  const double lasts_us = piece.line.beam_period_us * piece.beams_of_line;
  if (lasts_us > static_cast<double>(kLongestLine) || !collector_.add(piece)) throw BadMessage("not of its line");
  if (std::exchange(numbered_since_, line.numbered_since) != line.numbered_since) times_.clear();
  times_.try_emplace(line.line, line.utime, line.utime + static_cast<Utime>(lasts_us));
}

void LineRecord::forget_before(Utime utime) {
  collector_.take_before(utime);
  while (!times_.empty() && times_.begin()->second.begin < utime) times_.erase(times_.begin());
}

LineStretches LineRecord::missing(const SweepTime& sweep, Utime newest, bool silent) const {
  LineStretches wanted = missing_at_edges(sweep, newest);
  for (const auto& stretch : collector_.missing()) {
    const auto behind = times_.upper_bound(stretch.second);
    const auto at = times_.lower_bound(stretch.first);
    const auto ahead = at == times_.begin() ? at : std::prev(at);
    const bool last = behind == times_.end();
    if (last && times_.rbegin()->second.end + kInFlight >= newest && !silent) continue;
    if (!last && behind->second.begin < sweep.started) continue;
    if (ahead != times_.end() && sweep.ended && ahead->second.begin > *sweep.ended) continue;
    wanted.push_back(stretch);
  }
  return wanted;
}

/// Before the first line that came, and behind the last.
LineStretches LineRecord::missing_at_edges(const SweepTime& sweep, Utime newest) const {
  if (times_.size() < 2) return {};
  const auto& [first, first_time] = *times_.begin();
  const auto& [last, last_time] = *times_.rbegin();
  const Utime period = std::max<Utime>(1, (last_time.begin - first_time.begin) / (last - first));
  LineStretches edges;
  const Utime lacks_ahead = (first_time.begin - sweep.started) / period;
  if (lacks_ahead > 0 && first > 0) edges.emplace_back(std::max<std::int64_t>(0, first - lacks_ahead), first - 1);
  if (!sweep.ended || newest < *sweep.ended + kInFlight) return edges;
  const Utime lacks_behind = (*sweep.ended - last_time.begin) / period;
  if (lacks_behind > 0) edges.emplace_back(last + 1, last + lacks_behind);
  return edges;
}

bool LineRecord::last_is_whole(Utime ended) const {
  const auto begun =
      std::find_if(times_.rbegin(), times_.rend(), [ended](const auto& line) { return line.second.begin <= ended; });
  const std::int64_t last = begun == times_.rend() ? -1 : begun->first;
  const LineStretches missing = collector_.missing();
  return std::none_of(missing.begin(), missing.end(),
                      [last](const auto& stretch) { return stretch.first <= last && last <= stretch.second; });
}

}  // namespace scanway
