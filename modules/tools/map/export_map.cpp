#include "modules/tools/map/export_map.h"

#include <filesystem>

#include "common/cloud/read_cloud.h"
#include "common/cloud/write_las.h"
#include "common/files/atomic_file.h"
#include "common/files/input_error.h"
#include "common/files/printable.h"
#include "common/files/read_file.h"
#include "common/files/saved_folder.h"
#include "common/grid/map_file.h"

namespace scanway::tools {
namespace {

std::string product(const SavedFolder& map, const std::string& name) {
  if (!map.has(name)) throw InputError(printable(map.path_of(name)) + ": is not in this map; save the map again");
  return map.path_of(name);
}

void copy_file(const std::string& from, const std::string& to) {
  AtomicFile file(to);
  read_parts(from, [&file](std::string_view part) { file.write(part); });
  file.commit();
}

}  // namespace

int run_export_map(const ExportMapOptions& options) {
  const std::string& to = options.output;
  const std::string end = std::filesystem::path(to).extension();
  const SavedFolder map(options.folder);
  if (end == ".pcd" || end == ".ply" || end == ".bt" || end == ".ot") {
    copy_file(product(map, "map" + end), to);
  } else if (end == ".yaml") {
    write_map(read_map(product(map, "costmap.yaml")), to);
  } else if (end == ".las") {
    write_las(to, read_cloud(product(map, "map.pcd")));
  } else {
    throw InputError(printable(to) + ": its name says no kind of map; end it with .pcd, .ply, .las, .bt, .ot or .yaml");
  }
  return 0;
}

}  // namespace scanway::tools
