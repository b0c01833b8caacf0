#include "tests/architecture/rules.h"

#include <algorithm>
#include <array>
#include <regex>
#include <set>

namespace scanway::architecture {
namespace {

using std::regex_search;

/// `modules/mapper/core/cloud/x.h` is of module `mapper`.
std::string module_of(const std::string& path) {
  static const std::regex kModule("^modules/([^/]+)/");
  std::smatch match;
  return regex_search(path, match, kModule) ? match[1].str() : "";
}

/// `common/cloud/x.h` is of folder `cloud`.
std::string common_folder_of(const std::string& path) {
  static const std::regex kFolder("^common/([^/]+)/");
  std::smatch match;
  return regex_search(path, match, kFolder) ? match[1].str() : "";
}

bool is_core(const std::string& path) {
  static const std::regex kCore("^modules/[^/]+/core/");
  return regex_search(path, kCore);
}

/// The devices of the bridges work without the bus.
bool is_device(const std::string& path) {
  static const std::regex kDevice("^modules/[^/]+/device/");
  return regex_search(path, kDevice);
}

/// Folders of common/ whose every file keeps the rules of a core.
bool is_pure(const std::string& path) {
  static const std::set<std::string> kPure = {"geometry", "random", "parallel", "robot"};
  return is_core(path) || kPure.contains(common_folder_of(path));
}

bool is_lcm(const std::string& include) {
  static const std::regex kLcm(
      "^<?(lcm/|lcmtypes/|scanway/|bot_core/|common/(bus|messages|delivery|health|process)/)|_t\\.hpp>?$");
  return regex_search(include, kLcm);
}

/// Headers of the value types' folders that read or write files, or time.
bool is_outside_world(const std::string& include) {
  static const std::regex kOutside(
      "^common/[^/]+/[^/]*(read_|write_|_file|_header|_formats|text_lines|stage_timer|pgm)");
  return regex_search(include, kOutside);
}

bool core_may_include(const std::string& path, const std::string& include) {
  static const std::set<std::string> kValues = {"time",  "geometry", "math",  "random",   "parallel",
                                                "cloud", "grid",     "robot", "progress", "bytes"};
  if (include.starts_with("modules/")) return include.starts_with("modules/" + module_of(path) + "/core/");
  if (include.starts_with("common/")) return kValues.contains(common_folder_of(include)) && !is_outside_world(include);
  return !is_lcm(include);
}

bool module_may_include(const std::string& path, const std::string& include) {
  const std::string mine = module_of(path);
  return mine == module_of(include) || mine == "replay" || mine == "tools";
}

bool common_may_include(const std::string& path, const std::string& include) {
  static const std::set<std::string> kKnowMessages = {"bus", "messages", "delivery", "health", "process"};
  return !include.starts_with("modules/") && (!is_lcm(include) || kKnowMessages.contains(common_folder_of(path)));
}

bool may_include(const std::string& path, const std::string& include) {
  if (include.starts_with("tests/") && !path.starts_with("tests/")) return false;
  if (is_core(path)) return core_may_include(path, include);
  if (is_device(path) && is_lcm(include)) return false;
  if (path.starts_with("common/")) return common_may_include(path, include);
  if (path.starts_with("modules/") && include.starts_with("modules/")) return module_may_include(path, include);
  return true;
}

struct Ban {
  std::regex pattern;
  const char* why;
};

const std::vector<Ban>& bans() {
  static const std::vector<Ban> kBans = [] {
    std::vector<Ban> all;
    const auto ban = [&](const char* pattern, const char* why) { all.push_back({std::regex(pattern), why}); };
    ban("#\\s*include\\s*<(chrono|ctime|time\\.h|sys/time\\.h|thread)>", "a clock");
    ban("\\bchrono\\s*::|\\b(gettimeofday|clock_gettime|localtime|gmtime|usleep|nanosleep|sleep_for)\\s*\\(",
        "a clock");
    ban("(^|[^\\w.>:]|std::)(time|clock)\\s*\\(\\s*(NULL|nullptr|0|&\\w+)?\\s*\\)", "a clock");
    ban("#\\s*include\\s*<random>|\\bstd::(mt19937|random_device|default_random_engine|shuffle|sample)\\b",
        "randomness");
    ban("(^|[^\\w.>:]|std::)(rand|srand|drand48)\\s*\\(", "randomness");
    ban("#\\s*include\\s*<(fstream|iostream|filesystem|fcntl\\.h|unistd\\.h)>", "files or the terminal");
    ban("\\bstd::(cout|cerr|clog|ifstream|ofstream|fstream|filesystem)\\b|\\b(fopen|printf|fprintf|getenv)\\s*\\(",
        "files or the terminal");
    ban("\\blcm(_|::)|#\\s*include\\s*<spdlog", "the bus or the log");
    ban("\\b(AngleAxis|Rotation2D)[fd]?\\b|\\.\\s*(eulerAngles|angularDistance|slerp)\\s*\\(",
        "Eigen's calls of libm's sine and cosine: use common/geometry/pose.h");
    const std::string functions =
        "(sin|cos|tan|asin|acos|atan|atan2|sincos|sinh|cosh|tanh|asinh|acosh|atanh|exp|exp2|expm1|log|log2|log10|log1p|"
        "pow|cbrt|hypot|erf|erfc|tgamma|lgamma)[fl]?\\s*\\(";
    // Unqualified, from std, or Eigen's member of the same name; a namespace of our own is another matter.
    ban(("(^|[^\\w:]|\\bstd::|[^\\w]::)" + functions).c_str(), "libm's transcendental functions: use common/math");
    ban("\\bstd::(sin|cos|tan|asin|acos|atan|atan2|exp|log|pow|hypot)\\b", "libm's transcendental functions");
    return all;
  }();
  return kBans;
}

}  // namespace

Violations include_violations(const SourceFile& file) {
  Violations violations;
  for (const std::string& include : includes_of(file.text)) {
    if (!may_include(file.path, include)) violations.push_back(file.path + " must not include " + include);
  }
  return violations;
}

Violations purity_violations(const SourceFile& file) {
  if (!is_pure(file.path)) return {};
  Violations violations;
  const std::string code = code_of(file.text);
  for (std::size_t begin = 0, number = 1; begin < code.size(); ++number) {
    const std::size_t end = std::min(code.find('\n', begin), code.size());
    const std::string line = code.substr(begin, end - begin);
    for (const Ban& ban : bans()) {
      if (!regex_search(line, ban.pattern)) continue;
      violations.push_back(file.path + ":" + std::to_string(number) + " uses " + ban.why);
    }
    begin = end + 1;
  }
  return violations;
}

Violations machine_path_violations(const SourceFile& file) {
  static const std::regex kPath("(^|[\\s\"'=(:,])/(work|home|root)/\\w");
  Violations violations;
  std::smatch match;
  if (regex_search(file.text, match, kPath))
    violations.push_back(file.path + " names a path of one machine:" + match.str());
  return violations;
}

Violations length_violations(const SourceFile& file, long most_lines) {
  const long lines = std::ranges::count(file.text, '\n');
  if (!is_cpp(file) || lines <= most_lines) return {};
  return {file.path + " has " + std::to_string(lines) + " lines, more than " + std::to_string(most_lines)};
}

Violations undocumented_commands(const std::vector<SourceFile>& files) {
  static const std::regex kCommand("`(scanway [a-z ]+)`"), kFunction("\\bint run_\\w+\\(");
  std::string docs;
  for (const SourceFile& file : files) {
    if (file.path.starts_with("docs/") || file.path == "README.md") docs += file.text;
  }
  Violations violations;
  for (const SourceFile& file : files) {
    if (!file.path.starts_with("modules/tools/") || !file.path.ends_with(".h")) continue;
    if (!regex_search(file.text, kFunction)) continue;
    std::smatch command;
    if (!regex_search(file.text, command, kCommand)) {
      violations.push_back(file.path + " does not say which command it is (`scanway ...`)");
    } else if (docs.find(command[1].str()) == docs.npos) {
      violations.push_back("docs and README.md do not mention " + command[1].str() + " (" + file.path + ")");
    }
  }
  return violations;
}

}  // namespace scanway::architecture
