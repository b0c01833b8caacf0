#pragma once

#include <cstddef>
#include <vector>

#include "modules/mapper/core/graph/pose_graph.h"

namespace scanway {

/// H x = -g for nodes of six unknowns each, H symmetric and positive: its lower triangle by rows of 6x6 blocks from the
/// first that is not zero (envelope or skyline storage), solved by Cholesky's method. All sums in a fixed order, blocks
/// of fixed size: the same bits on every processor, which a general sparse solver does not promise.
class NormalEquations {
 public:
  /// `first[i]`: the lowest column that row i uses, at most i.
  explicit NormalEquations(const std::vector<std::size_t>& first);

  void add(std::size_t row, std::size_t column, const Matrix6& block);  ///< column <= row.
  void add(std::size_t row, const Vector6& gradient) { gradient_[row] += gradient; }
  /// x; destroys H. Unknowns that nothing holds stay.
  std::vector<Vector6> solve();

 private:
  Matrix6& block(std::size_t row, std::size_t column) { return blocks_[begin_[row] + column - first_[row]]; }
  void factorise(std::size_t row);

  std::vector<std::size_t> first_, begin_;
  std::vector<Matrix6> blocks_;
  std::vector<Vector6> gradient_;
};

}  // namespace scanway
