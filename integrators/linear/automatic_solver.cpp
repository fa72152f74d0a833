#include "linear/automatic_solver.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "linear/banded_solver.hpp"
#include "linear/checked_solver.hpp"
#include "linear/condensed_solver.hpp"
#include "linear/klu_solver.hpp"
#include "linear/memory_limit.hpp"
#include "linear/umfpack_solver.hpp"

namespace talus::linear {
namespace {

// Seconds of a factorisation with the solves that follow it, from counted operations, entries of the factors and of the
// matrix, fitted to the table in the room's README. Only their ratios matter.
constexpr double solves = 10.0;
constexpr double klu_speed = 2.2e9;
double klu_seconds(const Statistics& s) { return s.flops / klu_speed + solves * 5e-9 * static_cast<double>(s.fill); }
double umfpack_seconds(const Statistics& s, Index n_nonzeros) {
  return s.flops / 6e9 + 8e-8 * static_cast<double>(n_nonzeros) +
         (7e-9 + solves * 2.1e-9) * static_cast<double>(s.fill);
}
double banded_seconds(const BandedSolver& solver) {
  const double width = static_cast<double>(solver.lower()),
               entries = static_cast<double>(solver.memory() / sizeof(double));
  return solver.flops_bound() * (1.0 + 70.0 / (width + 1.0)) / 30e9 + (0.5e-9 + solves * 1.36e-9) * entries;
}

/// Two threads share the band, at a price for each handing over. Single precision takes half as long.
double condensed_seconds(const CondensedSolver& solver) {
  constexpr double handing_over = 3e-5;
  const auto width = static_cast<double>(solver.width()), kept = static_cast<double>(solver.n_kept());
  const double entries = kept * (3.0 * width + 1.0), share = solver.allows_single() ? 0.3 : 0.6;
  return share * (solver.flops_bound() * (1.0 + 70.0 / (width + 1.0)) / 30e9 + (0.5e-9 + solves * 1.36e-9) * entries) +
         (1.0 + solves) * handing_over;
}

/// The least that KLU and UMFPACK could take for a matrix of a column model, whose factors hold six to eight times its entries
/// on grids of many columns and layers (README).
double least_seconds_of_general_solvers(Index n_nonzeros) {
  Statistics least;
  least.fill = 3 * n_nonzeros;
  return std::min(klu_seconds(least), umfpack_seconds(least, n_nonzeros));
}
constexpr Index worth_foresight = 20000;  ///< entries; below, trials cost nothing and fill may be less

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
  Index place = -1;  // of a singularity
  const auto offer = [&](const char* name, std::unique_ptr<CheckedSolver> solver, const auto& predict) {
    trials << (trials.str().empty() ? "" : ", ") << name;
    try {
      solver->demand(settings_.accuracy);
      solver->factor(values);
      const double seconds = predict(solver->statistics()), residual = solver->prove();
      trials << ' ' << seconds * 1e3 << " ms";
      if (!solver->acceptable(residual)) {
        trials << " (residual " << residual << ')';
      } else if (seconds < best) {
        best = seconds;
        chosen_ = std::move(solver);
      }
    } catch (const SingularMatrix& error) {
      trials << " no (" << error.what() << ')';
      place = std::max(place, error.place());
    }
  };

  auto condensed = std::make_unique<CondensedSolver>(pattern_);
  condensed->demand(settings_.accuracy);
  const double condensed_takes = condensed->n_kept() < pattern_.n() ? condensed_seconds(*condensed) : HUGE_VAL;
  const auto offer_condensed = [&] {
    offer("condensed", std::move(condensed), [&](const Statistics&) { return condensed_takes; });
  };
  auto banded = std::make_unique<BandedSolver>(pattern_, settings_.ordering);
  const double band_seconds = banded_seconds(*banded);
  if (pattern_.n_nonzeros() >= worth_foresight &&
      condensed_takes < std::min(band_seconds, least_seconds_of_general_solvers(pattern_.n_nonzeros()))) {
    offer_condensed();
    if (chosen_) {
      trials_ = trials.str() + ", which no other could match";
      return;
    }
  }
  double fewest_flops = HUGE_VAL;
  Index least_fill = 0;
  const auto umfpack = [&](const Statistics& s) {
    if (s.flops < fewest_flops) least_fill = s.fill;
    fewest_flops = std::min(fewest_flops, s.flops);
    return umfpack_seconds(s, pattern_.n_nonzeros());
  };
  offer("UMFPACK unsymmetric", std::make_unique<UmfpackSolver>(pattern_, UmfpackSolver::Strategy::unsymmetric),
        umfpack);
  {
    // Without a good diagonal this strategy fills in without bound.
    const MemoryLimit limit(chosen_ ? 2 * bytes_an_entry * static_cast<std::size_t>(least_fill) : 0);
    offer("UMFPACK symmetric", std::make_unique<UmfpackSolver>(pattern_, UmfpackSolver::Strategy::symmetric), umfpack);
  }
  // KLU needs about the operations and the fill of UMFPACK: that tells beforehand where it cannot win, and when to stop
  // it.
  if (fewest_flops / klu_speed < std::min(best, band_seconds)) {
    const KluSolver::Settings klu{settings_.pivot_tolerance, settings_.ordering, 2 * least_fill};
    offer("KLU", std::make_unique<KluSolver>(pattern_, klu), klu_seconds);
  }
  if (band_seconds < best) {
    offer("banded", std::move(banded), [band_seconds](const Statistics&) { return band_seconds; });
  }
  if (condensed && condensed_takes < best) offer_condensed();
  trials_ = trials.str();
  if (!chosen_) throw SingularMatrix("no direct solver gives usable factors: " + trials_, place);
}

const Statistics& AutomaticSolver::statistics() const {
  static const Statistics none;
  return chosen_ ? chosen_->statistics() : none;
}

std::string AutomaticSolver::describe() const {
  return chosen_ ? chosen_->describe() + "; predicted on the first matrix: " + trials_ : "automatic, not chosen yet";
}

}  // namespace talus::linear
