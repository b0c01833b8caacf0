// launch/spy opens lcm-spy with our types, and takes everything away again.
#include <gtest/gtest.h>

#include "common/messages/layout.h"
#include "tests/support/command.h"

namespace scanway::test {
namespace {

constexpr const char* kScript = R"(
  ip link set lo up && ip route add 224.0.0.0/4 dev lo || exit 99
  cd "$1"
  export SCANWAY_BUILD="$3/.." DISPLAY=:97
  unset LCM_DEFAULT_URL
  Xvfb :97 -screen 0 1000x700x24 -nolisten tcp >/dev/null 2>&1 & screen=$!
  for _ in $(seq 100); do xdotool getmouselocation >/dev/null 2>&1 && break; sleep 0.1; done
  "$2/launch/spy" >spy.out 2>spy.err & spy=$!
  for _ in $(seq 300); do xdotool search --name 'LCM Spy' >/dev/null 2>&1 && break; sleep 0.2; done
  xdotool search --name 'LCM Spy' >/dev/null || exit 1
  for _ in $(seq 100); do pgrep -f 'scanway spy .*--rela[y]' >/dev/null && break; sleep 0.1; done
  pgrep -f 'scanway spy .*--rela[y]' >/dev/null || exit 2
  # Brackets: not this script's own words.
  kill -TERM $spy; wait $spy
  for _ in $(seq 50); do pgrep -f 'lcm.spy.Sp[y]|--rela[y]' >/dev/null || break; sleep 0.1; done
  pgrep -f 'lcm.spy.Sp[y]|--rela[y]' >&2 && status=3
  kill -TERM $screen; wait $screen
  exit ${status:-0})";

TEST(Window, OpensWithOurTypesAndLeavesNothingBehind) {
  for (const char* program : {"Xvfb", "xdotool", "java", "javac"}) {
    if (run_command({"sh", "-c", std::string("command -v ") + program}).status != 0) GTEST_SKIP() << "no " << program;
  }
  if (run_command({"unshare", "--net", "--mount", "true"}).status != 0) GTEST_SKIP() << "no network namespaces here";
  const ScratchFolder scratch;
  const auto shown = run_command({"unshare", "--net", "--mount", "--pid", "--fork", "--kill-child", "--mount-proc",
                                  "bash", "-c", kScript, "bash", scratch.path(), SCANWAY_SOURCE_DIR, SCANWAY_BIN_DIR});
  EXPECT_EQ(shown.status, 0) << shown.err << read_text(scratch / "spy.err") << read_text(scratch / "spy.out");
}

}  // namespace
}  // namespace scanway::test
