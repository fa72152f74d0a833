#include "app/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace talus::app {
namespace {

constexpr double seconds_between_bars = 0.2;
constexpr double seconds_between_lines = 5.0;
constexpr int bar_width = 30;

double seconds(std::chrono::steady_clock::duration d) { return std::chrono::duration<double>(d).count(); }

}  // namespace

Progress::Progress(double start, double end, std::FILE* stream)
    : start_(start),
      end_(end),
      stream_(stream),
      terminal_(isatty(fileno(stream)) != 0),
      begin_(Clock::now()),
      last_(begin_) {}

void Progress::show(const core::Snapshot& snapshot) {
  const auto now = Clock::now();
  if (seconds(now - last_) < (terminal_ ? seconds_between_bars : seconds_between_lines)) return;
  last_ = now;
  shown_ = true;
  const double wall = seconds(now - begin_), done = snapshot.t - start_;
  const std::string left = done > 0.0 ? duration(wall * (end_ - snapshot.t) / done) : "unknown";
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), "t = %.3f of %g s, step %.2e s, order %d, %lld steps, left about %s",
                snapshot.t, end_, snapshot.statistics.last_step, snapshot.statistics.order,
                static_cast<long long>(snapshot.statistics.steps), left.c_str());
  if (terminal_) {
    std::fprintf(stream_, "\r%s %s\033[K", bar(snapshot.t / end_, bar_width).c_str(), text.data());
  } else {
    std::fprintf(stream_, "%s\n", text.data());
  }
  std::fflush(stream_);
}

void Progress::finish() {
  if (terminal_ && shown_) std::fputc('\n', stream_);
  shown_ = false;
}

std::string bar(double fraction, int width) {
  const int full = std::clamp(static_cast<int>(fraction * width), 0, width);
  return "[" + std::string(static_cast<std::size_t>(full), '#') +
         std::string(static_cast<std::size_t>(width - full), '.') + "]";
}

std::string duration(double seconds) {
  const auto whole = static_cast<long long>(std::lround(seconds));
  std::array<char, 48> text{};
  if (whole < 60) {
    std::snprintf(text.data(), text.size(), "%lld s", whole);
  } else if (whole < 3600) {
    std::snprintf(text.data(), text.size(), "%lld min %02lld s", whole / 60, whole % 60);
  } else {
    std::snprintf(text.data(), text.size(), "%lld h %02lld min", whole / 3600, whole / 60 % 60);
  }
  return text.data();
}

}  // namespace talus::app
