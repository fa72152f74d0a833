#include <benchmark/benchmark.h>

#include <array>

#include "core/scalar.hpp"
#include "rheology/law.hpp"
#include "rheology/viscosity.hpp"

/// What exact derivatives cost: the shear stress at one corner, from N unknowns (N - 1 speeds and one pressure), as double and as
/// Dual<N>. Stencil kernels of the layer model gather some 7 to 25 unknowns.
namespace {
using talus::core::Dual;

// Table 2 of the paper.
const talus::rheology::Law law =
    talus::rheology::partially_regularised(talus::rheology::classical(0.4, 0.9, 1.3), 1.3, 1.9, 0.05178);
const talus::rheology::Grains grains{2500.0, 0.6, 0.00073};
const talus::rheology::Regularisation regularisation{1.0, 1e-6, 0.0, 1e4, talus::rheology::Cap::smooth};

template <class S, std::size_t N>
S shear_stress(const std::array<S, N>& in) {
  S shear(0.0), stretch(0.0);
  for (std::size_t i = 0; i + 1 < N; ++i) {
    shear += in[i] * (i % 2 ? 100.0 : -80.0);
    stretch += in[i] * (i % 3 ? 30.0 : -50.0);
  }
  return talus::rheology::viscosity(law, grains, regularisation, S(shear * shear + stretch * stretch), 1e-6,
                                    in[N - 1]) *
         shear;
}

template <class S, int N>
void corner(benchmark::State& state) {
  std::array<S, N> in;
  for (int i = 0; i < N; ++i) {
    const double value = i + 1 < N ? 0.01 * (i + 1) : 50.0;
    if constexpr (std::is_same_v<S, double>) in[i] = value;
    else in[i] = S::input(value, i);
  }
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(in);
    benchmark::DoNotOptimize(shear_stress(in));
  }
}

BENCHMARK(corner<double, 9>)->Name("corner stress, 9 unknowns, double");
BENCHMARK(corner<Dual<9>, 9>)->Name("corner stress, 9 unknowns, Dual<9>");
BENCHMARK(corner<double, 25>)->Name("corner stress, 25 unknowns, double");
BENCHMARK(corner<Dual<25>, 25>)->Name("corner stress, 25 unknowns, Dual<25>");
}  // namespace
