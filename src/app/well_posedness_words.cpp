#include "app/well_posedness_words.hpp"

#include <spdlog/fmt/fmt.h>

#include <array>

namespace talus::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 3> noted{"class_ill_posed_area", "class_damped_area", "class_capped_area"};

std::string percent(double share) { return fmt::format("{:.3g} %", 100.0 * share); }

double number(const Json& of, const char* name) {
  return of.contains(name) && of[name].is_number() ? of[name].get<double>() : 0.0;
}

double most(const Json& kept, const char* name) { return number(kept.value(name, Json()), "most"); }

/// "5.2 % (t = 12 s)".
std::string peak(const Json& kept, const char* name) {
  return fmt::format("{} (t = {:.4g} s)", percent(most(kept, name)), number(kept[name], "time"));
}

}  // namespace

void note_well_posedness(Json& kept, const Json& now) {
  for (const char* name : noted) {
    if (!now.contains(name) || !now[name].is_number()) continue;
    const double share = now[name].get<double>();
    if (!kept.contains(name) || share > most(kept, name)) kept[name] = {{"most", share}, {"time", now["time"]}};
  }
}

std::string well_posedness_words(const Json& kept, const Json& last) {
  if (!kept.contains("class_ill_posed_area")) return "";
  std::string words;
  if (most(kept, "class_ill_posed_area") > 0.0) {
    words = fmt::format(
        "ill-posed in at most {} of the flowing area, at the end in {} with {} of the flux: short waves grow there the "
        "faster the shorter they are, finer grids need not agree, and long steps may walk over them (modes of `talus "
        "study wellposed` do not)",
        peak(kept, "class_ill_posed_area"), percent(number(last, "class_ill_posed_area")),
        percent(number(last, "class_ill_posed_flux")));
  } else {
    words = "short waves grew nowhere in what flowed";
  }
  if (most(kept, "class_damped_area") > 0.0) {
    words +=
        fmt::format("; C of (3.18) was positive in a further {} at most, at the end {}, where linear theory damps them",
                    peak(kept, "class_damped_area"), percent(number(last, "class_damped_area")));
  }
  if (most(kept, "class_capped_area") > 0.0) {
    words += fmt::format("; the viscosity's cap held {} at most, at the end {}", peak(kept, "class_capped_area"),
                         percent(number(last, "class_capped_area")));
  }
  return "well-posedness: " + words;
}

}  // namespace talus::app
