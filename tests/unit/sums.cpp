#include "core/sums.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <vector>

/// Loops over short and over long vectors.
namespace {
using namespace talus;

constexpr std::size_t lengths[]{0, 1, 7, 16, 17, 1000, core::long_vector + 13};

struct Squares {
  const double* x;
  auto operator()(auto read, std::size_t i) const { return read(x + i) * read(x + i); }
};

TEST(Sums, HalvesCoverEachNumberOnce) {
  for (const std::size_t n : lengths) {
    std::vector<int> seen(n, 0);
    core::in_halves(n, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ++seen[i];
    });
    EXPECT_EQ(seen, std::vector<int>(n, 1)) << n;
  }
}

TEST(Sums, AddEachTermOnce) {
  for (const std::size_t n : lengths) {
    std::vector<double> v(n);
    std::iota(v.begin(), v.end(), 1.0);
    double each = 0.0;  // whole numbers below 2^53: exact in any order
    for (const double x : v) each += x * x;
    EXPECT_EQ(core::sum_in_halves(n, Squares{v.data()}), each) << n;
  }
}

TEST(Sums, GiveTheSameBitsOnOneThread) {
  const std::size_t n = 2 * core::long_vector + 5;
  std::vector<double> v(n);
  for (std::size_t i = 0; i < n; ++i) v[i] = 1.0 / (1.0 + static_cast<double>(i));
  const Squares term{v.data()};
  const double on_two = core::sum_in_halves(n, term);
  double on_one = 0.0;
  core::both(
      true, [&] { on_one = core::sum_in_halves(n, term); }, [] {});  // the companion is at work: no thread is left
  EXPECT_EQ(on_one, on_two);
}

TEST(Sums, OneNumberThatIsNotFiniteIsFoundAnywhere) {
  for (const std::size_t n : {std::size_t{20}, core::long_vector + 20})
    for (const std::size_t place : {std::size_t{0}, n / 2 - 1, n / 2, n - 1})
      for (const double bad : {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::quiet_NaN()}) {
        std::vector<double> v(n, std::numeric_limits<double>::max());
        EXPECT_TRUE(core::all_finite(v));
        v[place] = bad;
        EXPECT_FALSE(core::all_finite(v)) << n << ' ' << place;
      }
}
}  // namespace
