#include "bridge/vector_operations.hpp"

#include <gtest/gtest.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>

#include <cmath>
#include <vector>

#include "bridge/vectors.hpp"
#include "core/sums.hpp"

/// Our operations beside those of SUNDIALS.
namespace {
using namespace talus;
using bridge::Vector;

class VectorOperations : public testing::TestWithParam<std::size_t> {
 protected:
  VectorOperations() { SUNContext_Create(nullptr, &context_); }
  ~VectorOperations() override { SUNContext_Free(&context_); }

  /// With the numbers of sin(k (i + 1)).
  std::unique_ptr<Vector> filled(double k) {
    auto v = std::make_unique<Vector>(static_cast<sunindextype>(GetParam()), context_);
    for (std::size_t i = 0; i < GetParam(); ++i) v->span()[i] = std::sin(k * static_cast<double>(i + 1));
    return v;
  }
  SUNContext context_ = nullptr;
};
INSTANTIATE_TEST_SUITE_P(Lengths, VectorOperations, testing::Values(1, 37, core::long_vector + 37));

TEST_P(VectorOperations, CombinationsOfAnyNumberOfVectors) {
  for (int n_terms = 1; n_terms <= 13; ++n_terms) {
    std::vector<std::unique_ptr<Vector>> x;
    std::vector<N_Vector> handles;
    std::vector<double> c;
    for (int t = 0; t < n_terms; ++t) {
      x.push_back(filled(t + 1.0));
      handles.push_back(x.back()->handle());
      c.push_back(1.0 / (t + 2.0));
    }
    std::vector<double> expected(GetParam());
    for (std::size_t i = 0; i < GetParam(); ++i)
      for (int t = 0; t < n_terms; ++t) expected[i] += c[t] * x[t]->span()[i];
    const auto z = filled(0.5);
    ASSERT_EQ(N_VLinearCombination(n_terms, c.data(), handles.data(), z->handle()), 0);
    for (std::size_t i = 0; i < GetParam(); ++i) ASSERT_NEAR(z->span()[i], expected[i], 1e-15) << n_terms;
    ASSERT_EQ(N_VLinearCombination(n_terms, c.data(), handles.data(), handles[0]), 0);  // in place of the first
    for (std::size_t i = 0; i < GetParam(); ++i) ASSERT_EQ(x[0]->span()[i], z->span()[i]) << n_terms;
  }
}

TEST_P(VectorOperations, SumsAndMultiplesAreThoseOfSundials) {
  const auto x = filled(1.0), y = filled(2.0), ours = filled(3.0), theirs = filled(3.0);
  const auto expect_equal = [&] {
    for (std::size_t i = 0; i < GetParam(); ++i) ASSERT_EQ(ours->span()[i], theirs->span()[i]) << i;
  };
  N_VLinearSum(0.3, x->handle(), -1.7, y->handle(), ours->handle());
  N_VLinearSum_Serial(0.3, x->handle(), -1.7, y->handle(), theirs->handle());
  expect_equal();
  N_VScale(-2.5, x->handle(), ours->handle());
  N_VScale_Serial(-2.5, x->handle(), theirs->handle());
  expect_equal();
  N_Vector X[]{x->handle(), y->handle()}, Z[]{y->handle(), ours->handle()};
  double c[]{2.0, 3.0};
  N_VScaleVectorArray(2, c, X, Z);  // y = 2 x, then ours = 3 y
  N_VScale_Serial(6.0, x->handle(), theirs->handle());
  expect_equal();
  N_Vector Y[]{x->handle()}, only[]{ours->handle()};
  N_VLinearSumVectorArray(1, 0.5, Y, 0.25, Z, only);
  N_VLinearSum_Serial(0.5, x->handle(), 0.25, y->handle(), theirs->handle());
  expect_equal();
}

TEST_P(VectorOperations, NormsAreThoseOfSundials) {
  const auto x = filled(1.0), w = filled(0.01), where = filled(0.3);
  const auto near = [](double ours, double theirs) { EXPECT_NEAR(ours, theirs, 1e-13 * theirs); };
  near(N_VWrmsNorm(x->handle(), w->handle()), N_VWrmsNorm_Serial(x->handle(), w->handle()));
  near(N_VWrmsNormMask(x->handle(), w->handle(), where->handle()),
       N_VWrmsNormMask_Serial(x->handle(), w->handle(), where->handle()));
}

TEST_P(VectorOperations, ClonesHaveThemToo) {
  const auto x = filled(1.0);
  N_Vector clone = N_VClone(x->handle());
  EXPECT_EQ(clone->ops->nvlinearcombination, x->handle()->ops->nvlinearcombination);
  EXPECT_NE(clone->ops->nvlinearcombination, nullptr);
  EXPECT_NE(clone->ops->nvwrmsnorm, &N_VWrmsNorm_Serial);
  N_VDestroy(clone);
}
}  // namespace
