#include "fv/operator.hpp"

#include <gtest/gtest.h>

#include <cfenv>
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

/// Columns of places, each reading the one below; the first of a column reads nothing below and has an output of its own.
struct Columns {
  static constexpr int n_in = 2, n_out = 2;
  static constexpr bool uses_rate = true;
  Index n_columns, height;

  [[nodiscard]] Index n_places() const { return n_columns * height; }
  [[nodiscard]] bool is_first(Index place) const { return place % height == 0; }
  void connect(Index place, std::array<Index, n_in>& in, std::array<Index, n_out>& out) const {
    in = {is_first(place) ? -1 : place - 1, place};
    out = in;
  }
  [[nodiscard]] Index alike(Index place) const { return is_first(place) ? 1 : height - place % height; }
  template <class S>
  void evaluate(const Nothing&, Index place, const Inputs<S, n_in>& in, std::array<S, n_out>& out) const {
    using std::sqrt;
    using core::sqrt;
    const S root = core::select_above(
        in.y[1], 0.1, [&] { return S(sqrt(in.y[1])); }, [&] { return S(in.y[1] * in.y[1] / 3.0); });
    const S flux = root - tanh(in.y[0]) + 0.3 * in.rate[1];
    out[0] = is_first(place) ? S(0.0) : flux;
    out[1] = is_first(place) ? S(2.0 * root) : S(-flux);
  }
};

TEST(Operator, GivesTheSameBitsInPacksAndPlaceByPlace) {
  for (Index height = 1; height <= 13; ++height) {
    const Index size = 9 * height;
    Operator<Nothing>::Terms terms;
    terms.push_back(make_term<Nothing>(Columns{9, height}));
    const Operator<Nothing> sum(size, std::move(terms), Nothing{});
    std::vector<double> y(size), yp(size), in_packs(size), one_by_one(size);
    for (Index i = 0; i < size; ++i) {
      y[i] = std::sin(1.3 * static_cast<double>(i));
      yp[i] = std::cos(0.7 * static_cast<double>(i));
    }
    sum.residual({}, y, yp, in_packs);
    feenableexcept(FE_DIVBYZERO);  // what asks for places one by one
    sum.residual({}, y, yp, one_by_one);
    fedisableexcept(FE_DIVBYZERO);
    EXPECT_EQ(in_packs, one_by_one) << height;
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
