#include "cases/harness/exchange/exchange.hpp"

namespace plumbline {

std::string problem_id(const Case& entry, const Settings& settings) {
  std::string text = entry.name + "\n";
  for (const Key& key : entry.keys) text += key.name + "=" + to_text(settings[key.name]) + "\n";
  return short_hash(text);
}

std::string start_id(const Case& entry, const Settings& settings) {
  return short_hash(problem_id(entry, settings) + "\ncells=" + to_text(settings["cells"]));
}

std::string axis_name(int direction) { return std::string(1, "xyz"[direction]); }

bool any_points_will_do(const Material& material) { return material.has_density(); }

std::vector<WantedDataset> wanted_datasets(const Material& material, int dim, bool axisymmetric) {
  const int stresses = stress_components(material.measure(), dim, axisymmetric);
  std::vector<WantedDataset> all{
      {.name = "position", .unit = "m", .components = dim, .vector = true, .what = "where the point is"},
      {.name = "velocity", .unit = "m/s", .components = dim, .vector = true, .what = "its velocity"},
      {.name = "mass", .unit = "kg", .positive = true, .what = "its mass"}};
  if (material.name() == "ideal_gas") {
    all.push_back({.name = "density",
                   .unit = "kg/m^3",
                   .positive = true,
                   .instead = {"volume"},
                   .what = "density, or volume: each is the mass over the other"});
    all.push_back({.name = "volume", .unit = "m^3", .positive = true, .instead = {"density"}, .what = "see density"});
    all.push_back({.name = "energy",
                   .unit = "J/kg",
                   .not_negative = true,
                   .instead = {"pressure"},
                   .what = "specific internal energy, or pressure: p = (gamma - 1) rho e; with both, each is judged"});
    all.push_back({.name = "pressure",
                   .unit = "Pa",
                   .not_negative = true,
                   .instead = {"energy"},
                   .what = "thermodynamic pressure, without viscosity; see energy"});
    return all;
  }
  all.push_back({.name = "volume", .unit = "m^3", .positive = true, .what = "weight of the point in the norms"});
  if (material.name() == "neo_hookean") {
    all.push_back({.name = "deformation",
                   .unit = "1",
                   .components = dim * dim + (axisymmetric ? 1 : 0),
                   .what = "deformation gradient F, row by row, then the hoop's stretch of an axisymmetric scene"});
    return all;
  }
  if (material.name() == "linear_elastic" || material.name() == "plane_stress_membrane") {
    all.push_back({.name = "stress",
                   .unit = "Pa",
                   .components = stresses,
                   .what = "tension positive: normal components, then shears; the strain is worked out of it"});
    return all;
  }
  return {};
}

}  // namespace plumbline
