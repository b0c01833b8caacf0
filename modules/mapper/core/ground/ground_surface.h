#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "modules/mapper/core/cloud/map_points.h"
#include "modules/mapper/core/ground/ground_plane.h"
#include "modules/mapper/core/ground/plane_sums.h"

namespace scanway {

struct GroundSurfaceConfig {
  double climbable_step_m = 0.02;
  double climbable_slope = 0.2618;  ///< Radians.
  double range_sigma_m = 0.01;
  double max_range_m = 30.0;  ///< From the sensor, horizontally: the surface ends there.
  /// Ground that cannot be reached is ground all the same (a pavement, a traffic island, the bottom of a trench) where
  /// it shows so much area at one level, square metres. Infinite: only what can be reached.
  double least_level_m2 = std::numeric_limits<double>::infinity();
  double highest_level_m = 0.2;  ///< Above the nearest ground: what is higher is furniture.
};

/// The ground of one sweep, piecewise: what the robot reaches from where it stands without a step that it cannot climb.
///
/// Space is cut into columns of 0.1 m. Starting around the robot, a column joins when it shows points within the
/// climbable step (widened by the range's deviation, as the paper widens its band) of a joined column at most 0.3 m
/// away, or of how the ground goes on from there: by the plane through what has joined within 0.3 m, so that a ramp of
/// which only lines are seen is followed up. Floor across a gap or a shadow joins when it lies at the height of the
/// nearest floor towards the robot, and does not lean, unless it is larger than any thing that might lie there. A
/// platform, a table or a kerb that is too high to climb therefore never joins, however flat it is.
///
/// A level that cannot be reached so is ground, too, where it is large, does not lean and is not high above what is
/// (see the config). Its area is that which its columns carry: far from the sensor few of them show points.
///
/// Where heights jump by more than the widened step between one side of a column and the other, slopes on both sides
/// allowed for, a step runs through it: its ground is that of the lower side, whose returns from the step's face and
/// what is on top then lie above. So it is where the heights within a column spread over more than the step and much
/// more than in those around it: a step's face, seen from afar. And so it is where a column shows points below its
/// ground, and within 0.3 m there is ground as low: an upright side, as of a ramp.
///
/// A column is carried when at least two joined columns within 0.3 m agree on one plane: of their points at most a
/// tenth in columns that are off it by more than the widened step, and its slope climbable. The height in the column is
/// that plane's. Where they lie further off a plane than half a step, those count that lie as the nearest does, so that
/// a low step is no slope.
class GroundSurface {
 public:
  static constexpr double kColumn = 0.1;  ///< Metres.
  static constexpr int kReach = 3;        ///< Columns: 0.3 m.

  GroundSurface(const MapPoints& points, const GroundPlane& plane, const GroundSurfaceConfig& config);

  struct Place {
    bool carried = false;
    int support = 0;                      ///< Joined columns within 0.3 m.
    double height = 0.0;                  ///< Metres, map frame.
    double slope_x = 0.0, slope_y = 0.0;  ///< Metres up a metre along x and y.
  };
  /// The ground at (x, y), map frame. Its height is that of the column's plane where it is carried, else of the nearest
  /// carried column's ground, else (beyond the surface) of the ground plane.
  Place at(double x, double y) const;
  bool carried(double x, double y) const { return at(x, y).carried; }
  /// Whether anything in the rectangle is carried.
  bool carries_within(double x0, double y0, double x1, double y1) const;
  double height_at(double x, double y) const { return at(x, y).height; }
  const GroundPlane& plane() const { return plane_; }
  double area_m2() const;  ///< Of the joined columns.

 private:
  /// Heights are above the ground plane, in 0.1 mm, as integers: their sums do not depend on the order of points.
  struct Column {
    std::int32_t x_sum = 0, y_sum = 0, u_sum = 0, count = 0;  ///< Of its ground points; x, y from its corner.
    bool joined = false;
    bool carried = false;
    bool face = false;                    ///< A step's face lies in it, so that its mean is no ground's.
    bool step = false;                    ///< A step runs through it, to
    std::int32_t lower = 0;               ///< what lies so high on its lower side.
    std::int32_t lowest = 0, spread = 0;  ///< Of all points about its ground: the least, the standard deviation.
    std::uint8_t support = 0;
    float height = 0.0f, slope_x = 0.0f, slope_y = 0.0f;  ///< Above the ground plane; at the column's centre.
  };
  struct Point {
    std::uint64_t key;  ///< Its column.
    std::int16_t x, y;
    std::int32_t u;
  };

  struct Samples;
  using Plane = LocalPlane;  ///< About a column's centre, above the ground plane.

  void sort_points(const MapPoints& points);
  bool join(std::size_t which, std::int32_t expected);
  /// All that joined, the front first.
  std::vector<std::size_t> grow(std::vector<std::size_t> front, const std::vector<Eigen::Vector2i>& reach);
  /// How the ground goes on from a joined column: as the plane that carries it, or level where none is known.
  Plane ahead_of(std::size_t column) const;
  void start_around_robot();
  void cross_gaps();
  void join_levels();
  bool try_level(std::size_t seed, std::vector<bool>& tried);
  bool is_level(const std::vector<std::size_t>& columns) const;
  void keep_if_level(const std::vector<std::size_t>& columns);
  void leave(const std::vector<std::size_t>& columns, std::vector<bool>& tried);
  double area_around(const std::vector<std::size_t>& columns) const;
  bool flat(std::size_t column, std::int32_t& height) const;
  std::int32_t nearest_ground(std::size_t column) const;
  void find_steps();
  void find_faces();
  void find_face(int cx, int cy);
  void measure_spread(std::size_t column);
  void find_step(int cx, int cy, int dx, int dy);
  std::int32_t lowest_around(int cx, int cy) const;
  void find_edge(int cx, int cy);
  bool stepped_between(int cx, int cy, int x, int y) const;
  Samples samples_around(int cx, int cy) const;
  /// What carries the robot there: the samples agree on it and its slope can be climbed.
  std::optional<Plane> carrying_plane(const Samples& samples) const;
  void fit_column(int cx, int cy);
  void fill_outwards();
  bool empty(std::size_t column) const { return first_[column] == first_[column + 1]; }
  std::int32_t mean(std::size_t column) const { return columns_[column].u_sum / columns_[column].count; }
  /// Its ground as far as it can be trusted beside others; nothing for few points.
  const Column* firm(int cx, int cy) const;
  bool inside(int cx, int cy) const { return cx >= 0 && cy >= 0 && cx < side_ && cy < side_; }
  std::size_t index(int cx, int cy) const { return static_cast<std::size_t>(cy) * side_ + cx; }

  GroundPlane plane_;
  GroundSurfaceConfig config_;
  int side_ = 0;           ///< Columns along an edge of the square.
  double corner_x_ = 0.0;  ///< Map coordinates of the square's lowest corner: multiples of kColumn.
  double corner_y_ = 0.0;
  std::int32_t band_ = 0;
  std::vector<Column> columns_;
  std::vector<Point> points_;       ///< By column.
  std::vector<std::size_t> first_;  ///< A column's first point; one more at the end.
};

}  // namespace scanway
