#include "tests/support/private_network.h"

#include <sched.h>

#include "tests/support/command.h"

namespace scanway::test {

bool enter_private_network() {
  if (unshare(CLONE_NEWNET) != 0 && unshare(CLONE_NEWUSER | CLONE_NEWNET) != 0) return false;
  return run_command({"ip", "link", "set", "lo", "up"}).status == 0 &&
         run_command({"ip", "route", "add", "224.0.0.0/4", "dev", "lo"}).status == 0;
}

}  // namespace scanway::test
