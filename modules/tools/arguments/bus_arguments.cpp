#include "modules/tools/arguments/arguments.h"
#include "modules/tools/drive/command.h"
#include "modules/tools/drive/drive.h"
#include "modules/tools/spy/spy.h"

namespace scanway::tools {

void add_spy(CLI::App& app, Action& action) {
  static SpyOptions options;
  CLI::App* command = app.add_subcommand("spy", "What is on the bus: rates, gaps, bad messages, values of a channel");
  command->add_option("channel", options.channel, "Show this channel's values instead of the table of all");
  command->add_option("--lcm-url", options.lcm_url, "The bus (default: LCM_DEFAULT_URL, or multicast on this machine)");
  command->add_option("--seconds", options.seconds, "Listen for so long")->check(CLI::Range(0.0, 1e9));
  command->add_flag("--once", options.once, "One table, or the next message of the channel");
  command->add_flag("--json", options.json, "JSON lines on stdout");
  command->add_option("--elements", options.elements, "How many elements of an array to show")->capture_default_str();
  command->add_option("--ask", options.ask, "Ask for the objects that this channel's senders hold");
  command->add_option("--relay", options.relay, "Pass everything on to this bus, objects whole, for LCM's own tools");
  command->callback([&action] { action = [] { return run_spy(options); }; });
}

void add_command(CLI::App& app, Action& action) {
  static CommandOptions options;
  CLI::App* command = app.add_subcommand("command", "Tell the pan-tilt what to do");
  command->add_option("what", options.what, "sweep, move, turn, reference, stop, fast-stop or acknowledge")
      ->required()
      ->check(CLI::IsMember({"sweep", "move", "turn", "reference", "stop", "fast-stop", "acknowledge"}));
  command->add_option("--pan-deg", options.pan_deg, "move: where to");
  command->add_option("--tilt-deg", options.tilt_deg, "move: where to; sweep: the tilt to hold");
  command->add_option("--pan-speed-deg-s", options.pan_speed_deg_s, "turn: with its sign; sweep: while it scans; move");
  command->add_option("--tilt-speed-deg-s", options.tilt_speed_deg_s, "turn: with its sign; move");
  command->add_flag("--registered", options.registered, "sweep: wait for its place in the map, too");
  command->add_option("--lcm-url", options.lcm_url, "The bus (default: LCM_DEFAULT_URL, or multicast on this machine)");
  command->callback([&action] { action = [] { return run_command(options); }; });
}

void add_drive(CLI::App& app, Action& action) {
  static DriveOptions options;
  CLI::App* command = app.add_subcommand("drive", "Drive the robot along the planner's path to a goal");
  add_point(command, "goal", options.goal_m, "m, in the map's frame")->required();
  command->add_option("--speed-m-s", options.speed_m_s, "As fast as this")
      ->check(CLI::Range(0.01, 2.0))
      ->capture_default_str();
  command->add_option("--lcm-url", options.lcm_url, "The bus (default: LCM_DEFAULT_URL, or multicast on this machine)");
  command->callback([&action] { action = [] { return run_drive(options); }; });
}

}  // namespace scanway::tools
