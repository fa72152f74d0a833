#include "app/plot.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "app/build_info.hpp"
#include "core/errors.hpp"

namespace talus::app {

namespace {

/// Runs src/plot on `folder` with these further arguments and waits for it.
int draw(const std::filesystem::path& folder, std::vector<std::string> more) {
  std::string python = "python3", program = std::string(build::sources) + "/plot", where = folder.string();
  std::vector<char*> arguments{python.data(), program.data(), where.data()};
  for (auto& argument : more) arguments.push_back(argument.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int failed = posix_spawnp(&child, python.c_str(), nullptr, nullptr, arguments.data(), environ);
  if (failed != 0)
    throw core::OutputError(core::ExitCode::io_setup,
                            "python3 cannot be started: " + std::string(std::strerror(failed)));
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR)
      throw core::OutputError(core::ExitCode::io_setup, "waiting for python3: " + std::string(std::strerror(errno)));
  }
  if (!WIFEXITED(status)) throw core::OutputError(core::ExitCode::io_setup, "python3 was ended by a signal");
  return WEXITSTATUS(status);
}

}  // namespace

int plot(const std::filesystem::path& folder, bool movie) {
  const auto holds = [&](const char* file) { return std::filesystem::exists(folder / file); };
  if (!holds("run.nc") && !holds("study.nc") && !holds("fit.nc"))
    throw core::ConfigError(folder.string() + ": holds no run, study or fit (no run.nc, study.nc or fit.nc)");
  return draw(folder, movie ? std::vector<std::string>{"--movie"} : std::vector<std::string>{});
}

int report(const std::filesystem::path& folder, const std::optional<std::filesystem::path>& out) {
  if (!std::filesystem::exists(folder / "run.nc")) {
    std::string what = folder.string() + ": holds no run (no run.nc)";
    for (const char* other : {"study.nc", "fit.nc"}) {
      if (std::filesystem::exists(folder / other))
        what += std::string("; of the ") + other + " there `talus plot` draws a page";
    }
    throw core::ConfigError(what);
  }
  std::vector<std::string> more{"--report"};
  if (out) more.insert(more.end(), {"--out", out->string()});
  return draw(folder, more);
}

void draw_study(const std::filesystem::path& folder) {
  std::string why;
  try {
    if (plot(folder, false) == 0) return;
  } catch (const core::OutputError& error) { why = std::string(": ") + error.what(); }
  std::fprintf(stderr, "warning: no picture was drawn%s; `talus plot %s` tries again\n", why.c_str(), folder.c_str());
}

}  // namespace talus::app
