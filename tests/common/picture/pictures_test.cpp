#include "common/picture/pictures.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include <cairo.h>
#include <gtest/gtest.h>

#include "common/files/input_error.h"
#include "common/picture/map_raster.h"
#include "common/random/random.h"

namespace scanway {
namespace {

namespace fs = std::filesystem;

/// A PNG file, decoded.
struct Png {
  int width = 0, height = 0;
  std::vector<std::uint32_t> pixels;

  explicit Png(const std::string& path) {
    cairo_surface_t* image = cairo_image_surface_create_from_png(path.c_str());
    width = cairo_image_surface_get_width(image);
    height = cairo_image_surface_get_height(image);
    const unsigned char* bytes = cairo_image_surface_get_data(image);
    for (int y = 0; y < height; ++y) {
      const auto* row = reinterpret_cast<const std::uint32_t*>(bytes + y * cairo_image_surface_get_stride(image));
      for (int x = 0; x < width; ++x) pixels.push_back(row[x] & 0xFFFFFF);
    }
    cairo_surface_destroy(image);
  }
  std::size_t count(Colour c) const {
    const std::uint32_t value = std::uint32_t{c.red} << 16 | std::uint32_t{c.green} << 8 | c.blue;
    return static_cast<std::size_t>(std::ranges::count(pixels, value));
  }
};

class Pictures : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              (std::string("pictures_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string bytes(const std::string& name) const {
    std::ifstream in(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  fs::path folder_;
};

/// A free floor of 6 m x 3 m with a wall across, half unknown beyond it.
CostMap room() {
  CostMap map{0.02, -1.0, 2.0, {}};
  for (int y = 0; y < 150; ++y) {
    for (int x = 0; x < 300; ++x) {
      if (x < 200 || y < 75) map.set_state({x, y}, x == 200 ? CellState::occupied : CellState::free);
      if (x > 190 && x < 200) map.set_cost({x, y}, x > 195 ? kCostLethal : kCostOne / 2);
    }
  }
  return map;
}

PointCloud box_of_points(std::size_t n) {
  Random random(1);
  PointCloud cloud;
  for (std::size_t i = 0; i < n; ++i) {
    cloud.points.emplace_back(static_cast<float>(20 * random.uniform()), static_cast<float>(10 * random.uniform()),
                              static_cast<float>(3 * random.uniform()));
  }
  return cloud;
}

TEST_F(Pictures, TheSameInputGivesTheSameBytes) {
  draw_cloud_from_above(path("a.png"), box_of_points(20000), 2.0);
  draw_cloud_from_above(path("b.png"), box_of_points(20000), 2.0);
  EXPECT_EQ(bytes("a.png"), bytes("b.png"));
  const PathPicture paths{{-0.5, 2.5}, {2.5, 4.5}, {{-0.5, 2.5}, {2.5, 4.5}}, {{-0.5, 2.5}, {1, 4}, {2.5, 4.5}}};
  draw_path(path("c.png"), room(), paths);
  draw_path(path("d.png"), room(), paths);
  EXPECT_EQ(bytes("c.png"), bytes("d.png"));
  draw_path(path("d.png"), room(), {paths.start_m, paths.goal_m, {}, paths.with_embodiment});
  EXPECT_NE(bytes("c.png"), bytes("d.png"));
}

TEST_F(Pictures, TheCostMapShowsEveryStateInItsShare) {
  draw_cost_map(path("map.png"), room());
  const Png png(path("map.png"));
  EXPECT_LE(std::max(png.width, png.height), 1650);
  // 302 x 152 cells with the border, at 4 pixels a cell.
  const double cell = 16;
  EXPECT_NEAR(static_cast<double>(png.count(kOccupiedColour)), 75 * cell, 500);  // the legend's field beside it
  EXPECT_NEAR(static_cast<double>(png.count(kLethalColour)), 150 * 4 * cell, 500);
  EXPECT_NEAR(static_cast<double>(png.count(kUnknownColour)), (302 * 152 - 200 * 150 - 100 * 75) * cell, 500);
}

TEST_F(Pictures, AThinObstacleSurvivesShrinking) {
  CostMap map{0.01, 0, 0, {}};
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 9000; ++x) map.set_state({x, y}, x == 4321 ? CellState::occupied : CellState::free);
  }
  const Raster raster = raster_of(map, {{0, 0}, {9000, 100}});
  EXPECT_EQ(raster.width, 1500);
  const Colour thin = raster.at(4321 / 6, raster.height / 2);
  EXPECT_LT(thin.red, 130);
  EXPECT_EQ(raster.at(4321 / 6 + 1, raster.height / 2), kFreeColour);
}

TEST_F(Pictures, TheCeilingIsCutAway) {
  PointCloud cloud = box_of_points(20000);
  draw_cloud_from_above(path("cut.png"), cloud, 2.0);
  std::erase_if(cloud.points, [](const Eigen::Vector3f& p) { return p.z() > 2.0f; });
  draw_cloud_from_above(path("none.png"), cloud, 2.0);
  EXPECT_EQ(bytes("cut.png"), bytes("none.png"));
}

TEST_F(Pictures, StrangeInputGivesAPicture) {
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN(), kHuge = 1e30f;
  const std::vector<std::vector<Eigen::Vector3f>> clouds = {{},
                                                            {{0, 0, 0}},
                                                            {{kNaN, 0, 0}, {1, 2, kNaN}},
                                                            {{0, 0, 9}},
                                                            {{1, 1, 1}, {1, 1, 1}},
                                                            {{-kHuge, 0, 0}, {kHuge, 1, 0}}};
  for (const auto& points : clouds) {
    draw_cloud_from_above(path("cloud.png"), {points, {}, {}}, 2.0);
    EXPECT_GT(Png(path("cloud.png")).width, 100);
  }
  draw_cost_map(path("map.png"), CostMap{});
  EXPECT_GT(Png(path("map.png")).width, 100);
  draw_path(path("path.png"), CostMap{}, {{0, 0}, {5, 5}, {}, {}});
  draw_path(path("path.png"), room(), {{-1e12, 0}, {1e12, 5}, {}, {}});
  draw_path(path("path.png"), room(), {{100, 100}, {101, 101}, {}, {}});  // off the map
  EXPECT_GT(Png(path("path.png")).width, 100);
}

TEST_F(Pictures, AFolderThatIsNotThereIsAnInputError) {
  EXPECT_THROW(draw_cost_map(path("missing/map.png"), room()), InputError);
}

}  // namespace
}  // namespace scanway
