#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "modules/replay/verify/recorded_log.h"

namespace scanway {

/// A sweep as SWEEP_INPUTS lists it, with what the log holds of that.
struct ListedSweep {
  Utime utime = 0;
  std::string name;
  /// What it used beside the sweep itself, by channel, in the order of use.
  std::vector<std::pair<std::string, RecordedLog::Bytes>> messages;
  const RecordedObject* sweep = nullptr;  ///< Whole; nullptr: the log lacks some of it.
  bool complete = false;                  ///< The log holds all that it is computed from.

  /// From lines, angles and orientations; else it came as a whole.
  bool is_assembled() const;
};

struct SweepList {
  std::vector<ListedSweep> sweeps;   ///< In the order in which the mapper worked on them.
  std::vector<std::string> missing;  ///< What the log lacks of what is listed, and sweeps that are not listed.
  std::vector<std::string> notes;    ///< What people should know beside.
  std::vector<Utime> not_listed;     ///< Sweeps that left traces in the log, but not their SWEEP_INPUTS.
  std::string difference;            ///< The list contradicts itself or a sweep; empty: it does not.
};

/// `continued`: the time of the map that the log goes on with, which is known and was version 1.
SweepList list_sweeps(const RecordedLog& log, std::optional<Utime> continued = {});

/// What the log lacks of one listed input, or holds beside it, in one line; empty: it holds exactly that.
std::string missing_input(const RecordedLog& log, const input_span_t& input);

}  // namespace scanway
