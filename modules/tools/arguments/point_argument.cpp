#include "modules/tools/arguments/arguments.h"

namespace scanway::tools {

CLI::Option* add_point(CLI::App* app, const std::string& flag, std::pair<double, double>& point,
                       const std::string& help) {
  return app->add_option(flag, point, help)->delimiter(',')->type_name("X,Y");
}

}  // namespace scanway::tools
