#include "tests/live/support/session.h"

#include <gtest/gtest.h>

#include <sstream>

#include "common/cloud/read_cloud.h"
#include "common/cloud/write_cloud.h"

namespace scanway::test {
namespace {

const std::string kBin = SCANWAY_BIN_DIR;
const std::string kSource = SCANWAY_SOURCE_DIR;
constexpr std::size_t kEvery = 4;

std::string write_quarter(const ScratchFolder& folder, const std::string& scan) {
  const PointCloud whole = read_cloud(kSource + "/logs/halls/" + scan);
  PointCloud quarter;
  for (std::size_t i = 0; i < whole.size(); i += kEvery) {
    quarter.points.push_back(whole.points[i]);
    if (!whole.intensity.empty()) quarter.intensity.push_back(whole.intensity[i]);
  }
  write_pcd(folder / scan, quarter);
  return folder / scan;
}

std::string output_of(const std::vector<std::string>& words) {
  const CommandResult result = run_command(words);
  EXPECT_EQ(result.status, 0) << words[0] << " " << words[1] << ": " << result.err;
  return result.out;
}

}  // namespace

bool namespaces_permitted() { return run_command({"unshare", "--net", "true"}).status == 0; }

ShortLog::ShortLog() : log(folder / "short.lcmlog") {
  output_of({kBin + "/scanway", "import", "clouds", write_quarter(folder, "scan000.pcd"),
             write_quarter(folder, "scan001.pcd"), "--poses", kSource + "/logs/halls/poses_reference.txt",
             "--heading-sigma-deg", "5", "--tilt-sigma-deg", "0.5", "--goal", "1.0,-0.5", "-o", log});
  output_of({kBin + "/scanway", "replay", log, "-o", folder / "replay"});
  products = output_of({kBin + "/scanway-live-tool", "digests", folder / "replay/out.lcmlog"});
}

const ShortLog& ShortLog::get() {
  static const ShortLog kLog;
  return kLog;
}

std::string Session::head() const {
  return "BIN='" + kBin + "' WORK='" + folder_.path() + "' LOG='" + ShortLog::get().log + "'\n. '" + kSource +
         "/tests/live/session.sh'\n";
}

CommandResult Session::run(const std::string& script) const {
  return run_command({"unshare", "--net", "--pid", "--mount-proc", "--fork", "--kill-child", "bash", "-c",
                      head() + "one_machine\n" + script});
}

CommandResult Session::run_on_lan(const std::vector<std::string>& options,
                                  const std::vector<std::string>& scripts) const {
  std::vector<std::string> words = {kSource + "/tests/tools/netns-lan", "-1"};
  words.insert(words.end(), options.begin(), options.end());
  words.push_back("--");
  for (std::size_t i = 0; i < scripts.size(); ++i) {
    const std::string file = folder_ / ("machine" + std::to_string(i) + ".sh");
    write_text(file, "export LCM_DEFAULT_URL=udpm://239.255.76.67:7667?ttl=1\n" + head() + scripts[i]);
    words.push_back("exec bash '" + file + "'");
  }
  return run_command(words);
}

std::string Session::observed(const std::string& channel) const { return lines_of(text("observed.txt"), channel); }

std::map<std::string, long> Session::counters(const std::string& process) const {
  std::map<std::string, long> counters;
  std::istringstream lines(text("observed.txt"));
  for (std::string kind, who, name; lines >> kind >> who >> name;) {
    if (kind == "HEALTH" && who == process) lines >> counters[name];
    std::getline(lines, kind);
  }
  return counters;
}

std::string Session::told() const {
  return "mapper: " + text("mapper.err") + "\nplanner: " + text("planner.err") + "\nobserver: " + text("observer.err") +
         text("observed.txt");
}

std::string lines_of(const std::string& products, const std::string& channel) {
  std::string lines;
  std::istringstream stream(products);
  for (std::string line; std::getline(stream, line);) {
    const bool is_product =
        !line.starts_with("HEALTH ") && !line.starts_with("SUMMARY ") && !line.starts_with("SECONDS ");
    if (channel.empty() ? is_product : line.starts_with(channel + " ")) lines += line + "\n";
  }
  return lines;
}

}  // namespace scanway::test
