#include "modules/tools/arguments/arguments.h"
#include "modules/tools/logs/info.h"
#include "modules/tools/logs/replay.h"

namespace scanway::tools {

void add_replay(CLI::App& app, Action& action) {
  static ReplayOptions options;
  CLI::App* command = app.add_subcommand("replay", "A log in; map, cost map, path and pictures out");
  command->add_option("log", options.log, "The log")->required();
  auto* output = command->add_option("-o,--output", options.output, "Folder for the products");
  command->add_option("--robot", options.robot, "Robot file in place of the log's own configuration");
  auto* resume = command->add_option("--resume", options.resumed,
                                     "Folder of kept sweeps or saved map: the log goes on with it, a session later");
  auto* goes_on = command->add_option("--continue", options.continued,
                                      "Folder of a saved map: the log goes on with it as if it had never stopped");
  goes_on->excludes(resume);
  auto* keep = command->add_option("--keep", options.kept, "Folder to keep the map's sweeps in, for --resume");
  static bool verifies = false;
  auto* verify = command->add_flag("--verify", verifies, "Compare the log's own products with what its inputs give");
  verify->excludes(output)->excludes(keep)->excludes(goes_on);
  command
      ->add_option("--played", options.played, "The log that was played to the processes: name what they did not use")
      ->needs(verify);
  command->callback([&action] {
    if (!verifies && options.output.empty()) throw CLI::RequiredError("--output or --verify");
    action = [] { return verifies ? run_verify(options) : run_replay(options); };
  });
}

void add_info(CLI::App& app, Action& action) {
  static InfoOptions options;
  CLI::App* command = app.add_subcommand("info", "What a log holds, and whether it is whole");
  command->add_option("log", options.log, "The log")->required();
  command->add_flag("--json", options.json, "One JSON document on stdout");
  command->callback([&action] { action = [] { return run_info(options); }; });
}

}  // namespace scanway::tools
