#include "app/collect.hpp"

#include <algorithm>
#include <cstdio>

#include "output/atomic_file.hpp"
#include "output/provenance.hpp"
#include "sweep/collection.hpp"

namespace talus::app {

int collect(const std::filesystem::path& folder, const std::vector<std::string>& series, const std::string& command) {
  auto collection = sweep::collect(folder, sweep::read_manifest(folder), series);
  auto provenance = output::provenance_attributes({"", command, {}});
  provenance.erase("scene");  // each member has its own
  collection.table.attributes.merge(provenance);
  write_table(folder / "sweep.nc", collection.table);
  output::write_atomically(folder / "sweep.csv", collection.csv);
  const auto n_finished = std::ranges::count(collection.members, sweep::Status::finished, &sweep::MemberState::status);
  std::printf("%zu members, %ld finished; results in %s and %s\n", collection.members.size(), n_finished,
              (folder / "sweep.nc").c_str(), (folder / "sweep.csv").c_str());
  return 0;
}

}  // namespace talus::app
