#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "steady/sensitivity.hpp"

namespace talus::fit {

/// A parameter to be found, between bounds.
struct Unknown {
  steady::Parameter parameter;
  double start, low, high;
  struct Prior {
    double value, error;
  };
  std::optional<Prior> prior;  ///< what was known before, with its standard deviation
};

/// The slope of a steady face measured at a mass flow.
struct SlopePoint {
  double Q, Q_error;        ///< [kg/s]
  double zeta, zeta_error;  ///< [rad]
  std::string place;        ///< file and row, for messages
};

/// Speeds measured along the normal to a steady face, of which the flow or, instead, the slope is known.
struct SpeedProfile {
  std::string name;
  std::optional<double> Q;           ///< [kg/s]
  std::optional<double> zeta;        ///< [rad]
  std::vector<double> depth;         ///< [m] below what was taken for the surface
  std::vector<double> speed, error;  ///< [m/s]
  /// The surface lies up to this much [m] above or below depth = 0: a nuisance parameter; 0: exactly there.
  double offset_limit = 0.0;
};

/// Whether the surface of every flow measured must stay well-posed.
enum class Condition : std::uint8_t { report, C, q };
/// What a residual beyond `loss_scale` standard deviations counts: its square, or less.
enum class Loss : std::uint8_t { square, huber, cauchy };

struct Problem {
  steady::VariedChannel varied;  ///< whatever is not unknown, and the law
  std::vector<Unknown> unknowns{};
  std::vector<SlopePoint> slopes{};
  std::vector<SpeedProfile> profiles{};
  Condition condition = Condition::report;
  Loss loss = Loss::square;
  double loss_scale = 2.0;
  int starts = 8;                 ///< the first from Unknown::start, the others drawn between the bounds
  bool likelihoods = true;        ///< whether profile likelihoods are wanted
  std::vector<double> predict{};  ///< flows [kg/s] for which slope and surface speed are wanted
};

/// A number of the layer's scene to be found that a steady flow does not know, as the friction of the base.
struct LayerUnknown {
  std::string key, unit;
  double start, low, high;
  std::optional<Unknown::Prior> prior;
};

/// A height of a heap, or a number of a series, measured at a time.
struct LayerDatum {
  std::string place;  ///< file and row, for messages
  std::string kind;   ///< "height", or the number's name in run.nc
  std::string unit;   ///< of value and error
  double time;        ///< [s]
  double x;           ///< [m] down the base; NaN for a number of the whole heap
  double value, error;
};

/// What the layer model is asked, beside what the steady flow was.
struct LayerStage {
  std::vector<LayerUnknown> unknowns{};
  std::vector<LayerDatum> data{};
  int evaluations = 60;  ///< runs of the scene, at most
  double step = 0.02;    ///< of a difference, as a share of the value
};

}  // namespace talus::fit
