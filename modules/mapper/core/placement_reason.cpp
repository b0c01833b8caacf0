#include "modules/mapper/core/placement_reason.h"

#include <algorithm>

namespace scanway {
namespace {

void append(std::string& list, const std::string& name) {
  if (!list.empty()) list += ", ";
  list += name;
}

}  // namespace

std::string said_of_links(const std::vector<Link>& links, const SweepGraph& graph) {
  const GraphSolution& solution = graph.solution();
  const std::size_t before = solution.dropped.size() - links.size();
  std::string kept, contradicting, exposed;
  for (std::size_t i = 0; i < links.size(); ++i) {
    append(solution.dropped[before + i] ? contradicting : kept, graph.sweeps()[links[i].target].name);
  }
  for (const std::size_t edge : graph.exposed()) {
    const GraphEdge& wrong = graph.graph().edges[edge];
    append(exposed, graph.sweeps()[wrong.to].name + " to " + graph.sweeps()[wrong.from].name);
  }
  std::string said;
  if (links.size() > 1) said += " It is where it was registered to: " + kept + ".";
  if (!contradicting.empty()) said += " Dropped, for they contradict that: " + contradicting + ".";
  if (!exposed.empty())
    said += " Earlier registrations that are dropped, for they contradict the rest: " + exposed + ".";
  return said;
}

std::string said_of_refusal(const Location& location, const std::vector<PlacedSweep>& map, bool continued) {
  const std::string& reason = location.refusal->reason;
  if (!continued && location.searched == 1) return reason;
  const auto standing = static_cast<std::size_t>(
      std::count_if(map.begin(), map.end(), [](const PlacedSweep& sweep) { return !sweep.withdrawn; }));
  const bool all = location.searched == standing;
  std::string said = continued ? "Not found in the map that it should continue" : "Not found in the map";
  said += all ? ", at none of its " : ", at none of the ";
  said += std::to_string(location.searched) + " sweeps";
  if (!all) said += " that lie nearest to the last one, of " + std::to_string(standing);
  return said + "; at " + map[*location.refused_by].name + ": " + reason;
}

}  // namespace scanway
