#pragma once

#include <functional>
#include <span>

#include "core/dae_system.hpp"
#include "linear/direct_solver.hpp"
#include "modes/mode.hpp"

namespace talus::modes {

/// What was searched about one shift.
struct Searched {
  double shift;
  double radius;  ///< every rate nearer to the shift than this was found [1/s]; 0 where the search did not converge
  int n_found;
};

struct LeadingOptions {
  std::vector<double> shifts;  ///< real, [1/s]: the rates nearest to each are sought
  int n_modes = 10;            ///< about each shift
  int n_vectors = 60;          ///< of a Krylov space, above n_modes + 2
  double tolerance = 1e-9;     ///< relative, of 1/(shift - rate)
  int max_restarts = 300;
  linear::Settings linear;
  std::function<void(const Searched&)> progress = [](const Searched&) {};  ///< told of each shift that is done
};

struct LeadingModes {
  std::vector<Mode> modes;  ///< the fastest growing first, each once
  std::vector<Searched> searched;
};

/// Rates of a system linearised about a steady state (y, y' = 0) at time t [s], by implicitly restarted Arnoldi iteration (Spectra) on
/// (dF/dy + s dF/dy')^-1 dF/dy': the matrix that an integrator factors with c_j = s, whose eigenvalues are 1/(s - rate).
/// Algebraic unknowns have infinite rates, which are never among the nearest. Throws std::invalid_argument for options without sense,
/// linear::SingularMatrix where a shift is a rate.
[[nodiscard]] LeadingModes leading_modes(const core::DaeSystem& system, double t, std::span<const double> y,
                                         const LeadingOptions& options);

}  // namespace talus::modes
