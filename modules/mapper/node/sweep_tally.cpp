#include "modules/mapper/node/sweep_tally.h"

#include <fmt/format.h>

#include <vector>

#include "common/files/printable.h"

namespace scanway {
namespace {

constexpr double kDegreesPerRadian = 57.29577951308232;

}  // namespace

void SweepTally::count(const AssemblyReport& report) {
  ++sweeps_;
  missing_lines_ += report.missing_lines;
  missing_beams_ += report.missing_beams;
  without_angle_ += report.without_angle;
  empty_ += report.points == 0 ? 1 : 0;
  moved_ += report.steadiness.moved ? 1 : 0;
}

void SweepTally::made(const AssembledSweep& assembled) {
  const AssemblyReport& report = assembled.report;
  count(report);
  std::vector<std::string> sentences;
  if (report.points == 0) {
    sentences.push_back("holds no point");
  }
  if (report.missing_lines > 0) sentences.push_back(fmt::format("lacks {} lines", report.missing_lines));
  if (report.missing_beams > 0) sentences.push_back(fmt::format("lacks {} beams of others", report.missing_beams));
  if (report.without_angle > 0) sentences.push_back(fmt::format("{} beams have no pan angle", report.without_angle));
  if (report.steadiness.moved) {
    sentences.push_back(fmt::format("the robot moved during it, by {:.2f} degrees as the tracker says",
                                    report.steadiness.largest_turn_rad * kDegreesPerRadian));
  }
  note_.clear();
  if (!sentences.empty()) note_ = fmt::format("{}: {}", assembled.sweep.name, fmt::join(sentences, ", "));
}

void SweepTally::given_up(const std::string& sweep, const std::string& reason) {
  ++aborted_;
  note_ = fmt::format("{} was given up by the pan-tilt: {}", sweep, printable(reason));
}

void SweepTally::never_ended(const std::string& sweep) {
  ++never_ended_;
  note_ = sweep + " never ended";
}

std::map<std::string, std::int64_t> SweepTally::counters() const {
  return {{"assembler_sweeps", sweeps_},
          {"assembler_sweeps_aborted", aborted_},
          {"assembler_sweeps_never_ended", never_ended_},
          {"assembler_sweeps_never_started", never_started_},
          {"assembler_sweeps_empty", empty_},
          {"assembler_sweeps_moved", moved_},
          {"assembler_missing_lines", missing_lines_},
          {"assembler_missing_beams", missing_beams_},
          {"assembler_beams_without_angle", without_angle_}};
}

}  // namespace scanway
