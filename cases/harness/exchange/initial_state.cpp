#include "cases/harness/exchange/initial_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "cases/harness/exchange/exchange.hpp"
#include "cases/harness/exchange/final_state.hpp"
#include "cases/harness/files/hdf5_file.hpp"
#include "cases/harness/files/json_text.hpp"
#include "cases/harness/files/text_file.hpp"
#include "kernel/materials/material_entry.hpp"
#include "kernel/materials/segment_membrane.hpp"
#include "kernel/materials/uniaxial_membrane.hpp"

namespace plumbline {
namespace {

constexpr int load_instants = 201;  // of a table of body forces, the start and the end included

std::string name_of(Wall wall) { return wall == Wall::free ? "free" : wall == Wall::symmetry ? "symmetry" : "no_slip"; }

Json components(const std::array<double, 3>& all, int dim) {
  Json list = Json::array();
  for (int d = 0; d < dim; ++d) list.push_back(all[static_cast<std::size_t>(d)]);
  return list;
}

Json grid_json(const GridSpec& grid) {
  Json cells = Json::array(), high = Json::array(), walls = Json::object();
  for (int d = 0; d < grid.dim; ++d) {
    const auto k = static_cast<std::size_t>(d);
    cells.push_back(grid.cells[k]);
    high.push_back(grid.origin[k] + grid.h * grid.cells[k]);
    walls[axis_name(d)] = {name_of(grid.walls[k][0]), name_of(grid.walls[k][1])};
  }
  return {{"dim", grid.dim}, {"axisymmetric", grid.axisymmetric},
          {"h", grid.h},     {"low", components(grid.origin, grid.dim)},
          {"high", high},    {"cells", cells},
          {"walls", walls}};
}

Json pistons_json(const Scene& scene) {
  Json list = Json::array();
  for (const Piston& piston : scene.pistons) {
    list.push_back({{"direction", axis_name(piston.direction)},
                    {"scene_lies", piston.side == 0 ? "above" : "below"},
                    {"position", piston.position},
                    {"velocity", piston.velocity}});
    if (piston.rise > 0) list.back()["rise"] = piston.rise;
  }
  return list;
}

Json material_json(const Material& material) {
  Json parameters = Json::object();
  for (const MaterialParameter& p : parameters_of(material))
    parameters[p.name] = {{"value", p.value}, {"unit", p.unit}};
  return {{"name", material.name()}, {"parameters", parameters}};
}

// What the rows of a dataset stand for.
std::vector<std::string> component_names(const ColumnId& id, const Body& body, const GridSpec& grid) {
  const int count = body.points.components(id);
  if (count == 1) return {};
  const StressMeasure measure = body.material->measure();
  const bool tensor = id.index() == column::deformation.index() || id.index() == column::affine.index() ||
                      (id.index() == column::stress.index() && measure == StressMeasure::full);
  const bool symmetric = id.index() == column::strain.index() ||
                         (id.index() == column::stress.index() && measure == StressMeasure::symmetric);
  std::vector<std::string> names;
  if (symmetric) {
    if (grid.dim == 3) return {"xx", "yy", "zz", "yz", "zx", "xy"};
    if (grid.axisymmetric) return {"rr", "zz", "hoop", "rz"};
    return {"xx", "yy", "xy"};
  }
  for (int d = 0; d < grid.dim; ++d) {
    if (!tensor) names.push_back(axis_name(d));
    for (int e = 0; tensor && e < grid.dim; ++e) names.push_back(axis_name(d) + axis_name(e));
  }
  if (tensor && id.index() != column::affine.index() && grid.axisymmetric) names.push_back("hoop");
  return names;
}

// Writes the columns of the bodies and says what was written.
class Writer {
 public:
  Writer(const Scene& scene, double end_time, Hdf5Writer& file) : scene_(scene), end_time_(end_time), file_(file) {}

  Json body(Body body) const {
    complete(body);
    const std::string group = "/bodies/" + body.name;
    file_.group(group);
    Json datasets = Json::object();
    for (const ColumnId* id : written_columns()) {
      if (written(body, *id)) datasets[id->name()] = column(body, group, *id);
    }
    Json entry{{"name", body.name},
               {"group", group},
               {"material", material_json(*body.material)},
               {"points", body.points.points()},
               {"velocity_field", body.field},
               {"datasets", datasets}};
    entry["segments"] = body.chain ? segments(body, group) : Json(nullptr);
    entry["load"] = body.load ? load(body, group) : Json(nullptr);
    entry["enclosure"] = body.enclosure ? enclosure(*body.enclosure) : Json(nullptr);
    entry["final_state"] = final_state(body);
    return entry;
  }

 private:
  static std::vector<const ColumnId*> written_columns() {
    return {&column::position, &column::velocity,    &column::mass,        &column::volume,    &column::density,
            &column::energy,   &column::pressure,    &column::stress,      &column::strain,    &column::deformation,
            &column::affine,   &column::rest_length, &column::rest_radius, &column::body_force};
  }

  // Forces between points and pressures say the same as what is written beside; loads are written as a table.
  static bool written(const Body& body, const ColumnId& id) {
    if (!body.points.has(id)) return false;
    if (id.index() == column::body_force.index()) return !body.load;
    if (id.index() != column::stress.index()) return true;
    const StressMeasure measure = body.material->measure();
    return measure != StressMeasure::point_force && !body.material->has_density();
  }

  // Densities that a scene leaves to the density method are those of the points; stresses follow from the state.
  void complete(Body& body) const {
    Columns& points = body.points;
    if (points.has(column::density)) {
      for (int p = 0; p < points.points(); ++p) {
        double& density = points(column::density)[p];
        if (!(density > 0)) density = points(column::mass)[p] / points(column::volume)[p];
      }
    }
    MaterialContext context;
    context.dim = scene_.grid.dim;
    context.h = scene_.grid.h;
    body.material->prepare_stress(points, all_points(points), context);
    body.material->evaluate_stress(points, all_points(points), context);
  }

  Json column(const Body& body, const std::string& group, const ColumnId& id) const {
    const Columns& points = body.points;
    const int count = points.components(id);
    const bool vector = id.index() == column::position.index() || id.index() == column::velocity.index();
    std::vector<double> rows;
    for (int p = 0; p < points.points(); ++p) {
      for (int k = 0; k < count; ++k) rows.push_back(points(id, k)[p]);
    }
    const std::string path = group + "/" + id.name();
    const bool flat = count == 1 && !vector;
    file_.array<double>(path, rows, flat ? 0 : static_cast<std::size_t>(count));
    file_.attribute(path, "unit", id.unit());
    Json shape = flat ? Json{points.points()} : Json{points.points(), count};
    Json entry{{"shape", shape}, {"unit", id.unit()}};
    if (const auto names = component_names(id, body, scene_.grid); !names.empty()) entry["components"] = names;
    return entry;
  }

  Json segments(const Body& body, const std::string& group) const {
    const auto parameters = parameters_of(*body.material);
    const bool closed = std::any_of(parameters.begin(), parameters.end(),
                                    [](const MaterialParameter& p) { return p.name == "closed" && p.value != 0; });
    const int points = body.points.points(), count = closed ? points : points - 1;
    std::vector<std::int64_t> pairs;
    for (int s = 0; s < count; ++s) {
      pairs.push_back(s);
      pairs.push_back((s + 1) % points);
    }
    file_.array<std::int64_t>(group + "/segments", pairs, 2);
    return {{"shape", {count, 2}}, {"what", "numbers of the two points that a segment joins, counted from 0"}};
  }

  std::vector<double> accelerations(Body& body, double time) const {
    body.load(time, body.points, body.id);
    std::vector<double> rows;
    for (int p = 0; p < body.points.points(); ++p) {
      for (int d = 0; d < scene_.grid.dim; ++d) rows.push_back(body.points(column::body_force, d)[p]);
    }
    return rows;
  }

  // Whether the load asks where the points are or how fast they move: then no table of it can be made beforehand.
  bool follows_points(Body body) const {
    body.points.add(column::body_force, scene_.grid.dim);
    const std::vector<double> here = accelerations(body, end_time_ / 2);
    for (int d = 0; d < scene_.grid.dim; ++d) {
      for (int p = 0; p < body.points.points(); ++p) {
        body.points(column::position, d)[p] += 0.125 * scene_.grid.h * (1 + p % 3);
        body.points(column::velocity, d)[p] += 0.125 * scene_.grid.h / end_time_ * (1 + p % 5);
      }
    }
    return accelerations(body, end_time_ / 2) != here;
  }

  Json load(Body body, const std::string& group) const {
    if (follows_points(body)) {
      return {{"kind", "follows the points"},
              {"what", "depends on where the points are: see the case's statement; no table is written"}};
    }
    body.points.add(column::body_force, scene_.grid.dim);
    std::vector<double> times, all;
    for (int k = 0; k < load_instants; ++k) {
      times.push_back(end_time_ * k / (load_instants - 1));
      const std::vector<double> rows = accelerations(body, times.back());
      all.insert(all.end(), rows.begin(), rows.end());
    }
    const auto width = static_cast<std::size_t>(body.points.points() * scene_.grid.dim);
    file_.numbers(group + "/load/time", times);
    file_.array<double>(group + "/load/acceleration", all, width);
    return {{"kind", "table"},
            {"unit", "m/s^2"},
            {"times", load_instants},
            {"what",
             "acceleration of each point, by its number, beside gravity: row k at time[k], in it point after "
             "point, its components side by side"}};
  }

  static Json enclosure(const Enclosure& enclosure) {
    Json corners = Json::array();
    for (const auto& corner : enclosure.corners) corners.push_back({corner[0], corner[1]});
    return {{"chain", enclosure.chain}, {"corners", corners}};
  }

  Json final_state(const Body& body) const {
    Json list = Json::array();
    const GridSpec& grid = scene_.grid;
    for (const WantedDataset& wanted : wanted_datasets(*body.material, grid.dim, grid.axisymmetric)) {
      list.push_back({{"name", wanted.name},
                      {"unit", wanted.unit},
                      {"components", wanted.components},
                      {"instead", wanted.instead},
                      {"what", wanted.what}});
    }
    return {{"datasets", list},
            {"points", any_points_will_do(*body.material) ? "any number" : "those written here, row by row"}};
  }

  const Scene& scene_;
  double end_time_;
  Hdf5Writer& file_;
};

std::string norm_of(const Measure& measure) {
  if (measure.value) return "|value - reference|";
  if (measure.name.ends_with(".L1")) return "sum_p V_p |e_p| / sum_p V_p";
  if (measure.name.ends_with(".L2")) return "sqrt(sum_p V_p e_p^2 / sum_p V_p)";
  if (measure.name.ends_with(".Linf")) return "max_p |e_p|";
  return "an error of the case's own, see its statement";
}

Json measures_json(const Problem& problem, const Settings& settings) {
  Json list = Json::array();
  for (const Measure& m : measures_to_be_judged(problem, settings)) {
    list.push_back({{"name", m.name}, {"unit", m.unit}, {"norm", norm_of(m)}});
  }
  return list;
}

Json describe(const Case& entry, const std::string& scheme, const Settings& settings, const Problem& problem,
              const Scene& scene, const Provenance& provenance) {
  const Statement statement = entry.statement();
  const std::string why_not = why_not_scored(entry, settings);
  Json description{{"exchange_format", exchange_format},
                   {"kind", "initial-state"},
                   {"case", statement.name},
                   {"title", statement.title},
                   {"source", statement.source},
                   {"physics", statement.physics},
                   {"equations", statement.equations},
                   {"problem", problem_id(entry, settings)},
                   {"start", start_id(entry, settings)},
                   {"cells", settings.integer("cells")},
                   {"end_time", problem.end_time()},
                   {"grid", grid_json(scene.grid)},
                   {"pistons", pistons_json(scene)},
                   {"gravity", components(scene.gravity, scene.grid.dim)},
                   {"contact", scene.contact},
                   {"scheme", scheme},
                   {"settings", to_json(settings)},
                   {"bodies", Json::array()},
                   {"scored", why_not.empty()}};
  description["why_not_scored"] = why_not.empty() ? Json(nullptr) : Json(why_not);
  description["measures"] = why_not.empty() ? measures_json(problem, settings) : Json::array();
  description["version"] = provenance.version;
  return description;
}

}  // namespace

std::string description_beside(const std::string& file) {
  return std::filesystem::path(file).replace_extension(".json").string();
}

Json write_initial_state(const Case& entry, const std::string& scheme, const Settings& settings,
                         const std::string& file, const Provenance& provenance) {
  const auto problem = entry.problem(settings);
  Scene scene = problem->scene();
  Json description = describe(entry, scheme, settings, *problem, scene, provenance);
  Hdf5Writer out(file);
  out.attribute("/", "exchange_format", std::int64_t{exchange_format});
  out.attribute("/", "kind", "initial-state");
  out.attribute("/", "case", entry.name);
  out.attribute("/", "problem", problem_id(entry, settings));
  out.attribute("/", "start", start_id(entry, settings));
  out.attribute("/", "cells", static_cast<std::int64_t>(settings.integer("cells")));
  out.real_attribute("/", "end_time", problem->end_time());
  const Writer writer(scene, problem->end_time(), out);
  for (const Body& body : scene.bodies) description["bodies"].push_back(writer.body(body));
  out.text("/description", json_text(description, 1));
  out.commit();
  write_text_file(description_beside(file), json_text(description, 1) + "\n");
  return description;
}

}  // namespace plumbline
