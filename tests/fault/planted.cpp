#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <new>

#include "app/session.hpp"
#include "core/errors.hpp"
#include "layer/fields.hpp"
#include "layer/layer.hpp"
#include "support/example_scene.hpp"
#include "support/same_run.hpp"
#include "support/temporary_folder.hpp"

/// Equations that go bad in the middle of a run, carried out as `talus run` would.
namespace {
using namespace talus;
using support::TemporaryFolder;

/// A layer whose residual or Jacobian is spoilt from some time on.
class Spoilt final : public core::DaeSystem {
 public:
  using Spoil = std::function<void(const core::SparsePattern&, std::span<double>)>;

  Spoilt(layer::Parameters parameters, double from, Spoil residual, Spoil jacobian)
      : layer(std::move(parameters)), from_(from), residual_(std::move(residual)), jacobian_(std::move(jacobian)) {}

  [[nodiscard]] const core::Layout& layout() const override { return layer.layout(); }
  [[nodiscard]] const core::SparsePattern& pattern() const override { return layer.pattern(); }
  void initial_state(double t, std::span<double> y, std::span<double> yp) const override {
    layer.initial_state(t, y, yp);
  }
  void residual(double t, std::span<const double> y, std::span<const double> yp, std::span<double> r) const override {
    layer.residual(t, y, yp, r);
    if (t > from_ && residual_) residual_(pattern(), r);
  }
  void jacobian(double t, std::span<const double> y, std::span<const double> yp, double c_j,
                std::span<double> values) const override {
    layer.jacobian(t, y, yp, c_j, values);
    if (t > from_ && jacobian_) jacobian_(pattern(), values);
  }
  [[nodiscard]] std::string describe(core::Index row) const override { return layer.describe(row); }
  [[nodiscard]] std::vector<double> breakpoints() const override { return layer.breakpoints(); }

  layer::Layer layer;

 private:
  double from_;
  Spoil residual_, jacobian_;
};

constexpr core::Index bad_row = 100;
constexpr double bad_from = 1.05;  // [s], a little after the third checkpoint

void plant_nan(const core::SparsePattern&, std::span<double> r) {
  r[bad_row] = std::numeric_limits<double>::quiet_NaN();
}

void plant_empty_row(const core::SparsePattern& pattern, std::span<double> values) {
  for (std::size_t k = 0; k < values.size(); ++k)
    if (pattern.rows()[k] == bad_row) values[k] = 0.0;
}

/// Two rows alike: singular, though no row or column is empty.
void plant_twin_rows(const core::SparsePattern& pattern, std::span<double> values) {
  for (core::Index j = 0; j < pattern.n(); ++j) {
    const auto one = pattern.find(bad_row, j), other = pattern.find(bad_row + 1, j);
    for (const auto k : {one, other})
      if (k >= 0) values[k] = one >= 0 && other >= 0 ? 1.0 + static_cast<double>(j) : 0.0;
  }
}

class Planted : public testing::Test {
 protected:
  /// Carries out the scene with spoilt equations, or goes on from `checkpoint`.
  int carry_out(Spoilt::Spoil residual, Spoilt::Spoil jacobian, const output::Checkpoint* checkpoint = nullptr) {
    auto system =
        std::make_unique<Spoilt>(app::make_layer_parameters(scene), bad_from, std::move(residual), std::move(jacobian));
    auto fields = std::make_unique<layer::LayerFields>(system->layer);
    const app::Simulation simulation{std::move(system), std::move(fields)};
    const app::RunFolder out(folder / "out", checkpoint == nullptr ? app::Claim::fresh : app::Claim::proceed);
    app::Interrupt interrupt;
    const app::Theory theory = app::theory_of(scene);
    return app::carry_out(
        {scene, theory, simulation, out, interrupt, "test", std::chrono::steady_clock::now(), checkpoint});
  }

  template <class Expected = core::IntegrationError>
  void expect_a_failure_that_says(const std::string& words, Spoilt::Spoil residual, Spoilt::Spoil jacobian,
                                  int code = 6) {
    EXPECT_THROW(carry_out(std::move(residual), std::move(jacobian)), Expected);
    const auto summary = nlohmann::json::parse(support::contents(folder / "out" / "summary.json"));
    EXPECT_EQ(summary["status"], "failed");
    EXPECT_EQ(summary["exit_code"], code);
    const auto reason = summary["reason"].get<std::string>();
    EXPECT_NE(reason.find(words), std::string::npos) << reason;
    EXPECT_EQ(summary["checkpoint_seconds"], 1.0);
    for (const double m : support::NcReader(folder / "out" / "run.nc").values("mass_stored"))
      EXPECT_TRUE(std::isfinite(m));
    const auto found = output::CheckpointFolder(folder / "out").newest();
    ASSERT_TRUE(found.checkpoint);
    EXPECT_EQ(found.checkpoint->t, 1.0);

    std::ofstream(folder / "out" / "scene.toml") << scene.effective;
    EXPECT_EQ(carry_out({}, {}, &*found.checkpoint), 0) << "the equations are sound again";
  }

  TemporaryFolder folder;
  app::Scene scene = tests::small(
      "heap_q46", 30, 8,
      {"time.end=1.2", "inflow.stop=10", "output.times=[]", "output.series_interval=0.1", "checkpoint.interval=0.5"});
};

TEST_F(Planted, ANanInTheResidualIsNamedAndNothingNonFiniteIsKept) {
  expect_a_failure_that_says("the residual is not finite in the row of ", plant_nan, {});
}

TEST_F(Planted, LackOfMemoryIsNamed) {
  const auto no_memory = [](const core::SparsePattern&, std::span<double>) { throw std::bad_alloc(); };
  const std::string words = "out of memory: take a coarser grid";
  expect_a_failure_that_says<std::bad_alloc>(words, no_memory, {}, 8);
  std::filesystem::remove_all(folder / "out");
  expect_a_failure_that_says<std::bad_alloc>(words, {}, no_memory, 8);
}

TEST_F(Planted, AnEmptyRowOfTheJacobianIsNamed) {
  expect_a_failure_that_says("row 100 of the matrix is zero", {}, plant_empty_row);
}

TEST_F(Planted, ASingularJacobianIsNamed) { expect_a_failure_that_says("Jacobian", {}, plant_twin_rows); }
}  // namespace
