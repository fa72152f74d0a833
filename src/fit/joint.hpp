#pragma once

#include <Eigen/Core>
#include <deque>
#include <string>
#include <vector>

#include "fit/evaluation.hpp"
#include "fit/problem.hpp"

namespace talus::fit {

/// Runs of the layer's scene; a fit asks for them in batches that may run side by side.
class LayerRuns {
 public:
  virtual ~LayerRuns() = default;
  /// The model's value beside each datum for each point: one number an unknown of the problem, then one of the stage; or why
  /// the run failed.
  virtual std::vector<steady::Answer<Eigen::VectorXd>> at(const std::vector<Eigen::VectorXd>& points) = 0;
  /// Told after each batch: chi2 of all data and priors at its first point, infinite where that failed.
  virtual void told(int n_runs, const Eigen::VectorXd& first, double chi2) = 0;
};

/// Steady flow and layer beside all data, in one sum of squares; derivatives of the layer are differences of runs.
class Joint {
 public:
  /// The arguments must outlive this.
  Joint(const Model& steady, const LayerStage& stage, LayerRuns& runs);

  [[nodiscard]] const std::vector<Variable>& variables() const { return variables_; }
  /// Slopes, speeds, the layer's data.
  [[nodiscard]] int n_data() const { return steady_.n_data() + n_layer(); }
  [[nodiscard]] int n_residuals() const;

  /// What was found at a point.
  struct Point {
    Eigen::VectorXd x;
    Evaluation
        evaluation;  ///< residuals of data, then priors. Of a failed run those of the layer's data are large, without derivatives
    Eigen::VectorXd model;  ///< of each of the layer's data; empty where the run failed
  };
  /// By one run and one more an unknown, unless it is known already. Null where a steady flow does not exist there, or where
  /// runs are used up.
  const Point* at(const Eigen::VectorXd& x);
  [[nodiscard]] bool used_up() const { return used_up_; }
  [[nodiscard]] int n_runs() const { return n_runs_; }
  [[nodiscard]] const std::vector<std::string>& failures() const { return failures_; }

  /// By how much [standard deviations] data of the layer differ between two runs at nearly equal parameters: the norm. One run.
  double noise(const Point& point);

 private:
  using Answers = std::vector<steady::Answer<Eigen::VectorXd>>;
  [[nodiscard]] int n_layer() const { return static_cast<int>(stage_.data.size()); }
  [[nodiscard]] bool is_same(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;
  [[nodiscard]] double shift(const Eigen::VectorXd& x, Eigen::Index variable) const;
  Answers run(const std::vector<Eigen::VectorXd>& all_x);
  [[nodiscard]] Evaluation around(const Evaluation& steady, const Eigen::VectorXd& x) const;
  void put_layer(Point& point, const Answers& answers, const std::vector<Eigen::VectorXd>& all_x);
  [[nodiscard]] Eigen::VectorXd residuals(const Eigen::VectorXd& model) const;

  const Model& steady_;
  const LayerStage& stage_;
  LayerRuns& runs_;
  std::vector<Variable> variables_;
  std::vector<Eigen::Index> varied_;  ///< variables that a run knows: all but surface offsets
  std::deque<Point> known_;           // pointers to them stay good
  std::vector<std::string> failures_;
  int n_runs_ = 0;
  bool used_up_ = false;
};

}  // namespace talus::fit
