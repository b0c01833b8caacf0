#pragma once

namespace scanway::test {

/// Puts this process, and what it starts from now on, into a network of its own: a loopback interface with a route for
/// multicast, and nothing else. Before it starts threads. False: not permitted here.
bool enter_private_network();

}  // namespace scanway::test
