#include "linear/automatic_solver.hpp"
#include "linear/banded_solver.hpp"
#include "linear/blas.hpp"
#include "linear/condensed_solver.hpp"
#include "linear/direct_solver.hpp"
#include "linear/klu_solver.hpp"
#include "linear/mumps_solver.hpp"
#include "linear/ordering.hpp"
#include "linear/umfpack_solver.hpp"

namespace talus::linear {
namespace {

/// The solver that `settings.chosen` names, or null.
std::unique_ptr<CheckedSolver> make_chosen(const SparsePattern& pattern, const Settings& settings) {
  const std::string& chosen = settings.chosen;
  using enum UmfpackSolver::Strategy;
  for (const auto strategy : {symmetric, dissected, unsymmetric})
    if (chosen == UmfpackSolver::name(strategy)) return std::make_unique<UmfpackSolver>(pattern, strategy);
  if (chosen == BandedSolver::name) return std::make_unique<BandedSolver>(pattern, settings.ordering);
  if (chosen == MumpsSolver::name) return std::make_unique<MumpsSolver>(pattern);
  if (chosen == CondensedSolver::name) return std::make_unique<CondensedSolver>(pattern);
  const std::string klu = std::string(KluSolver::library) + " ";
  if (!chosen.starts_with(klu)) return nullptr;
  return std::make_unique<KluSolver>(
      pattern, KluSolver::Settings{settings.pivot_tolerance, settings.ordering, 0, chosen.substr(klu.size())});
}

/// The solver of that choice, null for `automatic`.
std::unique_ptr<CheckedSolver> make_asked(const SparsePattern& pattern, const Settings& settings) {
  switch (settings.choice) {
    case Choice::klu:
      return std::make_unique<KluSolver>(pattern, KluSolver::Settings{settings.pivot_tolerance, settings.ordering, 0});
    case Choice::umfpack: return std::make_unique<UmfpackSolver>(pattern);
    case Choice::dissected: return std::make_unique<UmfpackSolver>(pattern, UmfpackSolver::Strategy::dissected);
    case Choice::mumps: return std::make_unique<MumpsSolver>(pattern);
    case Choice::banded: return std::make_unique<BandedSolver>(pattern, settings.ordering);
    case Choice::condensed: return std::make_unique<CondensedSolver>(pattern);
    case Choice::automatic: break;
  }
  return nullptr;
}

}  // namespace

std::unique_ptr<DirectSolver> make_solver(const SparsePattern& pattern, const Settings& settings) {
  const auto& ordering = settings.ordering;
  if (!ordering.empty() && static_cast<Index>(inverse(ordering).size()) != pattern.n()) {
    throw std::invalid_argument("make_solver: the given ordering must name each unknown once");
  }
  limit_blas_to_one_thread();
  reserve_blas_work_space();
  auto solver = make_chosen(pattern, settings);
  if (!solver) solver = make_asked(pattern, settings);
  if (solver) {
    solver->demand(settings.accuracy);
    return solver;
  }
  return std::make_unique<AutomaticSolver>(pattern, settings);
}

}  // namespace talus::linear
