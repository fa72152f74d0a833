#include "linear/automatic_solver.hpp"
#include "linear/banded_solver.hpp"
#include "linear/blas.hpp"
#include "linear/condensed_solver.hpp"
#include "linear/direct_solver.hpp"
#include "linear/klu_solver.hpp"
#include "linear/ordering.hpp"
#include "linear/umfpack_solver.hpp"

namespace talus::linear {

std::unique_ptr<DirectSolver> make_solver(const SparsePattern& pattern, const Settings& settings) {
  const auto& ordering = settings.ordering;
  if (!ordering.empty() && static_cast<Index>(inverse(ordering).size()) != pattern.n()) {
    throw std::invalid_argument("make_solver: the given ordering must name each unknown once");
  }
  limit_blas_to_one_thread();
  switch (settings.choice) {
    case Choice::klu:
      return std::make_unique<KluSolver>(pattern, KluSolver::Settings{settings.pivot_tolerance, ordering, 0});
    case Choice::umfpack: return std::make_unique<UmfpackSolver>(pattern);
    case Choice::banded: return std::make_unique<BandedSolver>(pattern, ordering);
    case Choice::condensed: return std::make_unique<CondensedSolver>(pattern);
    case Choice::automatic: break;
  }
  return std::make_unique<AutomaticSolver>(pattern, settings);
}

}  // namespace talus::linear
