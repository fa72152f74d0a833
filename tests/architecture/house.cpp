#include <gtest/gtest.h>

#include <set>

#include "architecture/rules.hpp"

namespace {
using namespace talus::architecture;

class House : public testing::TestWithParam<Rule> {};

/// The tree as it stands keeps every rule of the house.
TEST_P(House, KeepsRule) {
  std::string breaches;
  for (const std::string& breach : GetParam().breaches(Tree(TALUS_SOURCE_DIR))) breaches += "  " + breach + "\n";
  EXPECT_TRUE(breaches.empty()) << breaches;
}

INSTANTIATE_TEST_SUITE_P(Architecture, House, testing::ValuesIn(rules()),
                         [](const auto& rule) { return std::string(rule.param.name); });

/// Each rule can fail: a fault planted in the tree as read, not on the disk, is found, and named by its file.
struct Plant {
  std::string rule;
  std::string name;
  std::string file;  ///< `text` is appended to it
  std::string text;
  std::string breach;  ///< what the new breach must say
};

void PrintTo(const Plant& plant, std::ostream* out) { *out << plant.name << " in " << plant.file; }

const std::vector<Plant>& plants() {
  static const std::vector<Plant> list{
      {"TopLevelIsFixed", "Folder", "scripts/plot.py", "", "scripts: "},
      {"TopLevelIsFixed", "File", "NOTES.md", "", "NOTES.md: "},
      {"ArrowsPointDown", "UnknownRoom", "CMakeLists.txt", "\ntalus_room(planted src/planted ROOMS nowhere)\n",
       "nowhere"},
      {"ArrowsPointDown", "Cycle", "CMakeLists.txt", "\ntalus_room(a src/a ROOMS b)\ntalus_room(b src/b ROOMS a)\n",
       "a sees b"},
      {"ArrowsPointDown", "SeesTheApp", "CMakeLists.txt", "\ntalus_room(planted models/planted ROOMS app)\n",
       "sees app"},
      {"ArrowsPointDown", "ModelSeesIntegrator", "CMakeLists.txt",
       "\ntalus_room(planted models/planted ROOMS core linear)\n", "sees linear"},
      {"ArrowsPointDown", "IntegratorSeesGrid", "CMakeLists.txt",
       "\ntalus_room(planted integrators/planted ROOMS core grid)\n", "sees grid"},
      {"ArrowsPointDown", "ModelSeesOutput", "CMakeLists.txt", "\ntalus_room(planted models/planted ROOMS output)\n",
       "sees output"},
      {"LibrariesStayInTheirFolder", "Klu", "CMakeLists.txt", "\ntalus_room(planted src/planted LIBRARIES klu)\n",
       "klu"},
      {"LibrariesStayInTheirFolder", "Sundials", "CMakeLists.txt",
       "\ntalus_room(planted src/planted LIBRARIES SUNDIALS::ida)\n", "SUNDIALS::ida"},
      {"LibrariesStayInTheirFolder", "Toml", "CMakeLists.txt",
       "\ntalus_room(planted models/p LIBRARIES tomlplusplus::tomlplusplus)\n", "toml"},
      {"IncludesFollowTheRooms", "Upwards", "src/grid/planted.hpp", "#include \"layer/parameters.hpp\"\n",
       "src/grid/planted.hpp:1: "},
      {"IncludesFollowTheRooms", "NotNamedThoughVisible", "models/steady/planted.cpp",
       "\n # include \"fv/term.hpp\" // why\n", "planted.cpp:2: "},
      {"IncludesFollowTheRooms", "Relative", "src/grid/planted.hpp", "#include \"../layer/parameters.hpp\"\n",
       "src/grid/planted.hpp:1: "},
      {"OutsideHeadersStayOutside", "SundialsInModel", "models/layer/planted.hpp", "#include <ida/ida.h>\n",
       "SUNDIALS"},
      {"OutsideHeadersStayOutside", "KluInCore", "src/core/planted.hpp", "#include <suitesparse/klu.h>\n",
       "SuiteSparse"},
      {"OutsideHeadersStayOutside", "NetcdfInDiagnostics", "src/diagnostics/planted.hpp", "#include <netcdf.h>\n",
       "netCDF"},
      {"OutsideHeadersStayOutside", "TomlInApp", "src/app/planted.hpp", "#include <toml++/toml.h>\n", "TOML"},
      {"OutsideHeadersStayOutside", "NotLinked", "integrators/linear/planted.hpp", "#include <ida/ida.h>\n",
       "does not link"},
      {"OutsideHeadersStayOutside", "Unknown", "src/core/planted.hpp", "#include <boost/any.hpp>\n", "boost/any.hpp"},
      {"SourcesLieInRooms", "NoRoom", "src/planted/planted.hpp", "", "src/planted/planted.hpp"},
      {"SourcesLieInRooms", "CppInRuns", "runs/planted.cpp", "", "runs/planted.cpp"},
      {"SourcesLieInRooms", "CppInSubfolder", "models/layer/deep/planted.cpp", "", "models/layer/deep/planted.cpp"},
      {"NamespacesAreFolders", "OtherRoom", "src/grid/planted.hpp", "namespace talus::fv {}\n", "talus::grid"},
      {"RoomsExplainThemselves", "NoReadme", "models/planted/planted.hpp", "", "models/planted: "},
      {"RoomsExplainThemselves", "NoDecisions", "models/planted/README.md", "# planted\n",
       "models/planted/README.md: "},
      {"EveryTestRuns", "NotListed", "tests/unit/planted.cpp", "", "tests/unit/planted.cpp"},
      {"EveryTestRuns", "Script", "tests/unit/planted.py", "", "tests/unit/planted.py"},
      {"EveryTestRuns", "PartOfAName", "tests/unit/dua.cpp", "", "tests/unit/dua.cpp"},
      {"EveryTestRuns", "NewLabel", "tests/novel/planted.cpp", "", "tests/novel/planted.cpp"},
      {"EveryTestRuns", "BenchmarkNotListed", "tests/benchmark/planted.cpp", "", "tests/benchmark/planted.cpp"},
      {"EveryTestCanFail", "Skips", "tests/unit/planted.cpp",
       "\nGTEST_"
       "SKIP();\n",
       "tests/unit/planted.cpp:2: "},
      {"EveryTestCanFail", "Disabled", "tests/unit/planted.cpp",
       "TEST(A, DISABLED"
       "_b) {}\n",
       "tests/unit/planted.cpp:1: "},
      {"NoMachinePaths", "InScene", "runs/planted.toml",
       "out = \"/ho"
       "me/me/out\"\n",
       "runs/planted.toml:1: "},
      {"NoMachinePaths", "InMakefile", "Makefile",
       "\ncd /wo"
       "rk/main\n",
       "Makefile:"},
      {"NoMachinePaths", "InCi", ".ci/run",
       "\ncd /ro"
       "ot/main\n",
       ".ci/run:"},
      {"LongFilesHaveAReason", "Long", "src/core/planted.hpp", std::string(501, '\n'),
       "src/core/planted.hpp: 501 lines"},
      {"LongFilesHaveAReason", "StaleReason", "tests/architecture/long_files.txt",
       "src/core/dual.hpp: once it was long\n", "src/core/dual.hpp"},
      {"LongFilesHaveAReason", "NoSuchFile", "tests/architecture/long_files.txt",
       "src/core/gone.hpp: once it was here\n", "src/core/gone.hpp"},
      {"ReadmesAreShortAndSound", "FrontPageTooLong", "README.md", std::string(121, '\n'), "120 lines"},
      {"ReadmesAreShortAndSound", "DeadLink", "src/core/README.md", "\n[dual](planted.hpp)\n", "dead link planted.hpp"},
  };
  return list;
}

class PlantedFault : public testing::TestWithParam<Plant> {};

TEST_P(PlantedFault, IsFound) {
  const Plant& fault = GetParam();
  const auto rule = std::find_if(rules().begin(), rules().end(), [&](const Rule& r) { return r.name == fault.rule; });
  ASSERT_NE(rule, rules().end());
  Tree tree(TALUS_SOURCE_DIR);
  const Strings before = rule->breaches(tree);
  tree.append(fault.file, fault.text);
  Strings fresh;
  for (const std::string& breach : rule->breaches(tree))
    if (!contains(before, breach)) fresh.push_back(breach);

  ASSERT_EQ(fresh.size(), 1U);
  EXPECT_NE(fresh.front().find(fault.breach), std::string::npos) << fresh.front();
}

INSTANTIATE_TEST_SUITE_P(Architecture, PlantedFault, testing::ValuesIn(plants()),
                         [](const auto& plant) { return plant.param.rule + plant.param.name; });

TEST(Architecture, EachRuleHasAPlantedFault) {
  std::set<std::string> planted;
  for (const Plant& plant : plants()) planted.insert(plant.rule);
  for (const Rule& rule : rules()) EXPECT_TRUE(planted.contains(rule.name)) << rule.name;
  EXPECT_EQ(planted.size(), rules().size());
}
}  // namespace
