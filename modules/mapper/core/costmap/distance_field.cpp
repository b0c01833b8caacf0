#include "modules/mapper/core/costmap/distance_field.h"

#include <algorithm>

namespace scanway {
namespace {

/// Distance along the column to the nearest occupied cell, at most limit + 1.
std::vector<std::uint8_t> column_distances(const OccupancyWindow& window, int limit) {
  const auto width = static_cast<std::size_t>(window.width);
  const auto none = static_cast<std::uint8_t>(limit + 1);
  std::vector<std::uint8_t> distance(window.occupied.size());
  const auto relax = [&](std::size_t row, std::size_t neighbour) {
    std::uint8_t* here = &distance[row * width];
    const std::uint8_t* there = &distance[neighbour * width];
    for (std::size_t x = 0; x < width; ++x) {
      const auto further = static_cast<std::uint8_t>(std::min<int>(there[x] + 1, none));
      here[x] = std::min(here[x], further);
    }
  };
  for (std::size_t i = 0; i < distance.size(); ++i) distance[i] = window.occupied[i] != 0 ? 0 : none;
  for (int y = 1; y < window.height; ++y) relax(static_cast<std::size_t>(y), static_cast<std::size_t>(y - 1));
  for (int y = window.height - 2; y >= 0; --y) relax(static_cast<std::size_t>(y), static_cast<std::size_t>(y + 1));
  return distance;
}

/// The lower envelope of the parabolas (x - q)^2 + g(q)^2 over one row.
class RowEnvelope {
 public:
  explicit RowEnvelope(int width) : vertex_(width), begin_(width) {}

  void fill(const std::uint8_t* g, int width, int limit, std::uint32_t* squared) {
    int count = 0;
    for (int q = 0; q < width; ++q) {
      if (g[q] > limit) continue;
      int begin = 0;
      while (count > 0) {
        begin = first_won_by(q, vertex_[count - 1], g);
        if (begin > begin_[count - 1]) break;
        --count;
      }
      if (count == 0) begin = 0;
      if (begin >= width) continue;
      vertex_[count] = q;
      begin_[count++] = begin;
    }
    const auto none = static_cast<std::uint32_t>((limit + 1) * (limit + 1));
    std::fill(squared, squared + width, none);
    for (int i = 0; i < count; ++i) {
      const int q = vertex_[i], end = i + 1 < count ? begin_[i + 1] : width;
      const int from = std::max(begin_[i], q - limit), to = std::min(end, q + limit + 1);
      for (int x = from; x < to; ++x) {
        const auto value = static_cast<std::uint32_t>((x - q) * (x - q) + g[q] * g[q]);
        squared[x] = value <= static_cast<std::uint32_t>(limit * limit) ? value : none;
      }
    }
  }

 private:
  /// The least x at which the parabola of q lies below that of p, p < q.
  static int first_won_by(int q, int p, const std::uint8_t* g) {
    const int above = q * q + g[q] * g[q] - p * p - g[p] * g[p], twice = 2 * (q - p);
    return above < 0 ? 0 : above / twice + 1;  // ties stay with p: the distance is the same
  }

  std::vector<int> vertex_, begin_;
};

}  // namespace

std::vector<std::uint32_t> squared_distances(const OccupancyWindow& window, int limit) {
  const std::vector<std::uint8_t> columns = column_distances(window, limit);
  std::vector<std::uint32_t> squared(columns.size());
  RowEnvelope envelope(window.width);
  for (int y = 0; y < window.height; ++y) {
    const std::size_t row = static_cast<std::size_t>(y) * window.width;
    envelope.fill(&columns[row], window.width, limit, &squared[row]);
  }
  return squared;
}

}  // namespace scanway
