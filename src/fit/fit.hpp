#pragma once

#include "fit/findings.hpp"
#include "fit/joint.hpp"

namespace talus::fit {

/// Fits by bounded least squares from several starts. None, with the reason, where no parameters within the bounds let all
/// flows measured be steady: the data reject the law. Throws core::Error(solver) where no start converges, saying how each
/// failed.
[[nodiscard]] steady::Answer<Fit> fit(const Problem& problem);

/// The same, and from there on with the layer's data in one sum with the others, by runs of its scene. None also where its first run
/// at the first stage's answer fails. Throws what `runs` throws.
[[nodiscard]] steady::Answer<Fit> fit(const Problem& problem, const LayerStage& stage, LayerRuns& runs);

}  // namespace talus::fit
