#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "ida/ida.hpp"

namespace talus::tests {

/// A run that wrote a checkpoint at `saved_at` [s] and one that is continued from it are equal bit by bit at `end` [s].
inline void expect_same_bits_when_continued(const core::DaeSystem& system, const ida::Options& options, double saved_at,
                                            double end) {
  core::Observer nobody;
  std::vector<double> y(system.layout().size()), yp(y);
  system.initial_state(0.0, y, yp);
  ida::Ida first(system, options), second(system, options);
  first.start(0.0, y, yp);
  first.advance(saved_at, nobody);
  std::ranges::copy(first.current().y, y.begin());
  std::ranges::copy(first.current().yp, yp.begin());
  const core::Statistics statistics = first.current().statistics;
  const std::string solver = first.linear_solver();
  for (auto* each : {&first, &second}) {
    each->resume({saved_at, y, yp, statistics}, solver);
    each->advance(end, nobody);
  }
  const auto a = first.current(), b = second.current();
  for (std::size_t i = 0; i < y.size(); ++i) ASSERT_EQ(a.y[i], b.y[i]) << system.describe(static_cast<core::Index>(i));
  EXPECT_EQ(a.statistics.newton_iterations, b.statistics.newton_iterations);
}

}  // namespace talus::tests
