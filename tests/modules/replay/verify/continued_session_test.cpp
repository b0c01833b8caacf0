// A map that was saved, loaded and gone on with, beside one that was never stopped.
#include <gtest/gtest.h>

#include <filesystem>

#include "common/bus/channels.h"
#include "common/files/input_error.h"
#include "modules/mapper/saving/map_folder.h"
#include "modules/mapper/saving/map_products.h"
#include "modules/replay/replay.h"
#include "tests/modules/replay/verify/session_log.h"

namespace scanway::test {
namespace {

constexpr Utime kBetween = (kFirstSweep + kSecondSweep) / 2;

std::string inputs_between(const std::string& name, Utime from, Utime until) {
  return SessionLog::get().edited(name, [&](std::vector<EditedEvent>& events) {
    std::erase_if(events, [&](const EditedEvent& event) {
      const bool input = event.channel == channel::kSweep.name || event.channel == channel::kImu.name;
      return !input || event.utime < from || event.utime >= until;
    });
  });
}

/// Replays a log and saves the map in `folder`; `earlier`: the saved map that it goes on with.
void replay_and_save(const std::string& log, const std::string& folder, const std::string& earlier = "") {
  const ScratchFolder scratch;
  MapSave save(folder);
  LogWriter recording(scratch / "out.lcmlog");
  Replay replay(Robot{}, recording);
  if (earlier.empty()) replay.keep_in(save.sweeps());
  if (!earlier.empty()) {
    save.sweeps().take_over(saved_map(earlier));
    replay.go_on_with(save.sweeps());
  }
  LogReader inputs(log);
  replay.run(inputs);
  recording.close();
  write_map_products(replay.mapper(), save.files());
  save.commit(Robot{});
}

std::map<std::string, std::uint64_t> files_of(const std::string& folder) { return SavedFolder(folder).digests(); }

TEST(ContinuedSession, IsEqualToOneThatWasNeverStopped) {
  const ScratchFolder scratch;
  replay_and_save(inputs_between("all.lcmlog", 0, 2 * kSecondSweep), scratch / "whole");
  replay_and_save(inputs_between("first.lcmlog", 0, kBetween), scratch / "stopped");
  replay_and_save(inputs_between("second.lcmlog", kBetween, 2 * kSecondSweep), scratch / "gone_on",
                  scratch / "stopped");
  const auto whole = files_of(scratch / "whole"), gone_on = files_of(scratch / "gone_on");
  EXPECT_EQ(whole, gone_on) << "every product, the poses and the kept sweeps, to the byte";
  EXPECT_NE(whole, files_of(scratch / "stopped"));
  EXPECT_TRUE(whole.contains("map.ot") && whole.contains("costmap.pgm") && whole.contains("robot.yaml"));
}

TEST(ContinuedSession, GoesOnInItsOwnFolder) {
  const ScratchFolder scratch;
  replay_and_save(inputs_between("all.lcmlog", 0, 2 * kSecondSweep), scratch / "whole");
  replay_and_save(inputs_between("first.lcmlog", 0, kBetween), scratch / "map");
  replay_and_save(inputs_between("second.lcmlog", kBetween, 2 * kSecondSweep), scratch / "map", scratch / "map");
  EXPECT_EQ(files_of(scratch / "map"), files_of(scratch / "whole"));
}

TEST(ContinuedSession, RefusesADamagedMapByTheNameOfItsFile) {
  const ScratchFolder scratch;
  replay_and_save(inputs_between("first.lcmlog", 0, kBetween), scratch / "map");
  std::string bytes = read_text(scratch / "map/map.ot");
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
  write_text(scratch / "map/map.ot", bytes);
  try {
    saved_map(scratch / "map");
    FAIL() << "a damaged map was taken";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("map.ot: is damaged"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace scanway::test
