// A session that lcm-logger recorded at the far end of a link that loses frames: replay --verify names exactly the
// inputs that the log lacks. What it lacks is worked out here from the log that was played.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>

#include "bot_core/ins_t.hpp"
#include "common/bus/log_reader.h"
#include "common/messages/codec.h"
#include "common/messages/digest.h"
#include "scanway/piece_t.hpp"
#include "scanway/sweep_inputs_t.hpp"
#include "tests/live/support/session.h"

namespace scanway::test {
namespace {

/// What mapper and planner can use of a log.
struct Inputs {
  explicit Inputs(const std::string& path) {
    LogReader log(path);
    while (const auto event = log.next()) {
      if (event->channel == "IMU")
        orientations[hex(digest(event->bytes))] = decode<bot_core::ins_t>(event->bytes).utime;
      if (event->channel == "GOAL") has_goal = true;
      if (event->channel == "SWEEP_INPUTS") listed.insert(decode<sweep_inputs_t>(event->bytes).utime);
      if (event->channel != "SWEEP") continue;
      const auto piece = decode<piece_t>(event->bytes);
      sweeps[{piece.utime, piece.key}].insert(piece.piece);
      digests[piece.utime] = hex(static_cast<std::uint64_t>(piece.digest));
    }
  }

  std::map<std::string, Utime> orientations;  // By digest.
  std::map<std::pair<Utime, std::string>, std::set<int>> sweeps;
  std::map<Utime, std::string> digests;
  std::set<Utime> listed;
  bool has_goal = false;
};

/// "3, 5-7"
std::string ranges(const std::set<int>& numbers) {
  std::ostringstream text;
  for (auto first = numbers.begin(); first != numbers.end();) {
    auto last = first;
    while (std::next(last) != numbers.end() && *std::next(last) == *last + 1) ++last;
    text << (first == numbers.begin() ? "" : ", ") << *first;
    if (last != first) text << "-" << *last;
    first = std::next(last);
  }
  return text.str();
}

std::set<std::string> lacking(const Inputs& played, const Inputs& recorded) {
  std::set<std::string> lines;
  for (const auto& [digest, utime] : played.orientations) {
    if (recorded.orientations.contains(digest)) continue;
    lines.insert("missing: IMU at " + std::to_string(utime) + " digest " + digest);
  }
  for (const auto& [name, pieces] : played.sweeps) {
    std::set<int> missing = pieces;
    if (const auto there = recorded.sweeps.find(name); there != recorded.sweeps.end()) {
      for (const int piece : there->second) missing.erase(piece);
    }
    if (missing.empty()) continue;
    lines.insert("missing: SWEEP " + name.second + " at " + std::to_string(name.first) + " digest " +
                 played.digests.at(name.first) + ": " + std::to_string(missing.size()) + " of " +
                 std::to_string(pieces.size()) + " pieces (" + ranges(missing) + ")");
  }
  return lines;
}

std::set<std::string> missing_lines(const std::string& text) {
  std::set<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("missing: ")) lines.insert(line);
  }
  return lines;
}

TEST(LiveVerify, OfALogThatLostFramesExactlyTheInputsThatItLacksAreNamed) {
  if (!namespaces_permitted()) GTEST_SKIP() << "network namespaces are not permitted here (unshare --net)";
  const Session session;
  const auto played = session.run_on_lan({"-t", "200", "-l", "2"}, {R"(
    begin mapper
    touch "$LAN_DIR/mapper-ready"
    while [ ! -e "$LAN_DIR/planner-ready" ]; do sleep 0.1; done
    lcm-logplayer -s 4 "$LOG"
    wait $pid_mapper)",
                                                                    R"(
    while [ ! -e "$LAN_DIR/mapper-ready" ]; do sleep 0.1; done
    begin planner
    observe 2 150
    record "$WORK/recorded.lcmlog"
    lcm-logplayer -s 4 -e GOAL "$LOG"
    touch "$LAN_DIR/planner-ready"
    finish || exit 1
    end_record
    "$BIN/scanway" replay --verify "$WORK/recorded.lcmlog" >"$WORK/verified.txt"
    echo $? >"$WORK/status")"});
  if (played.status == 125) GTEST_SKIP() << "no pretend LAN here: " << played.err;
  ASSERT_EQ(played.status, 0) << played.err << session.told();
  const std::string said = session.text("verified.txt");
  const Inputs log(ShortLog::get().log), recorded(session / "recorded.lcmlog");
  ASSERT_TRUE(recorded.has_goal);
  EXPECT_EQ(recorded.listed.size(), 2U) << "SWEEP_INPUTS is said again every second";
  const auto lacks = lacking(log, recorded);
  EXPECT_EQ(missing_lines(said), lacks);
  EXPECT_EQ(session.text("status"), lacks.empty() ? "0\n" : "4\n") << said;
  EXPECT_EQ(said.find("different:"), std::string::npos) << said;
  std::printf("%zu inputs were lost\n", lacks.size());
}

}  // namespace
}  // namespace scanway::test
