#include "linear/automatic_solver.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "linear/banded_solver.hpp"
#include "linear/checked_solver.hpp"
#include "linear/klu_solver.hpp"
#include "linear/umfpack_solver.hpp"

namespace talus::linear {
namespace {

// Operations a second of each library's kernels and seconds an entry of the matrix or of the factors, fitted to the table in
// the room's README. Only their ratios matter.
double klu_seconds(const Statistics& s) { return s.flops / 0.9e9 + 6e-9 * static_cast<double>(s.fill); }
double umfpack_seconds(const Statistics& s, Index n_nonzeros) {
  return s.flops / 6e9 + 6e-9 * static_cast<double>(s.fill) + 5e-8 * static_cast<double>(n_nonzeros);
}
double banded_seconds(const BandedSolver& solver) {
  const double width = static_cast<double>(std::max<Index>(solver.lower(), 1));
  return solver.flops_bound() / (12e9 * width / (width + 100.0)) + 0.5e-9 * static_cast<double>(solver.memory() / sizeof(double));
}

}  // namespace

AutomaticSolver::AutomaticSolver(const SparsePattern& pattern, Settings settings)
    : pattern_(pattern), settings_(std::move(settings)) {}

void AutomaticSolver::factor(std::span<const double> values) {
  if (chosen_) chosen_->factor(values);
  else choose(values);
}

void AutomaticSolver::choose(std::span<const double> values) {
  std::ostringstream trials;
  trials.precision(2);
  double best = HUGE_VAL;
  const auto offer = [&](const char* name, std::unique_ptr<DirectSolver> solver, const auto& predict) {
    trials << (trials.str().empty() ? "" : ", ") << name << ' ';
    try {
      solver->factor(values);
      const double seconds = predict(solver->statistics());
      trials << "fill " << static_cast<double>(solver->statistics().fill) << " predicted " << seconds * 1e3 << " ms";
      if (solver->statistics().test_residual > CheckedSolver::accept_below) {
        trials << " (residual " << solver->statistics().test_residual << ')';
      } else if (seconds < best) {
        best = seconds;
        chosen_ = std::move(solver);
      }
    } catch (const SingularMatrix& error) {
      trials << "no: " << error.what();
    }
  };

  offer("UMFPACK", std::make_unique<UmfpackSolver>(pattern_),
        [&](const Statistics& s) { return umfpack_seconds(s, pattern_.n_nonzeros()); });
  // KLU can only win with factors that are not much larger; the limit keeps its trial short on wide grids.
  const Index max_fill = chosen_ ? 3 * chosen_->statistics().fill : 0;
  offer("KLU", std::make_unique<KluSolver>(pattern_, KluSolver::Settings{settings_.pivot_tolerance, settings_.ordering, max_fill}),
        klu_seconds);
  auto banded = std::make_unique<BandedSolver>(pattern_, settings_.ordering);
  if (const double seconds = banded_seconds(*banded); seconds < best) {
    offer("banded", std::move(banded), [seconds](const Statistics&) { return seconds; });
  } else {
    trials << ", banded predicted " << seconds * 1e3 << " ms";
  }
  trials_ = trials.str();
  if (!chosen_) throw SingularMatrix("no direct solver gives usable factors: " + trials_, -1);
}

const Statistics& AutomaticSolver::statistics() const {
  static const Statistics none;
  return chosen_ ? chosen_->statistics() : none;
}

std::string AutomaticSolver::describe() const {
  return chosen_ ? chosen_->describe() + "; chosen on the first matrix from: " + trials_ : "automatic, not chosen yet";
}

}  // namespace talus::linear
