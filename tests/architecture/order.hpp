#pragma once

#include <map>

#include "architecture/tree.hpp"

/// Rules about where things lie and that nothing lies about unused.
namespace talus::architecture {

inline std::string folder_of(const std::string& file) {
  return std::filesystem::path(file).parent_path().generic_string();
}
inline std::string stem_of(const std::string& file) { return std::filesystem::path(file).stem().generic_string(); }

inline Strings top_level_is_fixed(const Tree& tree) {
  static const Strings allowed{"src",  "models",         "integrators", "tests",
                               "runs", "CMakeLists.txt", "Makefile",    "README.md"};
  Strings faults;
  for (const std::string& file : tree.files()) {
    const std::string top = file.substr(0, file.find('/'));
    const std::string fault = top + ": not a name for the top level";
    if (!top.starts_with('.') && !contains(allowed, top) && !contains(faults, fault)) faults.push_back(fault);
  }
  return faults;
}

/// C++ lies in a room of CMakeLists.txt or in tests. Sources (.cpp) lie directly in the room's folder, where CMake picks them up.
inline Strings sources_lie_in_rooms(const Tree& tree) {
  Strings faults;
  for (const std::string& file : tree.files()) {
    if (!is_cpp(file) || file.starts_with("tests/")) continue;
    const Room* room = tree.room_of(file);
    if (!room) faults.push_back(file + ": no talus_room of CMakeLists.txt has this folder");
    else if (file.ends_with(".cpp") && folder_of(file) != room->folder)
      faults.push_back(file + ": in a subfolder, where no target compiles it");
  }
  return faults;
}

/// A namespace is a folder: talus::fv for src/fv. The file with main() has none to open.
inline Strings namespaces_are_folders(const Tree& tree) {
  Strings faults;
  for (const std::string& file : tree.files()) {
    const Room* room = tree.room_of(file);
    if (!room || !is_cpp(file) || stem_of(file) == "main") continue;
    if (!std::regex_search(tree.text(file), std::regex("namespace talus::" + room->name + "\\b")))
      faults.push_back(file + ": does not open namespace talus::" + room->name);
  }
  return faults;
}

/// Each folder one below src, models and integrators, and each top folder but the plain containers src and models, explains itself;
/// a room of CMakeLists.txt also says what was decided.
inline Strings rooms_explain_themselves(const Tree& tree) {
  std::map<std::string, bool> rooms;
  for (const std::string& file : tree.files()) {
    static const std::regex room(R"(((?:src|models|integrators)/[^/]+)/.*)"), top("(integrators|tests|runs)/.*");
    std::smatch match;
    if (std::regex_match(file, match, room)) rooms[match[1]] = true;
    if (std::regex_match(file, match, top)) rooms[match[1]] = false;
  }
  Strings faults;
  for (const auto& [folder, decides] : rooms) {
    const std::string readme = folder + "/README.md";
    if (!tree.has(readme)) faults.push_back(folder + ": has no README.md");
    else if (decides && tree.text(readme).find("Decisions") == std::string::npos)
      faults.push_back(readme + ": has no Decisions");
  }
  return faults;
}

/// Each source of tests/<label> stands in a line talus_test(<label> name ...) or talus_benchmark(name ...) of its tests.cmake, each
/// script by its file name, and tests/CMakeLists.txt reads that list. What tests/support holds is for others to include.
inline Strings every_test_runs(const Tree& tree) {
  Strings faults;
  for (const std::string& file : tree.files()) {
    const bool is_script = file.ends_with(".py") && !file.starts_with("tests/support/");
    if (!file.starts_with("tests/") || !(file.ends_with(".cpp") || is_script)) continue;
    const std::string label = folder_of(file).substr(6);
    const std::regex comment("#[^\n]*");
    const std::string list = std::regex_replace(tree.text("tests/" + label + "/tests.cmake"), comment, "");
    const std::string all = std::regex_replace(tree.text("tests/CMakeLists.txt"), comment, "");
    const std::string call = label == "benchmark" ? R"(talus_benchmark\(\s*)" : R"(talus_test\(\s*)" + label + R"(\s+)";
    const std::string line = is_script ? "\\b" + stem_of(file) + R"(\.py\b)" : call + stem_of(file) + R"([\s)])";
    if (!std::regex_search(list, std::regex(line)))
      faults.push_back(file + ": no line of tests/" + label + "/tests.cmake runs it");
    else if (!std::regex_search(all, std::regex("\\b" + label + "\\b")))
      faults.push_back(file + ": tests/CMakeLists.txt does not read its label");
  }
  return faults;
}

}  // namespace talus::architecture
