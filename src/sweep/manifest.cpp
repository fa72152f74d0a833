#include "sweep/manifest.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "core/errors.hpp"
#include "output/atomic_file.hpp"
#include "output/csv.hpp"
#include "output/provenance.hpp"
#include "sweep/sweep_folder.hpp"

namespace talus::sweep {
namespace {

using Json = nlohmann::ordered_json;

constexpr int format = 1;

Json json_of(const config::Scalar& value) {
  return std::visit([](const auto& x) { return Json(x); }, value);
}

config::Scalar scalar_of(const Json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number_integer()) return json.get<std::int64_t>();
  if (json.is_number()) return json.get<double>();
  return json.get<std::string>();
}

Json json_of(const Design& design) {
  Json dimensions = Json::array();
  for (const auto& dimension : design.dimensions()) {
    Json axes = Json::array();
    for (const auto& axis : dimension.axes) {
      Json values = Json::array();
      for (const auto& value : axis.values) values.push_back(json_of(value));
      axes.push_back({{"key", axis.key}, {"unit", axis.unit}, {"doc", axis.doc}, {"values", std::move(values)}});
    }
    dimensions.push_back({{"name", dimension.name}, {"length", dimension.size()}, {"axes", std::move(axes)}});
    if (!dimension.labels.empty()) dimensions.back()["labels"] = dimension.labels;
  }
  return dimensions;
}

Design design_of(const Json& json) {
  std::vector<Dimension> dimensions;
  for (const auto& dimension : json) {
    dimensions.push_back({dimension.at("name"), {}, dimension.value("labels", std::vector<std::string>{})});
    for (const auto& axis : dimension.at("axes")) {
      dimensions.back().axes.push_back({axis.at("key"), axis.at("unit"), axis.at("doc"), {}});
      for (const auto& value : axis.at("values")) dimensions.back().axes.back().values.push_back(scalar_of(value));
    }
  }
  return Design(std::move(dimensions));
}

Json json_of(const Manifest& manifest) {
  const SweepFolder folder("", manifest.design.size());
  Json members = Json::array();
  for (std::size_t i = 0; i < manifest.members.size(); ++i) {
    Json values;
    for (const auto& [axis, value] : manifest.design.settings(i)) values[axis.key] = json_of(value);
    const auto& state = manifest.members[i];
    members.push_back({{"number", i},
                       {"folder", folder.member(i)},
                       {"scene", folder.scene(i)},
                       {"values", std::move(values)},
                       {"status", word_of(state.status)},
                       {"exit_code", state.exit_code < 0 ? Json(nullptr) : Json(state.exit_code)},
                       {"reason", state.reason.empty() ? Json(nullptr) : Json(state.reason)}});
  }
  return {{"format", format},
          {"sweep", manifest.name},
          {"title", manifest.title},
          {"source", manifest.source},
          {"talus_version", output::version()},
          {"git_revision", output::git_revision()},
          {"dimensions", json_of(manifest.design)},
          {"members", std::move(members)}};
}

std::string csv_of(const Manifest& manifest) {
  const SweepFolder folder("", manifest.design.size());
  std::vector<std::string> line{"member", "folder"};
  for (const auto& [axis, value] : manifest.design.settings(0)) line.push_back(heading(axis));
  line.insert(line.end(), {"status", "exit_code"});
  std::string out = output::csv_line(line);
  for (std::size_t i = 0; i < manifest.members.size(); ++i) {
    line = {std::to_string(i), folder.member(i)};
    for (const auto& [axis, value] : manifest.design.settings(i)) line.push_back(plain(value));
    const auto& state = manifest.members[i];
    line.emplace_back(word_of(state.status));
    line.push_back(state.exit_code < 0 ? "" : std::to_string(state.exit_code));
    out += output::csv_line(line);
  }
  return out;
}

MemberState state_of(const Json& member) {
  MemberState state;
  const std::string word = member.at("status");
  for (const Status status : {Status::unfinished, Status::stopped, Status::failed, Status::finished}) {
    if (word == word_of(status)) state.status = status;
  }
  if (member.at("exit_code").is_number()) state.exit_code = member.at("exit_code");
  if (member.at("reason").is_string()) state.reason = member.at("reason");
  return state;
}

}  // namespace

void write_manifest(const std::filesystem::path& folder, const Manifest& manifest) {
  output::write_atomically(folder / "manifest.json",
                           json_of(manifest).dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
  output::write_atomically(folder / "manifest.csv", csv_of(manifest));
}

Manifest read_manifest(const std::filesystem::path& folder) {
  const auto file = folder / "manifest.json";
  std::ifstream in(file);
  if (!in) throw core::ConfigError(folder.string() + ": holds no sweep (no manifest.json)");
  try {
    const Json json = Json::parse(in);
    if (json.at("format") != format) throw core::ConfigError(file.string() + ": written by another version of Talus");
    Manifest manifest{json.at("sweep"), json.at("title"), json.at("source"), design_of(json.at("dimensions")), {}};
    for (const auto& member : json.at("members")) manifest.members.push_back(state_of(member));
    if (manifest.members.size() != manifest.design.size())
      throw core::ConfigError(file.string() + ": " + std::to_string(manifest.members.size()) +
                              " members, but the axes make " + std::to_string(manifest.design.size()));
    return manifest;
  } catch (const Json::exception& error) {
    throw core::ConfigError(file.string() + ": not a manifest of a sweep: " + error.what());
  }
}

}  // namespace talus::sweep
