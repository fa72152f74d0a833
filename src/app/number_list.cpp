#include "app/number_list.hpp"

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "core/errors.hpp"

namespace talus::app {
namespace {

constexpr double most = 1e6;

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const auto end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::optional<double> number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Reads one list; knows what to say where it cannot.
class List {
 public:
  List(const std::string& option, const std::string& unit) : option_(option), unit_(unit) {}

  void add(std::string_view part) {
    const auto pieces = split(part, ':');
    if (pieces.size() == 1) values_.push_back(read(part, part));
    else if (pieces.size() == 3 && pieces[2].starts_with('x')) add_factors(pieces, part);
    else if (pieces.size() == 3) add_steps(pieces, part);
    else refuse(part, "a number, a range FROM:TO:STEP or a range FROM:TO:xCOUNT");
  }
  [[nodiscard]] std::vector<double> take() && { return std::move(values_); }

 private:
  void add_steps(const std::vector<std::string_view>& pieces, std::string_view part) {
    const double from = read(pieces[0], part), to = read(pieces[1], part), step = read(pieces[2], part);
    const double steps = (to - from) / step;
    if (!(steps >= 0.0 && steps < most)) refuse(part, "a step that leads from the first number to the second");
    const auto last = static_cast<int>(std::floor(steps * (1.0 + 1e-12) + 1e-9));
    for (int i = 0; i <= last; ++i) values_.push_back(from + i * step);
  }

  void add_factors(const std::vector<std::string_view>& pieces, std::string_view part) {
    const double from = read(pieces[0], part), to = read(pieces[1], part), count = read(pieces[2].substr(1), part);
    if (!(from > 0.0 && to > 0.0)) refuse(part, "both ends above 0, since each number is a factor above the last");
    if (!(count >= 2.0 && count <= most && count == std::floor(count)))
      refuse(part, "a whole number of at least 2 behind the x");
    const auto n = static_cast<int>(count);
    for (int i = 0; i < n; ++i) {
      const double share = static_cast<double>(i) / (n - 1);
      values_.push_back(i + 1 == n ? to : from * std::pow(to / from, share));
    }
  }

  double read(std::string_view text, std::string_view part) const {
    const auto value = number(text);
    if (!value) refuse(part, "finite numbers");
    return *value;
  }

  [[noreturn]] void refuse(std::string_view part, const std::string& expected) const {
    throw core::ConfigError(option_ + ": expected " + expected + (unit_.empty() ? "" : " [" + unit_ + "]") +
                            ", found '" + std::string(part) + "'");
  }

  const std::string& option_;
  const std::string& unit_;
  std::vector<double> values_;
};

}  // namespace

std::vector<double> number_list(const std::string& text, const std::string& option, const std::string& unit) {
  List list(option, unit);
  for (const auto part : split(text, ',')) list.add(part);
  return std::move(list).take();
}

}  // namespace talus::app
