#include "modules/mapper/core/graph/pose_graph.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "common/math/repeatable.h"
#include "modules/mapper/core/graph/normal_equations.h"
#include "modules/mapper/core/graph/spanning_tree.h"

namespace scanway {
namespace {

constexpr double kRightEdge = 22.46;     // chi-squared of 6 degrees of freedom: one right edge in a thousand is beyond
constexpr double kLeastCertainty = 0.5;  // probabilities are taken to lie between
constexpr double kMostCertainty = 0.9999;
constexpr int kRobustSteps = 12, kLastSteps = 8;
constexpr double kStill = 1e-8;  // metres and radians
constexpr std::size_t kMostExchanges = 200;

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& w) {
  Eigen::Matrix3d W;
  W << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
  return W;
}

/// What an edge may cost at most: where it is dropped.
double limit_of(const GraphEdge& edge) {
  const double p = std::clamp(edge.probability, kLeastCertainty, kMostCertainty);
  return kRightEdge + 2.0 * repeatable::log(p / (1.0 - p));
}

/// One solution, from a tree of edges that are right if anything is.
class Refinement {
 public:
  Refinement(const PoseGraph& graph, const SpanningTree& tree) : graph_(graph), poses_(tree.compose()) {
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
      information_.push_back(graph.edges[e].covariance.inverse());
      limit_.push_back(limit_of(graph.edges[e]));
      width_.push_back(tree.holds(e) ? 1.0 : 1.0 + static_cast<double>(tree.path(e).size()));
    }
    weight_.assign(graph.edges.size(), 1.0);
    for (std::size_t i = 1; i < graph.nodes.size(); ++i) first_.push_back(i - 1);
    for (const GraphEdge& edge : graph.edges) {
      const std::size_t low = std::min(edge.from, edge.to), high = std::max(edge.from, edge.to);
      if (low > 0) first_[high - 1] = std::min(first_[high - 1], low - 1);
    }
  }

  GraphSolution run() {
    for (int step = 0; step < kRobustSteps; ++step) {
      weigh(1.0 - static_cast<double>(step) / (kRobustSteps / 2));
      move();
    }
    for (int step = 0; step < kLastSteps; ++step) {
      for (std::size_t e = 0; e < weight_.size(); ++e) weight_[e] = chi_squared(e) <= limit_[e] ? 1.0 : 0.0;
      if (move() < kStill) break;
    }
    return conclude();
  }

 private:
  /// Of the edge, in the map's axes: [rotation vector, translation] that is left.
  Vector6 residual(std::size_t e) const {
    const GraphEdge& edge = graph_.edges[e];
    const Pose &from = poses_[edge.from], &to = poses_[edge.to];
    const Eigen::Matrix3d R = from.linear() * edge.T_from_to.linear();
    Vector6 r;
    r << log_so3(to.linear() * R.transpose()),
        to.translation() - from.translation() - from.linear() * edge.T_from_to.translation();
    return r;
  }

  Matrix6 information(std::size_t e) const {
    Matrix6 A = Matrix6::Zero();
    A.topLeftCorner<3, 3>() = A.bottomRightCorner<3, 3>() = poses_[graph_.edges[e].from].linear();
    return A * information_[e] * A.transpose();
  }

  double chi_squared(std::size_t e) const {
    const Vector6 r = residual(e);
    return r.dot(information(e) * r);
  }

  /// Geman-McClure; `wide` from 1 (as wide as the cycle) to 0 (the edge's own limit).
  void weigh(double wide) {
    for (std::size_t e = 0; e < weight_.size(); ++e) {
      const double limit = limit_[e] * (1.0 + std::max(0.0, wide) * (width_[e] - 1.0));
      const double root = limit / (limit + chi_squared(e));
      weight_[e] = root * root;
    }
  }

  /// One step of Gauss-Newton; returns how far the node moved that moved most.
  double move() {
    NormalEquations equations(first_);
    for (std::size_t e = 0; e < graph_.edges.size(); ++e) add_edge(e, equations);
    add_gravity(equations);
    const std::vector<Vector6> step = equations.solve();
    double most = 0.0;
    for (std::size_t i = 1; i < poses_.size(); ++i) {
      const Vector6& x = step[i - 1];
      poses_[i].linear() = nearest_rotation(exp_so3(x.head<3>()) * poses_[i].linear());
      poses_[i].translation() += x.tail<3>();
      most = std::max(most, x.cwiseAbs().maxCoeff());
    }
    return most;
  }

  /// The residual turns and shifts with `to` itself, and against `from`, about which `to` swings.
  void add_edge(std::size_t e, NormalEquations& equations) const {
    const GraphEdge& edge = graph_.edges[e];
    const Vector6 r = residual(e);
    const Matrix6 W = weight_[e] * information(e);
    Matrix6 J = -Matrix6::Identity();
    const Pose& from = poses_[edge.from];
    J.bottomLeftCorner<3, 3>() = cross_matrix(from.linear() * edge.T_from_to.translation());
    const Matrix6 JtW = J.transpose() * W;
    if (edge.to > 0) {
      equations.add(edge.to - 1, edge.to - 1, W);
      equations.add(edge.to - 1, W * r);
    }
    if (edge.from > 0) {
      equations.add(edge.from - 1, edge.from - 1, JtW * J);
      equations.add(edge.from - 1, JtW * r);
    }
    if (edge.from == 0 || edge.to == 0) return;
    const Matrix6 cross = edge.from > edge.to ? JtW : Matrix6(JtW.transpose());
    equations.add(std::max(edge.from, edge.to) - 1, std::min(edge.from, edge.to) - 1, cross);
  }

  /// Where all trackers together say that up is. The map stays as level as its first sweep was.
  Eigen::Vector3d mean_up() const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      if (graph_.nodes[i].up) sum += poses_[i].linear() * *graph_.nodes[i].up;
    }
    return sum.norm() > 0.0 ? Eigen::Vector3d(sum.normalized()) : Eigen::Vector3d::UnitZ();
  }

  void add_gravity(NormalEquations& equations) const {
    const Eigen::Vector3d up = mean_up();
    const double information = 1.0 / (graph_.tilt_sigma * graph_.tilt_sigma);
    for (std::size_t i = 1; i < poses_.size(); ++i) {
      if (!graph_.nodes[i].up) continue;
      const Eigen::Vector3d seen = poses_[i].linear() * *graph_.nodes[i].up;
      const Eigen::Matrix3d J = -cross_matrix(seen);
      Matrix6 H = Matrix6::Zero();
      H.topLeftCorner<3, 3>() = information * (J.transpose() * J);
      Vector6 g = Vector6::Zero();
      g.head<3>() = information * (J.transpose() * (seen - up));
      equations.add(i - 1, i - 1, H);
      equations.add(i - 1, g);
    }
  }

  GraphSolution conclude() const {
    GraphSolution solution;
    solution.poses = poses_;
    for (std::size_t e = 0; e < limit_.size(); ++e) {
      solution.chi_squared.push_back(chi_squared(e));
      solution.dropped.push_back(solution.chi_squared[e] > limit_[e]);
      solution.cost += std::min(solution.chi_squared[e], limit_[e]);
    }
    const Eigen::Vector3d up = mean_up();
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      if (!graph_.nodes[i].up) continue;
      const Eigen::Vector3d off = poses_[i].linear() * *graph_.nodes[i].up - up;
      solution.cost += off.squaredNorm() / (graph_.tilt_sigma * graph_.tilt_sigma);
    }
    return solution;
  }

  const PoseGraph& graph_;
  std::vector<Pose> poses_;
  std::vector<Matrix6> information_;  // Of each edge, in the axes of its `from`.
  std::vector<double> limit_, width_, weight_;
  std::vector<std::size_t> first_;  // The envelope.
};

struct Attempt {
  SpanningTree tree;
  GraphSolution solution;
};

Attempt attempt(const PoseGraph& graph, SpanningTree tree) {
  GraphSolution solution = Refinement(graph, tree).run();
  return {std::move(tree), std::move(solution)};
}

/// The best of what comes of leaving out, in the place of an edge that was dropped, another edge of its cycle.
bool improve(const PoseGraph& graph, Attempt& best, std::size_t& exchanges) {
  constexpr double kWorthIt = 1e-6;
  const Attempt now = best;
  for (std::size_t e = graph.edges.size(); e-- > 0;) {
    if (!now.solution.dropped[e] || now.tree.holds(e)) continue;
    for (const std::size_t inside : now.tree.path(e)) {
      if (exchanges == 0) break;
      --exchanges;
      Attempt other = attempt(graph, now.tree.exchange(inside, e));
      if (other.solution.cost < best.solution.cost - kWorthIt) best = std::move(other);
    }
  }
  return best.solution.cost < now.solution.cost;
}

}  // namespace

GraphSolution solve(const PoseGraph& graph) {
  Attempt best = attempt(graph, SpanningTree(graph));
  std::size_t exchanges = kMostExchanges;
  while (improve(graph, best, exchanges) && exchanges > 0) continue;
  return best.solution;
}

}  // namespace scanway
