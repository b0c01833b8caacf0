#include <string>

#include "modules/tools/arguments/arguments.h"
#include "modules/tools/decode/decode_erratic.h"
#include "modules/tools/decode/decode_lms.h"
#include "modules/tools/decode/decode_schunk.h"
#include "modules/tools/decode/decode_xsens.h"

namespace scanway::tools {

void add_decode(CLI::App& app, Action& action) {
  struct Device {
    const char* name;
    const char* help;
    int (*run)(const std::string&);
  };
  static constexpr Device kDevices[] = {
      {"lms", "SICK LMS5xx: CoLa-A or CoLa-B telegrams", run_decode_lms},
      {"schunk", "SCHUNK PW-70: Motion Protocol frames on CAN", run_decode_schunk},
      {"xsens", "Xsens tracker: MTData and MTData2", run_decode_xsens},
      {"erratic", "ERA-Mobi base: its serial packets", run_decode_erratic},
  };
  static std::string file;
  CLI::App* decode = app.add_subcommand("decode", "A device's recorded bytes as JSON lines, what is broken marked");
  decode->require_subcommand(1);
  for (const Device& device : kDevices) {
    CLI::App* command = decode->add_subcommand(device.name, device.help);
    command->add_option("file", file, "What the device sent")->required();
    command->callback([&action, run = device.run] { action = [run] { return run(file); }; });
  }
}

}  // namespace scanway::tools
