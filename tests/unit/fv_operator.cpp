#include "fv/operator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace talus::fv {
namespace {

struct Nothing {};

/// A flux between unknowns `reach` apart on a ring, or on a line: added on one side, taken away on the other.
struct Flux {
  static constexpr int n_in = 2, n_out = 2;
  static constexpr bool uses_rate = true;
  Index n, reach;
  bool ring;

  [[nodiscard]] Index n_places() const { return ring ? n : n - reach; }
  void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    in = out = {place, (place + reach) % n};
  }
  template <class S>
  void evaluate(const Nothing&, Index place, const Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    const S flux =
        tanh(in.y[0] - 2.0 * in.y[1]) * (1.0 + in.y[1] * in.y[1]) + 0.1 * static_cast<double>(place) * in.rate[0];
    out[0] = flux;
    out[1] = -flux;
  }
};

constexpr Index n = 4001;

Operator<Nothing> make(bool threads, bool ring) {
  Operator<Nothing>::Terms terms;
  for (const Index reach : {1, 3, 7}) terms.push_back(make_term<Nothing>(Flux{n, reach, ring}));
  return {n, std::move(terms), Nothing{}, threads ? 0 : std::numeric_limits<Index>::max()};
}

TEST(Operator, GivesTheSameBitsWithThreadsAndWithout) {
  std::vector<double> y(n), yp(n);
  for (Index i = 0; i < n; ++i) {
    y[i] = std::sin(1.3 * static_cast<double>(i) + 1e-7 * static_cast<double>(i * i));
    yp[i] = std::cos(0.7 * static_cast<double>(i));
  }
  for (const bool ring : {false, true}) {
    const auto alone = make(false, ring), shared = make(true, ring);
    ASSERT_FALSE(alone.in_threads());
    ASSERT_TRUE(shared.in_threads());
    const auto n_nonzeros = static_cast<std::size_t>(alone.pattern().n_nonzeros());
    std::vector<double> r(n), r_shared(n), values(n_nonzeros), values_shared(n_nonzeros);
    alone.residual({}, y, yp, r);
    alone.jacobian({}, y, yp, 37.0, values);
    for (int again = 0; again < 50; ++again) {  // threads end in another order now and then
      shared.residual({}, y, yp, r_shared);
      shared.jacobian({}, y, yp, 37.0, values_shared);
      ASSERT_EQ(r, r_shared);
      ASSERT_EQ(values, values_shared);
    }
  }
}

TEST(Operator, StartsNoThreadsWherePartsShareARow) {
  Operator<Nothing>::Terms terms;
  terms.push_back(make_term<Nothing>(Flux{n, n / 2, true}));
  const Operator<Nothing> wide(n, std::move(terms), Nothing{}, 0);
  EXPECT_FALSE(wide.in_threads());
}
}  // namespace
}  // namespace talus::fv
