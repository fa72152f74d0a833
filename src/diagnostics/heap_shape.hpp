#pragma once

#include <optional>
#include <span>

namespace talus::diagnostics {

/// Heights of a heap's surface normal to a tilted base, at the centres of columns.
struct Surface {
  double dx;                    ///< of equal columns, centres at (i + 1/2) dx [m]
  double tilt;                  ///< of the base against the horizontal [rad]; positive: down to the right
  std::span<const double> H;    ///< [m]
  std::span<const double> x{};  ///< centres of columns that are not equal, shape of H [m]; empty: equal ones

  [[nodiscard]] double centre(std::size_t i) const { return x.empty() ? (static_cast<double>(i) + 0.5) * dx : x[i]; }
};

struct Apex {
  int column;  ///< of the largest H; the leftmost of equals
  double
      x;  ///< [m] of the parabola through it and its neighbours, not beyond the middle between its centre and a neighbour's
  double H;  ///< [m] of the same
};
/// The apex is the point farthest from the base, not the highest: bare base may rise above the heap in a tilted box.
/// Throws std::invalid_argument for fewer than three columns, a height that is not finite, or centres of another shape.
[[nodiscard]] Apex apex(const Surface& surface);

/// Which part of the right face counts as straight. The face runs from the apex to its toe: the first column with H
/// below `toe` of the apex height, or the end of the box. `from` and `to` are shares of that run, counted in columns: apex rounding and
/// outlet are left out.
struct FaceRule {
  double toe = 0.1;
  double from = 0.2;
  double to = 0.8;
};
struct Face {
  double angle;     ///< against the horizontal [rad]: tilt - atan(dH/dx)
  double rms;       ///< of the heights about the line [m]
  int first, last;  ///< columns fitted
};
/// Least-squares line through the right face. None with fewer than five columns to fit: no heap, or too coarse.
[[nodiscard]] std::optional<Face> right_face(const Surface& surface, const FaceRule& rule = {});

/// Where a column counts for the sawtooth: farther from the apex than `apex_margin`, with both neighbours thicker than
/// `film`.
struct SawtoothRule {
  double apex_margin = 0.02;  ///< [m]
  double film = 2e-3;         ///< [m]
};
struct Sawtooth {
  double share;  ///< largest |H_(i-1) - 2 H_i + H_(i+1)| over the top layer's thickness there [1]; 0 where none counts
  int column;    ///< where; -1 where none counts
};
/// `top_layer` [m]: thickness of the uppermost layer of each column, shape of H. Throws std::invalid_argument where
/// shapes differ.
[[nodiscard]] Sawtooth sawtooth(const Surface& surface, std::span<const double> top_layer,
                                const SawtoothRule& rule = {});

}  // namespace talus::diagnostics
