#include "app/hstop.hpp"

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "app/material.hpp"
#include "app/number_list.hpp"
#include "app/table.hpp"
#include "config/number_csv.hpp"
#include "core/errors.hpp"
#include "output/atomic_file.hpp"
#include "rheology/hstop.hpp"

namespace talus::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr double degree = std::numbers::pi / 180.0;

const std::vector<config::CsvColumn>& columns() {
  static const std::vector<config::CsvColumn> list{
      {"zeta_deg", "degree", "slope of the plane", 0.0, 90.0},
      {"h_stop_m", "m", "thickness of the deposit, normal to the plane", 0.0, std::numeric_limits<double>::infinity()}};
  return list;
}

/// The curve and the law that belong together, and the fit if the curve comes from one.
struct Pair {
  rheology::HstopCurve curve;
  rheology::Classical law;
  rheology::Grains grains;
  std::vector<rheology::HstopPoint> points;
  std::optional<rheology::HstopFit> fit;
};

rheology::Grains grains_of(const HstopRequest& request) {
  if (request.d == 0.0 || request.Phi == 0.0)
    throw core::ConfigError("--d, --Phi: expected with --data and --curve: grain diameter [m], solids fraction [1]");
  return rheology::grains(1.0, request.Phi, request.d);  // appendix A knows no density
}

Pair from_data(const HstopRequest& request) {
  const auto grains = grains_of(request);
  std::vector<rheology::HstopPoint> points;
  const auto read = config::read_csv(request.data, columns());
  for (std::size_t i = 0; i < read[0].size(); ++i) points.push_back({read[0][i] * degree, read[1][i]});
  const auto fit = [&] {
    try {
      return rheology::fit_hstop(points);
    } catch (const std::invalid_argument& error) {
      throw core::ConfigError(request.data.string() + ": " + error.what());
    }
  }();
  return {fit.curve, rheology::classical_of(fit.curve, request.beta, grains), grains, points, fit};
}

Pair from_curve(const HstopRequest& request) {
  const auto numbers = number_list(request.curve, "--curve", "1, 1, m");
  if (numbers.size() != 3)
    throw core::ConfigError("--curve: expected three numbers mu_s,mu_d,L [1, 1, m], found " +
                            std::to_string(numbers.size()));
  const auto grains = grains_of(request);
  const auto curve = rheology::hstop_curve(numbers[0], numbers[1], numbers[2]);
  return {curve, rheology::classical_of(curve, request.beta, grains), grains, {}, {}};
}

Pair from_law(const HstopRequest& request) {
  if (request.d != 0.0 || request.Phi != 0.0)
    throw core::ConfigError("--d, --Phi: not with --law, whose file states the grains; use --set grains.d=...");
  auto overrides = request.overrides;
  overrides.emplace_back("rheology.law=classical");
  const auto channel = read_material(request.law, overrides);
  const auto& law = std::get<rheology::Classical>(channel.law);
  return {rheology::hstop_of(law, request.beta, channel.grains), law, channel.grains, {}, {}};
}

Pair pair_of(const HstopRequest& request) {
  const int sources = int{!request.data.empty()} + int{!request.curve.empty()} + int{!request.law.empty()};
  if (sources != 1)
    throw core::ConfigError("talus hstop: expected one of --data, --curve and --law, found " + std::to_string(sources));
  if (!request.overrides.empty() && request.law.empty()) throw core::ConfigError("--set: only with --law");
  try {
    if (!request.data.empty()) return from_data(request);
    return request.curve.empty() ? from_law(request) : from_curve(request);
  } catch (const std::invalid_argument& error) { throw core::ConfigError(error.what()); }
}

/// Measured points beside the curve, or the curve at the angles asked for.
Table table_of(const Pair& pair, const std::vector<double>& zeta) {
  std::vector<double> angle, thickness, fitted, residual;
  for (const auto& point : pair.points) {
    angle.push_back(point.zeta / degree);
    thickness.push_back(point.thickness);
    fitted.push_back(std::atan(pair.curve.tan_slope(point.thickness)) / degree);
    residual.push_back(angle.back() - fitted.back());
  }
  if (!pair.points.empty() && zeta.empty())
    return {{"zeta_deg", "degree", "measured slope", angle},
            {"h_stop_m", "m", "measured thickness of the deposit", thickness},
            {"zeta_fit_deg", "degree", "slope of the curve at that thickness", fitted},
            {"residual_deg", "degree", "measured less fitted slope", residual}};
  if (zeta.empty()) return {};
  thickness.clear();
  for (const double each : zeta) thickness.push_back(pair.curve.thickness(each * degree));
  return {{"zeta_deg", "degree", "slope", zeta},
          {"h_stop_m", "m", "thickness of the deposit; none where no slope as flat lets grains flow", thickness}};
}

Json json_of(const HstopRequest& request, const Pair& pair, const Table& table) {
  Json out{{"curve", {{"mu_s", pair.curve.mu_s}, {"mu_d", pair.curve.mu_d}, {"L_m", pair.curve.length}}},
           {"beta", request.beta},
           {"d_m", pair.grains.d},
           {"Phi", pair.grains.Phi},
           {"law", {{"mu_s", pair.law.mu_s}, {"mu_d", pair.law.mu_d}, {"I_0", pair.law.I_0}}}};
  if (pair.fit) {
    const auto& fit = *pair.fit;
    out["fit"] = {{"points", pair.points.size()},
                  {"standard_errors",
                   {{"mu_s", fit.error[0]},
                    {"mu_d", fit.error[1]},
                    {"L_m", fit.error[2]},
                    {"I_0", pair.law.I_0 * fit.error[2] / pair.curve.length}}},
                  {"correlation_mu_s_mu_d_L", fit.correlation},
                  {"residual_tan_zeta", fit.residual}};
  }
  if (!table.empty()) out["points"] = app::json_of(table);
  return out;
}

std::string text_of(const HstopRequest& request, const Pair& pair, const Table& table) {
  std::string out;
  const auto row = [&](const char* name, double value, double error, const char* unit) {
    std::array<char, 120> text{};
    if (pair.fit) std::snprintf(text.data(), text.size(), "%-6s %.10g +- %.3g %s", name, value, error, unit);
    else std::snprintf(text.data(), text.size(), "%-6s %.10g %s", name, value, unit);
    std::string line(text.data());
    out += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  };
  const auto error = pair.fit ? pair.fit->error : std::array<double, 3>{};
  row("mu_s", pair.curve.mu_s, error[0], "");
  row("mu_d", pair.curve.mu_d, error[1], "");
  row("L", pair.curve.length, error[2], "m");
  row("I_0", pair.law.I_0, pair.law.I_0 * error[2] / pair.curve.length, "");
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(), "with beta = %.10g, d = %.10g m, Phi = %.10g\n", request.beta, pair.grains.d,
                pair.grains.Phi);
  out += text.data();
  if (pair.fit) {
    std::snprintf(text.data(), text.size(),
                  "%zu points, residual of tan zeta %.3g; standard errors from the scatter, beta, d and Phi as exact\n",
                  pair.points.size(), pair.fit->residual);
    out += text.data();
  }
  if (!table.empty()) out += "\n" + app::text_of(table);
  return out;
}

}  // namespace

void hstop_command(const HstopRequest& request) {
  const Pair pair = pair_of(request);
  std::vector<double> zeta;
  if (!request.zeta.empty()) zeta = number_list(request.zeta, "--zeta", "degree");
  for (const double each : zeta)
    if (!(each > 0.0 && each < 90.0))
      throw core::ConfigError("--zeta: expected angles above 0 and below 90 [degree], found " + shortest(each));
  const Table table = table_of(pair, zeta);
  if (!request.csv.empty()) {
    if (table.empty()) throw core::ConfigError("--csv: expected --zeta as well, whose table it takes");
    output::write_atomically(request.csv, csv_of(table));
  }
  const std::string out = request.json ? json_of(request, pair, table).dump(1) + "\n" : text_of(request, pair, table);
  std::fputs(out.c_str(), stdout);
}

void add_hstop(CLI::App& program) {
  auto request = std::make_shared<HstopRequest>();
  auto* command = program.add_subcommand(
      "hstop", "from deposits on a rough plane to mu_s, mu_d, I_0 of the classical law, and back (appendix A)");
  command->add_option("--data", request->data, "measurements to fit: columns zeta_deg,h_stop_m")->type_name("DATA.csv");
  command->add_option("--curve", request->curve, "or a curve (A2) known already: mu_s, mu_d [1], L [m]")
      ->type_name("MU_S,MU_D,L");
  command->add_option("--law", request->law, "or, the way back, the law and grains of a scene or material file")
      ->type_name("FILE.toml");
  command->add_option("--beta", request->beta, "slope of Fr = beta h/h_stop (A1) [1]; the paper does not print it")
      ->required();
  command->add_option("--d", request->d, "grain diameter [m]");
  command->add_option("--Phi", request->Phi, "solids fraction [1]");
  command->add_option("--zeta", request->zeta, "angles [degree] at which to list h_stop: 21:32:0.5")->type_name("LIST");
  command->add_option("--set", request->overrides, "replace a value of the --law file; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command->add_flag("--json", request->json, "print JSON, in full precision");
  command->add_option("--csv", request->csv, "write the table there, too")->type_name("X.csv");
  command->footer(
      "Examples:\n"
      "  talus hstop --data deposits.csv --beta 0.136 --d 5e-4 --Phi 0.6\n"
      "  talus hstop --curve 0.38,0.64,8e-4 --beta 0.136 --d 5e-4 --Phi 0.6 --zeta 21:32:0.5\n"
      "  talus hstop --law runs/examples/heap_q46.toml --beta 0.136 --zeta 23:40:1 --csv deposits.csv\n"
      "Least squares of tan zeta over mu_s, mu_d and L: errors of the angle, not of the thickness.");
  command->callback([request] { hstop_command(*request); });
}

}  // namespace talus::app
