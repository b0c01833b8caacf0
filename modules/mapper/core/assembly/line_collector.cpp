#include "modules/mapper/core/assembly/line_collector.h"

#include <algorithm>

namespace scanway {
namespace {

constexpr std::int32_t kMostBeams = 100'000;

bool consistent(const LinePiece& piece) {
  const auto beams = static_cast<std::int64_t>(piece.line.range_counts.size());
  const bool rssi_fits =
      piece.line.rssi_counts.empty() || piece.line.rssi_counts.size() == piece.line.range_counts.size();
  return beams > 0 && rssi_fits && piece.first_beam >= 0 && piece.beams_of_line <= kMostBeams &&
         piece.first_beam + beams <= piece.beams_of_line;
}

void copy_counts(const std::vector<std::uint16_t>& from, std::vector<std::uint16_t>& to, std::int32_t first) {
  std::copy(from.begin(), from.end(), to.begin() + first);
}

}  // namespace

bool LineCollector::add(const LinePiece& piece) {
  if (!consistent(piece)) {
    ++bad_pieces_;
    return false;
  }
  if (numbered_since_ != piece.numbered_since) {
    lines_.clear();
    numbered_since_ = piece.numbered_since;
  }
  const auto beams = static_cast<std::size_t>(piece.beams_of_line);
  const auto [entry, is_new] = lines_.try_emplace(piece.line.number);
  Line& line = entry->second;
  if (is_new) {
    line.line = piece.line;
    line.line.range_counts.assign(beams, kNeverCame);
    line.line.rssi_counts.assign(piece.line.rssi_counts.empty() ? 0 : beams, 0);
    line.line.missing_beams = piece.beams_of_line;
    line.came.assign(beams, false);
  } else if (line.came.size() != beams || line.line.rssi_counts.empty() != piece.line.rssi_counts.empty() ||
             line.line.utime != piece.line.utime) {
    ++bad_pieces_;
    return false;
  }
  const std::int32_t missing_before = line.line.missing_beams;
  for (std::size_t i = 0; i < piece.line.range_counts.size(); ++i) {
    auto came = line.came[static_cast<std::size_t>(piece.first_beam) + i];
    if (!came) --line.line.missing_beams;
    came = true;
  }
  if (line.line.missing_beams == missing_before) {
    ++repeated_pieces_;
    return true;
  }
  copy_counts(piece.line.range_counts, line.line.range_counts, piece.first_beam);
  copy_counts(piece.line.rssi_counts, line.line.rssi_counts, piece.first_beam);
  if (lines_.size() > most_lines_) lines_.erase(lines_.begin());
  return true;
}

std::vector<std::pair<std::int64_t, std::int64_t>> LineCollector::missing() const {
  std::vector<std::pair<std::int64_t, std::int64_t>> stretches;
  const auto add_stretch = [&](std::int64_t first, std::int64_t last) {
    if (!stretches.empty() && stretches.back().second + 1 == first) {
      stretches.back().second = last;
    } else {
      stretches.emplace_back(first, last);
    }
  };
  std::optional<std::int64_t> before;
  for (const auto& [number, line] : lines_) {
    if (before && number > *before + 1) add_stretch(*before + 1, number - 1);
    if (line.line.missing_beams > 0) add_stretch(number, number);
    before = number;
  }
  return stretches;
}

std::vector<ScanLine> LineCollector::take() {
  std::vector<ScanLine> lines;
  for (auto& [number, line] : lines_) lines.push_back(std::move(line.line));
  lines_.clear();
  return lines;
}

std::vector<ScanLine> LineCollector::take_before(Utime utime) {
  std::vector<ScanLine> lines;
  while (!lines_.empty() && lines_.begin()->second.line.utime < utime) {
    lines.push_back(std::move(lines_.begin()->second.line));
    lines_.erase(lines_.begin());
  }
  return lines;
}

}  // namespace scanway
