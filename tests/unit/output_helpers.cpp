#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "core/errors.hpp"
#include "output/atomic_file.hpp"
#include "output/combined_fields.hpp"
#include "output/provenance.hpp"
#include "output/statistics_fields.hpp"
#include "support/heap_fields.hpp"
#include "support/temporary_folder.hpp"

namespace talus::output {
namespace {

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::ptrdiff_t n_files(const support::TemporaryFolder& folder) {
  return std::distance(std::filesystem::directory_iterator(folder.path()), {});
}

TEST(AtomicFile, WritesAndReplacesLeavingNothingBeside) {
  const support::TemporaryFolder folder;
  write_atomically(folder / "summary.json", "{}\n");
  const std::string large(3u << 20u, 'x');
  write_atomically(folder / "summary.json", large);
  EXPECT_EQ(content(folder / "summary.json"), large);
  EXPECT_EQ(n_files(folder), 1);
}

TEST(AtomicFile, FailureNamesThePathAndLeavesTheTargetAlone) {
  const support::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "taken/inside");
  for (const auto& path : {folder / "nowhere/summary.json", folder / "taken"}) {
    try {
      write_atomically(path, "text");
      ADD_FAILURE() << path << " was written";
    } catch (const core::OutputError& error) {
      EXPECT_EQ(error.code(), core::ExitCode::output_failed);
      EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos);
    }
  }
  EXPECT_TRUE(std::filesystem::exists(folder / "taken/inside"));
  EXPECT_EQ(n_files(folder), 1);
}

TEST(StatisticsFields, EveryNumberUnderItsName) {
  core::Statistics s;
  double next = 1.0;
  for (auto* counter : {&s.steps, &s.error_test_failures, &s.newton_failures, &s.newton_iterations, &s.residuals,
                        &s.jacobians, &s.factorisations, &s.solves, &s.inadmissible_states, &s.restarts})
    *counter = static_cast<std::int64_t>(next++);
  s.order = static_cast<int>(next++);
  for (auto* seconds : {&s.last_step, &s.seconds_residual, &s.seconds_jacobian, &s.seconds_factor, &s.seconds_solve})
    *seconds = next++;

  StatisticsFields fields;
  std::vector<std::vector<double>> values;
  fields.evaluate({0.0, {}, {}, s}, values);
  const std::vector<std::string> names{"n_steps",
                                       "n_error_test_failures",
                                       "n_newton_failures",
                                       "n_newton_iterations",
                                       "n_residuals",
                                       "n_jacobians",
                                       "n_factorisations",
                                       "n_solves",
                                       "n_inadmissible_states",
                                       "n_restarts",
                                       "order",
                                       "last_step",
                                       "cpu_residual",
                                       "cpu_jacobian",
                                       "cpu_factor",
                                       "cpu_solve"};
  const auto variables = fields.variables();
  ASSERT_EQ(variables.size(), names.size());
  ASSERT_EQ(values.size(), names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(variables[i].name, names[i]);
    EXPECT_EQ(values[i], std::vector<double>{static_cast<double>(i + 1)}) << names[i];
    EXPECT_EQ(variables[i].unit, i < 11 ? "1" : "s") << names[i];
  }
}

TEST(CombinedFields, JoinsVariablesAndUnitesDimensions) {
  support::HeapFields heap;
  StatisticsFields statistics;
  support::HeapFields heap_again;
  CombinedFields both({statistics, heap, heap_again});
  EXPECT_EQ(both.dimensions(), heap.dimensions());

  const core::Statistics s{.steps = 12};
  std::vector<std::vector<double>> values;
  for (const double t : {1.0, 2.0}) {
    both.evaluate({t, {}, {}, s}, values);
    ASSERT_EQ(values.size(), both.variables().size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::string name = both.variables()[i].name;
      if (name == "n_steps") { EXPECT_EQ(values[i], std::vector<double>{12.0}); }
      if (name == "mass_stored") { EXPECT_EQ(values[i], std::vector<double>{support::HeapFields::value(t, 0)}); }
    }
  }
  EXPECT_EQ(both.variables()[16].name, "mesh");
}

TEST(Provenance, SaysWhatMadeTheResult) {
  const Attributes a =
      provenance_attributes({"gap = 3e-3 # \"W\"\n", "talus run heap.toml", {"SUNDIALS 6.4.1", "KLU 5.12"}});
  const auto text = [&](const std::string& name) { return std::get<std::string>(a.at(name)); };
  EXPECT_EQ(text("scene"), "gap = 3e-3 # \"W\"\n");
  EXPECT_TRUE(text("libraries").starts_with("netCDF 4.")) << text("libraries");
  EXPECT_TRUE(text("libraries").ends_with(", SUNDIALS 6.4.1, KLU 5.12"));
  EXPECT_TRUE(text("history").ends_with("Z talus run heap.toml"));
  EXPECT_EQ(text("source"), "Talus " + version() + " (" + git_revision() + ")");
  EXPECT_FALSE(git_revision().empty());
  EXPECT_EQ(version().find_first_not_of("0123456789."), std::string::npos);
}

}  // namespace
}  // namespace talus::output
