#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <random>

#include "core/errors.hpp"
#include "output/run_file.hpp"
#include "support/heap_fields.hpp"
#include "support/nc_reader.hpp"
#include "support/temporary_folder.hpp"

namespace talus::output {
namespace {

using support::HeapFields;
using support::NcReader;

core::Snapshot at(double t, const core::Statistics& statistics) { return {t, {}, {}, statistics}; }

core::ExitCode code_of_creating(const std::filesystem::path& path) {
  HeapFields fields;
  try {
    const RunFile file(path, fields, {});
  } catch (const core::OutputError& error) {
    EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos) << error.what();
    return error.code();
  }
  return core::ExitCode::ok;
}

TEST(OutputFailures, UnwritablePlaces) {
  const support::TemporaryFolder folder;
  std::ofstream(folder / "file") << "not a folder";
  EXPECT_EQ(code_of_creating(folder / "nowhere/run.nc"), core::ExitCode::io_setup);
  EXPECT_EQ(code_of_creating(folder / "file/run.nc"), core::ExitCode::io_setup);
  EXPECT_EQ(code_of_creating(folder.path()), core::ExitCode::io_setup);
}

/// Data that does not compress, so that a file-size limit is reached soon.
class NoiseFields : public core::FieldSource {
 public:
  static constexpr std::size_t n = 20000;
  [[nodiscard]] std::vector<std::pair<std::string, std::size_t>> dimensions() const override { return {{"cell", n}}; }
  [[nodiscard]] std::vector<core::Variable> variables() const override { return {{"noise", {"cell"}, "1", "noise"}}; }
  void evaluate(const core::Snapshot&, std::vector<std::vector<double>>& values) override {
    values[0].resize(n);
    for (double& x : values[0]) x = uniform_(engine_);
  }

 private:
  std::mt19937 engine_{1};
  std::uniform_real_distribution<double> uniform_{0.0, 1.0};
};

/// Runs `work` in a child process whose files may have 300 kB; returns the status for waitpid's macros.
template <class Work>
int with_small_disk(Work&& work) {
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{300000, 300000};
    setrlimit(RLIMIT_FSIZE, &limit);
    std::exit(work());
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

/// Appends until it fails, then tries once more; returns the exit code of the error, or 99 if the second try is let
/// through.
int append_until_full(const std::filesystem::path& path, std::uint64_t reserve) {
  NoiseFields noise;
  const core::Statistics statistics;
  RunFile file(path, noise, {}, {.reserve = reserve});
  for (int second_try = 0; second_try < 2; ++second_try) {
    try {
      for (int k = 0; k < 20; ++k) file.append(at(k, statistics));
      return 98;
    } catch (const core::OutputError& error) {
      if (second_try == 1) return static_cast<int>(error.code());
    }
  }
  return 99;
}

TEST(OutputFailures, FailedWriteIsAnErrorAndNoCrashAtExit) {
  const support::TemporaryFolder folder;
  const int status = with_small_disk([&] { return append_until_full(folder / "run.nc", 0); });
  ASSERT_TRUE(WIFEXITED(status)) << "killed by signal " << WTERMSIG(status);
  EXPECT_EQ(WEXITSTATUS(status), static_cast<int>(core::ExitCode::output_failed));
}

TEST(OutputFailures, FullDiskIsSeenInTimeToKeepTheFile) {
  const support::TemporaryFolder folder;
  const int status = with_small_disk([&] { return append_until_full(folder / "run.nc", 50000); });
  ASSERT_TRUE(WIFEXITED(status)) << "killed by signal " << WTERMSIG(status);
  EXPECT_EQ(WEXITSTATUS(status), static_cast<int>(core::ExitCode::output_failed));
  const NcReader run(folder / "run.nc");
  ASSERT_GE(run.length("time"), 2u);
  EXPECT_EQ(run.values("time")[1], 1.0);
  EXPECT_FALSE(std::isnan(run.values("noise").back()));
}

TEST(OutputFailures, OthersReadAlongAndAKilledRunStaysReadable) {
  const support::TemporaryFolder folder;
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t writer = fork();
  if (writer == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    HeapFields fields;
    const core::Statistics statistics;
    RunFile file(folder / "run.nc", fields, {});
    for (const double t : {1.0, 2.0, 3.0}) file.append(at(t, statistics));
    if (write(ready[1], "!", 1) == 1) pause();
    _exit(1);
  }
  close(ready[1]);
  char signal_of_life = 0;
  ASSERT_EQ(read(ready[0], &signal_of_life, 1), 1);
  close(ready[0]);
  const auto expect_three_records = [&] {
    const NcReader run(folder / "run.nc");
    EXPECT_EQ(run.values("time"), (std::vector<double>{1.0, 2.0, 3.0}));
    const auto height = run.values("height");
    ASSERT_EQ(height.size(), 3 * HeapFields::n_columns);
    EXPECT_EQ(height.back(), HeapFields::value(3.0, HeapFields::n_columns - 1));
  };
  EXPECT_NO_THROW(expect_three_records()) << "while the run goes on";
  kill(writer, SIGKILL);
  waitpid(writer, nullptr, 0);
  EXPECT_NO_THROW(expect_three_records()) << "after it was killed";
}

}  // namespace
}  // namespace talus::output
