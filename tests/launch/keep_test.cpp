// launch/keep starts again what dies, and nothing else.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/support/command.h"

namespace scanway::test {
namespace {

const std::string kKeep = SCANWAY_SOURCE_DIR "/launch/keep";

class Keep : public testing::Test {
 protected:
  /// A program of one line of shell.
  std::string program(const std::string& line) {
    const std::string path = scratch_ / "program.sh";
    write_text(path, "cd '" + scratch_.path() + "'\necho ran >>runs\n" + line + "\n");
    return path;
  }
  std::size_t runs() const {
    const std::string text = read_text(scratch_ / "runs");
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }
  const ScratchFolder scratch_;
};

TEST_F(Keep, StartsAgainWhatDies) {
  const auto kept = run_command({kKeep, "bash", program("[ $(wc -l <runs) -ge 3 ] || kill -KILL $$")});
  EXPECT_EQ(kept.status, 0) << kept.err;
  EXPECT_EQ(runs(), 3U);
}

TEST_F(Keep, NotWhatCannotUseItsInput) {
  EXPECT_EQ(run_command({kKeep, "bash", program("exit 2")}).status, 2);
  EXPECT_EQ(runs(), 1U);
}

TEST_F(Keep, PassesOnThatItIsAskedToEndAndWaitsForTheLastWords) {
  const std::string patient = program("trap 'sleep 0.3; echo bye >said; exit 0' TERM; while true; do sleep 0.05; done");
  const std::string script = "'" + kKeep + "' bash '" + patient + "' & keep=$!\n" + "while [ ! -e '" +
                             (scratch_ / "runs") + "' ]; do sleep 0.05; done\nsleep 0.3\n" +
                             "kill -TERM $keep; wait $keep";
  EXPECT_EQ(run_command({"bash", "-c", script}).status, 0);
  EXPECT_EQ(read_text(scratch_ / "said"), "bye\n");
  EXPECT_EQ(runs(), 1U);
}

}  // namespace
}  // namespace scanway::test
