#pragma once

#include <map>

#include "architecture/order.hpp"
#include "architecture/tree.hpp"

/// Rules about what stands in the files.
namespace talus::architecture {

/// Lines of text files in which `forbidden` is found, with `reason`.
inline Strings lines_with(const Tree& tree, const std::regex& forbidden, const std::string& folder,
                          const std::string& reason) {
  static const std::regex text_file(
      R"(.*\.(hpp|cpp|py|toml|cmake|txt|md|json|csv|sh|yml)|.*Makefile|\.[^/]*(/[^/.]*)?)");
  Strings faults;
  for (const std::string& file : tree.files())
    if (file.starts_with(folder) && std::regex_match(file, text_file))
      for (const Line& line : tree.lines(file))
        if (std::regex_search(line.text, forbidden)) faults.push_back(at(file, line) + reason);
  return faults;
}

inline Strings no_machine_paths(const Tree& tree) {
  return lines_with(tree, std::regex("(^|[^A-Za-z0-9_.])/(work|farm|root|home)/"), "", "a path of one machine");
}

inline Strings every_test_can_fail(const Tree& tree) {
  return lines_with(tree,
                    std::regex("GTEST_"
                               "SKIP|DISABLED"
                               "_|SUCCEED"
                               "\\(|(EXPECT|ASSERT)_TRUE\\(true\\)"),
                    "tests/", "a test that cannot fail");
}

/// A file over 500 lines stands in tests/architecture/long_files.txt with its reason ("path: reason"), and only such files stand there.
inline Strings long_files_have_a_reason(const Tree& tree) {
  static const std::string list = "tests/architecture/long_files.txt";
  std::map<std::string, std::string> reasons;
  for (const Line& line : tree.lines(list))
    if (!line.text.starts_with('#'))
      reasons[line.text.substr(0, line.text.find(':'))] =
          line.text.substr(std::min(line.text.size(), line.text.find(": ")));
  Strings faults;
  for (const std::string& file : tree.files()) {
    static const std::regex code(R"(.*\.(hpp|cpp|py|toml|cmake)|(.*/)?(CMakeLists\.txt|Makefile))");
    const auto n_lines = std::regex_match(file, code) ? tree.lines(file).size() : 0;
    const auto reason = reasons.find(file);
    if (n_lines > 500 && (reason == reasons.end() || reason->second.size() < 10))
      faults.push_back(file + ": " + std::to_string(n_lines) + " lines, and no reason in " + list);
    if (n_lines <= 500 && reason != reasons.end()) faults.push_back(list + ": " + file + " is not that long any more");
    if (reason != reasons.end()) reasons.erase(reason);
  }
  for (const auto& [file, reason] : reasons) faults.push_back(list + ": no file " + file);
  return faults;
}

/// The front page fits 120 lines, and each relative link of a README leads to a file or folder.
inline Strings readmes_are_short_and_sound(const Tree& tree) {
  Strings faults;
  if (tree.lines("README.md").size() > 120) faults.push_back("README.md: longer than 120 lines");
  static const std::regex link(R"(\]\(([^)#:\s]+)\))");
  for (const std::string& file : tree.files()) {
    if (!file.ends_with("README.md")) continue;
    for (const Line& line : tree.lines(file))
      for (std::sregex_iterator it(line.text.begin(), line.text.end(), link), end; it != end; ++it)
        if (!std::filesystem::exists(tree.root() / folder_of(file) / (*it)[1].str()))
          faults.push_back(at(file, line) + "dead link " + (*it)[1].str());
  }
  return faults;
}

}  // namespace talus::architecture
