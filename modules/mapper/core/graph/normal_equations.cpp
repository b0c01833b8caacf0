#include "modules/mapper/core/graph/normal_equations.h"

#include <algorithm>
#include <cmath>

namespace scanway {
namespace {

/// Holds what no edge holds, and nothing else: a thousandth of the weakest that an edge says.
constexpr double kLeastInformation = 1e-6;

/// A = L L^T in place, lower triangle.
void cholesky(Matrix6& A) {
  for (int j = 0; j < 6; ++j) {
    for (int k = 0; k < j; ++k) A(j, j) -= A(j, k) * A(j, k);
    A(j, j) = std::sqrt(std::max(A(j, j), kLeastInformation));
    for (int i = j + 1; i < 6; ++i) {
      for (int k = 0; k < j; ++k) A(i, j) -= A(i, k) * A(j, k);
      A(i, j) /= A(j, j);
    }
  }
}

/// x = L^-1 b.
Vector6 forward(const Matrix6& L, Vector6 b) {
  for (int i = 0; i < 6; ++i) {
    for (int k = 0; k < i; ++k) b[i] -= L(i, k) * b[k];
    b[i] /= L(i, i);
  }
  return b;
}

/// x = L^-T b.
Vector6 backward(const Matrix6& L, Vector6 b) {
  for (int i = 5; i >= 0; --i) {
    for (int k = i + 1; k < 6; ++k) b[i] -= L(k, i) * b[k];
    b[i] /= L(i, i);
  }
  return b;
}

}  // namespace

NormalEquations::NormalEquations(const std::vector<std::size_t>& first) : first_(first) {
  std::size_t count = 0;
  for (std::size_t row = 0; row < first.size(); ++row) {
    begin_.push_back(count);
    count += row - first[row] + 1;
  }
  blocks_.assign(count, Matrix6::Zero());
  gradient_.assign(first.size(), Vector6::Zero());
}

void NormalEquations::add(std::size_t row, std::size_t column, const Matrix6& value) { block(row, column) += value; }

void NormalEquations::factorise(std::size_t row) {
  for (std::size_t column = first_[row]; column <= row; ++column) {
    Matrix6& target = block(row, column);
    for (std::size_t k = std::max(first_[row], first_[column]); k < column; ++k) {
      target -= block(row, k) * block(column, k).transpose();
    }
    if (column == row) {
      cholesky(target);
    } else {  // L_rc = A_rc L_cc^-T, row by row
      for (int i = 0; i < 6; ++i) target.row(i) = forward(block(column, column), target.row(i).transpose()).transpose();
    }
  }
}

std::vector<Vector6> NormalEquations::solve() {
  const std::size_t n = first_.size();
  std::vector<Vector6> x(n);
  for (std::size_t row = 0; row < n; ++row) {
    block(row, row).diagonal().array() += kLeastInformation;
    factorise(row);
    x[row] = -gradient_[row];
    for (std::size_t k = first_[row]; k < row; ++k) x[row] -= block(row, k) * x[k];
    x[row] = forward(block(row, row), x[row]);
  }
  for (std::size_t row = n; row-- > 0;) {
    x[row] = backward(block(row, row), x[row]);
    for (std::size_t k = first_[row]; k < row; ++k) x[k] -= block(row, k).transpose() * x[row];
  }
  return x;
}

}  // namespace scanway
