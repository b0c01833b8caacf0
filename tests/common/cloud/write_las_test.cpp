// Against a reader that knows the specification and nothing of ours (read_las.py).
#include "common/cloud/write_las.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include "common/files/input_error.h"
#include "common/random/random.h"
#include "tests/support/command.h"

namespace scanway::test {
namespace {

std::istringstream as_read(const std::string& path) {
  const CommandResult read = run_command({"python3", SCANWAY_SOURCE_DIR "/tests/common/cloud/read_las.py", path});
  EXPECT_EQ(read.status, 0) << read.err;
  return std::istringstream(read.out);
}

TEST(WriteLas, IsReadByTheSpecification) {
  const ScratchFolder scratch;
  Random random(4);
  PointCloud cloud;
  for (int i = 0; i < 1000; ++i) {
    const auto coordinate = [&] { return static_cast<float>(200.0 * random.uniform() - 100.0); };
    cloud.points.emplace_back(coordinate(), coordinate(), coordinate());
    cloud.intensity.push_back(static_cast<float>(70000.0 * random.uniform() - 1000.0));
  }
  write_las(scratch / "cloud.las", cloud);
  std::istringstream lines = as_read(scratch / "cloud.las");
  std::string head;
  std::getline(lines, head);
  EXPECT_EQ(head, "LAS 1.2 1000 points 0 records");
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    double x = 0, y = 0, z = 0, intensity = 0;
    lines >> x >> y >> z >> intensity;
    EXPECT_NEAR(x, static_cast<double>(cloud.points[i].x()), 0.5001e-4);
    EXPECT_NEAR(y, static_cast<double>(cloud.points[i].y()), 0.5001e-4);
    EXPECT_NEAR(z, static_cast<double>(cloud.points[i].z()), 0.5001e-4);
    EXPECT_NEAR(intensity, std::min(65535.0, std::max(0.0, static_cast<double>(cloud.intensity[i]))), 0.5001);
  }
}

TEST(WriteLas, OfNoPointIsAFileToo) {
  const ScratchFolder scratch;
  write_las(scratch / "empty.las", {});
  std::string head;
  std::istringstream lines = as_read(scratch / "empty.las");
  std::getline(lines, head);
  EXPECT_EQ(head, "LAS 1.2 0 points 0 records");
}

TEST(WriteLas, RefusesWhatTheFormatDoesNotReach) {
  const ScratchFolder scratch;
  PointCloud cloud;
  cloud.points.emplace_back(0.0F, 3e5F, 0.0F);
  EXPECT_THROW(write_las(scratch / "far.las", cloud), InputError);
}

}  // namespace
}  // namespace scanway::test
