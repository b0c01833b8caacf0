#include "modules/simulator/files/labelled_pcd.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include <fmt/format.h>

#include "common/files/atomic_file.h"

namespace scanway::simulator {
namespace {

static_assert(std::endian::native == std::endian::little);

struct Row {
  float x, y, z, rssi;
  std::uint32_t label;
  std::int32_t time_us;
};
static_assert(sizeof(Row) == 24);

std::string header(const Sweep& sweep) {
  const std::size_t points = sweep.cloud.size();
  return fmt::format(
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z intensity label time_us\n"
      "SIZE 4 4 4 4 4 4\nTYPE F F F F U I\nCOUNT 1 1 1 1 1 1\nWIDTH {}\nHEIGHT 1\n"
      "VIEWPOINT {} {} {} 1 0 0 0\nPOINTS {}\nDATA binary\n",
      points, sweep.origin.x(), sweep.origin.y(), sweep.origin.z(), points);
}

}  // namespace

void write_labelled_pcd(const std::string& path, const LabelledSweep& labelled) {
  constexpr std::size_t kBlock = 65536;
  const Sweep& sweep = labelled.sweep;
  AtomicFile file(path);
  file.write(header(sweep));
  std::vector<Row> rows;
  for (std::size_t begin = 0; begin < sweep.cloud.size(); begin += kBlock) {
    const std::size_t end = std::min(sweep.cloud.size(), begin + kBlock);
    rows.clear();
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3f& p = sweep.cloud.points[i];
      rows.push_back({p.x(), p.y(), p.z(), sweep.cloud.intensity[i], static_cast<std::uint32_t>(labelled.labels[i]),
                      sweep.time_offset_us[i]});
    }
    file.write({reinterpret_cast<const char*>(rows.data()), rows.size() * sizeof(Row)});
  }
  file.commit();
}

}  // namespace scanway::simulator
