#pragma once

#include <functional>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>

namespace scanway::tools {

/// Runs what the chosen subcommand asks for, and gives the exit status; set while the command line is parsed.
using Action = std::function<int()>;

/// Each adds a subcommand's words and flags to `app`; `action` becomes the subcommand's when it is chosen.
void add_import(CLI::App& app, Action& action);
void add_register(CLI::App& app, Action& action);
void add_plan(CLI::App& app, Action& action);
void add_octomap(CLI::App& app, Action& action);
void add_replay(CLI::App& app, Action& action);
void add_info(CLI::App& app, Action& action);
void add_spy(CLI::App& app, Action& action);
void add_simulate(CLI::App& app, Action& action);
void add_command(CLI::App& app, Action& action);
void add_drive(CLI::App& app, Action& action);
void add_decode(CLI::App& app, Action& action);
/// After add_import: `scanway import map` is one of these too.
void add_map(CLI::App& app, Action& action);
void add_export(CLI::App& app, Action& action);

/// "X,Y" as a flag's value.
CLI::Option* add_point(CLI::App* app, const std::string& flag, std::pair<double, double>& point,
                       const std::string& help);

}  // namespace scanway::tools
