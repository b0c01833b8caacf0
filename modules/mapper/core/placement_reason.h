#pragma once

#include <string>

#include "modules/mapper/core/locate.h"
#include "modules/mapper/core/sweep_graph.h"

namespace scanway {

/// For people: which sweeps hold the newest one in its place, and which registrations, its own or older ones, are
/// dropped since. Empty: there is no more to say than the registration does.
std::string said_of_links(const std::vector<Link>& links, const SweepGraph& graph);

/// For people: why a sweep was found nowhere in the map. `continued`: it is the first of its session.
std::string said_of_refusal(const Location& location, const std::vector<PlacedSweep>& map, bool continued);

}  // namespace scanway
