#pragma once

#include <string>
#include <vector>

namespace talus::config {

/// Gathers what is wrong with a file, so that one ConfigError can name it all.
class Problems {
 public:
  /// `place` is file:line:column, the file alone, or "--set".
  void add(const std::string& place, const std::string& key, const std::string& what);
  void add(const Problems& others) { lines_.insert(lines_.end(), others.lines_.begin(), others.lines_.end()); }
  [[nodiscard]] bool none() const { return lines_.empty(); }
  /// Throws core::ConfigError with one line a problem, if there is any.
  void throw_if_any() const;

 private:
  std::vector<std::string> lines_;
};

}  // namespace talus::config
