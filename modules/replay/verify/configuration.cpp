#include "modules/replay/verify/configuration.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "common/config/robot_file.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "common/messages/codec.h"
#include "common/messages/params_message.h"

namespace scanway {
namespace {

/// The robot file's text that a process has said last, in the fixed form of robot_text().
std::optional<std::string> said_by(const RecordedLog& log, const std::string& key, const std::string& path,
                                   LogConfiguration& result) {
  std::optional<std::string> newest;
  std::set<std::string> all;
  std::string lacking;
  for (const auto& [name, object] : log.objects_of(channel::kParams)) {
    if (name.key != key) continue;
    if (!object.whole() || !object.fault().empty()) {
      lacking = text_of(name) + ": " + (object.fault().empty() ? object.lacking() : object.fault());
      continue;
    }
    try {
      const std::string yaml = robot_yaml_of(decode<params_t>(object.bytes().value()));
      newest = robot_text(parse_robot(yaml, path + " (PARAMS)"));
      all.insert(*newest);
    } catch (const BadMessage& bad) {
      throw InputError(printable(path) + ": its configuration (PARAMS) cannot be read: " + bad.what() +
                       "; name a robot file with --robot");
    }
  }
  if (!newest && !lacking.empty()) result.missing.push_back(lacking);
  if (all.size() > 1) {
    result.notes.push_back(fmt::format("{}'s configuration (PARAMS) changes within the log; the last is taken", key));
  }
  return newest;
}

/// "'pan_speed_deg_s: 3' and 'pan_speed_deg_s: 5'": the first line in which the two differ.
std::string first_difference(const std::string& a, const std::string& b) {
  std::size_t begin = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()) && a[i] == b[i]; ++i) {
    if (a[i] == '\n') begin = i + 1;
  }
  const auto line = [begin](const std::string& text) {
    const std::size_t first = text.find_first_not_of(' ', begin);
    return text.substr(std::min(first, text.size()), text.find('\n', begin) - first);
  };
  return fmt::format("'{}' and '{}'", line(a), line(b));
}

}  // namespace

LogConfiguration configuration_of(const RecordedLog& log, const std::string& path) {
  LogConfiguration result;
  auto mapper = said_by(log, "mapper", path, result);
  auto planner = said_by(log, "planner", path, result);
  const bool needs_robot = result.missing.empty() && (!mapper || !planner);
  const auto robot = needs_robot ? said_by(log, kParamsKey, path, result) : std::nullopt;
  // A process that says nothing of its own ran with what the other ran with.
  if (!mapper) mapper = robot ? robot : planner;
  if (!planner) planner = mapper;
  if (!mapper && result.missing.empty()) result.missing.push_back("PARAMS: none; name a robot file with --robot");
  if (!mapper || !planner) return result;
  if (*mapper != *planner) {
    result.notes.push_back("mapper and planner ran with different configurations (PARAMS): " +
                           printable(first_difference(*mapper, *planner)));
  }
  result.mapper = parse_robot(*mapper, path + " (PARAMS)");
  result.planner = parse_robot(*planner, path + " (PARAMS)");
  return result;
}

}  // namespace scanway
