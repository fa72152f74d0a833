#pragma once

#include <span>
#include <vector>

#include "bridge/equations.hpp"
#include "ida/options.hpp"

namespace talus::ida {

using bridge::Equations;
using bridge::Outcome;

/// Makes (y, y') at time t consistent, also where the system has index 2, by two implicit Euler steps of size
/// `start_step`:
/// - at t, from y: puts the differential unknowns on their constraints, along the directions in which the constraint
///   forces act. The algebraic values of this step carry the impulse of the projection and are thrown away.
/// - at t + start_step, from there: its derivative and its algebraic values are those of the smooth motion, to first
///   order in start_step. Taking the constraints at the later time gives y' their own rate of change.
///
/// The state returned is at t. Without algebraic unknowns there is nothing to project on: y stays as it is, bit for bit.
/// A step that does not converge is tried again ten times larger, up to 1000 times;
/// `refused` where no size converges; `last_correction` is then the last weighted Newton correction, as far as one was
/// made. (IDACalcIC does not serve index 2.)
Outcome make_consistent(Equations& equations, const Options& options, double t, std::span<double> y,
                        std::span<double> yp, std::vector<double>& last_correction);

}  // namespace talus::ida
