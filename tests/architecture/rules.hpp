#pragma once

#include "architecture/arrows.hpp"
#include "architecture/order.hpp"
#include "architecture/text.hpp"

namespace talus::architecture {

/// A rule of the house: from a tree to its breaches, each naming file and cause.
struct Rule {
  const char* name;
  Strings (*breaches)(const Tree&);
};

/// How GoogleTest names a rule.
inline void PrintTo(const Rule& rule, std::ostream* out) { *out << rule.name; }

inline const std::vector<Rule>& rules() {
  static const std::vector<Rule> list{
      {"TopLevelIsFixed", top_level_is_fixed},
      {"ArrowsPointDown", arrows_point_down},
      {"LibrariesStayInTheirFolder", libraries_stay_in_their_folder},
      {"IncludesFollowTheRooms", includes_follow_the_rooms},
      {"OutsideHeadersStayOutside", outside_headers_stay_outside},
      {"SourcesLieInRooms", sources_lie_in_rooms},
      {"NamespacesAreFolders", namespaces_are_folders},
      {"RoomsExplainThemselves", rooms_explain_themselves},
      {"EveryTestRuns", every_test_runs},
      {"EveryTestCanFail", every_test_can_fail},
      {"NoMachinePaths", no_machine_paths},
      {"LongFilesHaveAReason", long_files_have_a_reason},
      {"ReadmesAreShortAndSound", readmes_are_short_and_sound},
  };
  return list;
}

}  // namespace talus::architecture
