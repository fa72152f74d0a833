#pragma once

#include "architecture/tree.hpp"

/// Rules about who may see whom. Which rooms a room sees is stated once, in the talus_room lines of CMakeLists.txt.
namespace talus::architecture {

/// An outside library: its headers, the CMake names it is linked by (none: needs no linking), and the only folder that may use it.
struct Family {
  const char* name;
  const char* headers;
  const char* libraries;
  const char* folder;
};

inline const std::vector<Family>& families() {
  static const std::vector<Family> list{
      {"SUNDIALS", R"((ida|idas|cvodes?|kinsol|arkode|nvector|sunmatrix|sunlinsol|sunnonlinsol|sundials)/.*)",
       "SUNDIALS::.*", "integrators/"},
      {"SuiteSparse", R"((suitesparse/.*)|(klu|umfpack|c?colamd|c?amd|btf|cholmod|SuiteSparse_config|metis)\.h)",
       "klu|umfpack|c?colamd|c?amd|btf|cholmod|suitesparseconfig|metis", "integrators/"},
      {"MUMPS", R"([sdcz]mumps_c\.h|mumps.*)", "[sdcz]mumps.*", "integrators/"},
      {"netCDF", R"(netcdf.*)", "PkgConfig::NETCDF", "src/output/"},
      {"Nettle", R"(nettle/.*)", "PkgConfig::NETTLE", "src/output/"},
      {"Ceres", R"((ceres|glog)/.*)", R"(.*Ceres::.*)", "src/fit/"},
      {"TOML", R"(toml.*)", "tomlplusplus::.*", "src/config/"},
      {"CLI11", R"(CLI/.*)", "CLI11::.*", "src/app/"},
      {"spdlog", R"((spdlog|fmt)/.*)", "spdlog::.*", "src/app/"},
      {"JSON", R"(nlohmann/.*)", "nlohmann_json::.*", "src/"},
      {"Spectra", R"(Spectra/.*)", "Spectra::.*", "integrators/"},
      {"Eigen", R"((unsupported/)?Eigen/.*)", "Eigen3::Eigen", ""},
      {"POSIX", R"((sys/.*|unistd|fcntl|signal|poll|spawn)\.h)", "", "src/"},
      {"dynamic linking", R"(dlfcn\.h)", "", "integrators/linear/"},
  };
  return list;
}

inline const Family* family_of_header(const std::string& header) {
  for (const Family& family : families())
    if (std::regex_match(header, std::regex(family.headers))) return &family;
  return nullptr;
}

struct Include {
  Line line;
  bool ours;  ///< in quotes
  std::string header;
};

inline std::vector<Include> includes_of(const Tree& tree, const std::string& file) {
  static const std::regex directive(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)re");
  std::vector<Include> includes;
  std::smatch match;
  for (const Line& line : tree.lines(file))
    if (std::regex_match(line.text, match, directive)) includes.push_back({line, match[1] == "\"", match[2]});
  return includes;
}

/// A room names only rooms above its own line in CMakeLists.txt, so there is no cycle; nothing sees the app; models see neither
/// output nor integrators; integrators see core and each other; core sees nothing.
inline Strings arrows_point_down(const Tree& tree) {
  Strings faults, seen;
  for (const Room& room : tree.rooms()) {
    for (const std::string& name : room.rooms) {
      const Room* other = tree.room_named(name);
      const std::string arrow = "CMakeLists.txt: room " + room.name + " sees " + name + ": ";
      if (!contains(seen, name)) faults.push_back(arrow + "not a room of an earlier line");
      else if (name == "app") faults.push_back(arrow + "nothing may see the app");
      else if (room.folder.starts_with("integrators/") && name != "core" && !other->folder.starts_with("integrators/"))
        faults.push_back(arrow + "an integrator knows core only");
      else if (room.name != "app" && !room.folder.starts_with("integrators/") &&
               other->folder.starts_with("integrators/"))
        faults.push_back(arrow + "only the app may choose an integrator");
      else if (room.folder.starts_with("models/") && name == "output")
        faults.push_back(arrow + "a model does not know who watches it");
    }
    seen.push_back(room.name);
  }
  return faults;
}

/// Each outside library is linked by rooms of its own folder only.
inline Strings libraries_stay_in_their_folder(const Tree& tree) {
  Strings faults;
  for (const Room& room : tree.rooms())
    for (const std::string& library : room.libraries)
      for (const Family& family : families())
        if (std::regex_match(library, std::regex(family.libraries)) && !(room.folder + "/").starts_with(family.folder))
          faults.push_back("CMakeLists.txt: room " + room.name + " links " + library + ", which belongs to " +
                           family.folder);
  return faults;
}

/// In quotes: "room/file.hpp" of the room itself or of a room that it names. A room that another one happens to pull in does not count,
/// which is what CMake cannot see.
inline Strings includes_follow_the_rooms(const Tree& tree) {
  Strings faults;
  for (const std::string& file : tree.files()) {
    const Room* room = tree.room_of(file);
    if (!room || !is_cpp(file)) continue;
    for (const Include& include : includes_of(tree, file)) {
      const std::string target = include.header.substr(0, include.header.find('/'));
      if (include.ours && target != room->name && !contains(room->rooms, target))
        faults.push_back(at(file, include.line) + "room " + room->name + " may not include \"" + include.header + "\"");
    }
  }
  return faults;
}

/// In angle brackets: the standard library, or a family that may be used in this folder and is linked by the room or one it sees.
inline Strings outside_headers_stay_outside(const Tree& tree) {
  Strings faults;
  for (const std::string& file : tree.files()) {
    const Room* room = tree.room_of(file);
    if (!room || !is_cpp(file)) continue;
    Strings linked = room->libraries;
    for (const std::string& name : room->rooms)
      if (const Room* other = tree.room_named(name))
        linked.insert(linked.end(), other->libraries.begin(), other->libraries.end());
    for (const Include& include : includes_of(tree, file)) {
      if (include.ours || include.header.find_first_of("/.") == std::string::npos) continue;
      const Family* family = family_of_header(include.header);
      const std::string what = at(file, include.line) + "<" + include.header + "> ";
      if (!family) {
        faults.push_back(what + "belongs to no library that tests/architecture/arrows.hpp knows");
        continue;
      }
      const std::regex names(family->libraries);
      const bool is_linked =
          std::any_of(linked.begin(), linked.end(), [&](const std::string& l) { return std::regex_match(l, names); });
      if (!file.starts_with(family->folder))
        faults.push_back(what + "is " + family->name + ", which stays in " + family->folder);
      else if (*family->libraries && !is_linked)
        faults.push_back(what + "is " + family->name + ", which room " + room->name + " does not link");
    }
  }
  return faults;
}

}  // namespace talus::architecture
