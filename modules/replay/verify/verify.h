#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "common/robot/robot.h"

namespace scanway {

/// Whether what a log says was derived is what its inputs give.
struct Verification {
  std::size_t sweeps = 0;            ///< Of the log.
  std::size_t computed = 0;          ///< Of these, made anew.
  std::size_t products = 0;          ///< Objects and messages that were derived and recorded, and are equal.
  std::string difference;            ///< The first product that is another, with both digests; empty: none is.
  std::vector<std::string> missing;  ///< Each input that the log lacks.
  std::vector<std::string> unused;   ///< Of the log that was played, what the processes did not use.
  std::vector<std::string> notes;    ///< What people should know beside.
  std::string trouble;               ///< What is wrong with the log's file, in one line; empty: nothing.
  bool holds_derived = true;         ///< The log holds something to compare.

  enum Status { kEqual = 0, kDifferent = 1, kNothingDerived = 3, kIncomplete = 4 };
  Status status() const;
  /// What is wrong or lacking, a line each: `different: ...`, `missing: ...`. Empty when all is equal.
  std::string findings() const;
  /// What else there is to know, a line each: `note: ...`, and what was found equal.
  std::string remarks() const;
};

/// Computes anew what mapper and planner derived, from exactly the inputs that the log's SWEEP_INPUTS list, and
/// compares it with what the log holds: products by channel, key, version and digest, PATH on closed versions. `robot`
/// is taken in place of the log's own configuration. `played`, if not empty, is the log that a
/// player sent to the processes whose session `log` is. `resumed`, if not empty, is the folder of the map that the
/// session went on with. `progress` is told how far it is, from 0 to 1. Throws
/// InputError.
Verification verify(const std::string& log, const std::optional<Robot>& robot,
                    const std::function<void(double)>& progress = {}, const std::string& played = {},
                    const std::string& resumed = {});

}  // namespace scanway
