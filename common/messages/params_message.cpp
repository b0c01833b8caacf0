#include "common/messages/params_message.h"

#include <utility>

#include "common/messages/bad_message.h"

namespace scanway {

params_t params_message(Utime utime, std::string robot_yaml) {
  params_t message{};
  message.utime = utime;
  message.schema_version = kParamsSchema;
  message.robot_yaml = std::move(robot_yaml);
  return message;
}

std::string robot_yaml_of(const params_t& message) {
  if (message.schema_version < 1 || message.schema_version > kParamsSchema) {
    throw BadMessage("a configuration of schema " + std::to_string(message.schema_version) +
                     ", but this program knows 1 to " + std::to_string(kParamsSchema));
  }
  return message.robot_yaml;
}

}  // namespace scanway
