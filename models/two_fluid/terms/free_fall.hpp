#pragma once

#include "two_fluid/jet_region.hpp"
#include "two_fluid/terms/kernel.hpp"

namespace talus::two_fluid {

/// Acts on the cells of each line of fall.
struct FallKernel : Kernel {
  [[nodiscard]] const FallStep& step(Index number) const {
    return mesh->fall().steps[static_cast<std::size_t>(number)];
  }
  [[nodiscard]] Index n_places() const { return static_cast<Index>(mesh->fall().steps.size()); }
  [[nodiscard]] Index alike(Index) const { return 1; }
};

/// What is poured, where the jet is known: grains in free fall from the inlet, an equal share on each line, enter the cells within a
/// clearance above the heap, evenly but for smooth ends, and bring the speed that they have fallen to. On their way they are nowhere.
struct FreeFall : FallKernel {
  static constexpr int n_in = 5, n_out = 7;
  enum In { heap_, u_, w_ = 3 };

  void connect(Index number, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const auto& [line, i, k, from, to, drop, lowest, highest] = step(number);
    in = {at->heap(line), at->u(i, k), at->u(i + 1, k), at->w(i, k), at->w(i, k + 1)};
    out = {at->continuity(i, k),
           at->phi(i, k),
           mesh->is_wall(i) ? -1 : at->momentum_u(i, k),
           mesh->is_wall(i + 1) ? -1 : at->momentum_u(i + 1, k),
           k > 0 ? at->momentum_w(i, k) : -1,
           at->momentum_w(i, k + 1),
           at->mass_in()};
  }
  template <class S>
  void evaluate(const Context& c, Index number, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const FallStep& s = step(number);
    const double clearance = mesh->jet().clearance();
    const auto below = [&](double height) { return smooth_step(S((height - in.y[heap_]) / clearance)); };
    const S landed = (s.highest ? S(1.0) : below(s.to)) - (s.lowest ? S(0.0) : below(s.from));
    const S grains = (c.poured / mesh->fall().n_lines) * landed;  // a unit gap and time
    const double speed = c.fall_speed(s.drop);
    const S half = (0.5 * c.parameters->grains.rho()) * grains;
    out[0] -= grains;
    out[1] -= grains;
    for (int side = 0; side < 2; ++side) {
      out[2 + side] -= half * (speed * c.fall_x - in.y[u_ + side]);
      out[4 + side] -= half * (speed * c.fall_z - in.y[w_ + side]);
    }
    out[6] -= c.grains_across() * grains;
  }
};

/// The heap's height along each line of fall: the length that dense grains have of it. It follows them within the time of a free fall from
/// the inlet.
struct HeapOnLine : FallKernel {
  static constexpr int n_in = 1, n_out = 1;

  void connect(Index number, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    const FallStep& s = step(number);
    in = {at->phi(s.i, s.k)};
    out = {at->heap(s.line)};
  }
  template <class S>
  void evaluate(const Context& c, Index number, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const FallStep& s = step(number);
    out[0] -= ((s.to - s.from) / c.fall_time()) * densely_filled(in.y[0]);
  }
};

/// The other side of that balance.
struct HeapOnLineRelaxation : Kernel {
  static constexpr int n_in = 1, n_out = 1;

  [[nodiscard]] Index n_places() const { return at->n_heaps(); }
  [[nodiscard]] Index alike(Index) const { return 1; }
  void connect(Index number, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    in = {at->heap(static_cast<int>(number))};
    out = in;
  }
  template <class S>
  void evaluate(const Context& c, Index, const fv::Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    out[0] += in.y[0] / c.fall_time();
  }
};

}  // namespace talus::two_fluid
