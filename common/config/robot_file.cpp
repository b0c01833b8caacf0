#include "common/config/robot_file.h"

#include "common/config/robot_fields.h"
#include "common/config/yaml_document.h"
#include "common/config/yaml_reader.h"
#include "common/config/yaml_writer.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "common/files/read_file.h"

namespace scanway {
namespace {

/// The form of the file. When a later one renames or moves a key, parse_robot() turns older mappings into the present
/// form before it reads them, so that logs with an old robot file stay readable.
constexpr int kSchema = 1;

void check_schema(const YAML::Node& mapping, const std::string& name) {
  const YAML::Node schema = mapping["schema"];
  if (!schema) return;  // a file that does not say is of the first form
  const std::string text = schema.IsScalar() ? schema.Scalar() : "";
  if (text == std::to_string(kSchema)) return;
  const bool newer = text.size() <= 6 && text.find_first_not_of("0123456789") == text.npos && text > "0";
  const std::string what = newer ? "is newer than this program knows (" + std::to_string(kSchema) + "): update Scanway"
                                 : "must be " + std::to_string(kSchema);
  throw InputError(printable(name) + ": schema (line " + std::to_string(line_of(schema)) + ") " + what);
}

void check_together(const Robot& robot, const std::string& name) {
  const std::string file = printable(name) + ": ";
  if (robot.laser.min_range_m >= robot.laser.max_range_m) {
    throw InputError(file + "laser.min_range_m must be smaller than laser.max_range_m");
  }
  if (robot.body.climbable_step_m >= robot.body.height_m) {
    throw InputError(file + "body.climbable_step_m must be smaller than body.height_m");
  }
}

}  // namespace

Robot parse_robot(std::string_view text, const std::string& name) {
  const YAML::Node mapping = yaml_mapping(text, name);
  YamlReader reader(mapping, name);
  check_schema(mapping, name);
  Robot robot;
  int schema = kSchema;
  reader.whole_number("schema", schema, {kSchema, kSchema});
  describe(reader, robot);
  reader.finish();
  check_together(robot, name);
  return robot;
}

Robot load_robot(const std::string& path) { return parse_robot(read_file(path), path); }

std::string robot_text(const Robot& robot) {
  YamlWriter writer;
  int schema = kSchema;
  writer.whole_number("schema", schema, {kSchema, kSchema});
  Robot copy = robot;  // a description may change what it describes
  describe(writer, copy);
  return writer.yaml();
}

}  // namespace scanway
