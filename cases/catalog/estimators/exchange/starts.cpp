// What is written of a start for other programs: a gas with chains beside it, read back column by column.
#include "cases/catalog/estimators/answers.hpp"
#include "cases/catalog/estimators/exchange/given_scenes.hpp"
#include "cases/catalog/estimators/exchange/written_start.hpp"
#include "cases/harness/exchange/exchange.hpp"
#include "kernel/materials/segment_membrane.hpp"

namespace plumbline {
namespace {

void say_all_of_plane(WrittenStart& start) {
  const Json& all = start.description();
  start.say("grid", all["grid"],
            R"({"dim": 2, "axisymmetric": false, "h": 0.5, "low": [0.5, -0.25], "high": [4.5, 2.75], "cells": [8, 6],
                "walls": {"x": ["symmetry", "free"], "y": ["no_slip", "symmetry"]}})");
  start.say("pistons", all["pistons"],
            R"([{"direction": "x", "scene_lies": "above", "position": 0.75, "velocity": 2},
                {"direction": "y", "scene_lies": "below", "position": 2.5, "velocity": -1, "rise": 0.5}])");
  start.say("gravity", all["gravity"], "[0.25, -9.75]");
  start.say("contact", all["contact"], R"("separation")");
  start.say("scored", all["scored"], "false");
  start.say("why_not_scored", all["why_not_scored"].is_string());
  start.say("measures", all["measures"], "[]");
  start.say("gas.material", start.described(0)["material"],
            R"({"name": "ideal_gas", "parameters": {
                "gamma": {"value": 1.5, "unit": "1"}, "viscosity": {"value": 0, "unit": "Pa s"},
                "viscosity_linear": {"value": 0, "unit": "1"}, "viscosity_quadratic": {"value": 0, "unit": "1"}}})");
  start.say("gas.enclosure", start.described(0)["enclosure"], R"({"chain": "skin", "corners": [[3, 1], [3.5, 2]]})");
  start.say("gas.segments", start.described(0)["segments"].is_null() && !start.file().has("/bodies/gas/segments"));
  start.say("skin.enclosure", start.described(1)["enclosure"].is_null());
  start.say("skin.field", start.described(1)["velocity_field"] == "second");
  start.say("gas.field", start.described(0)["velocity_field"] == "common");
  start.say("gas.name", start.described(0)["name"] == "gas" && start.described(0)["group"] == "/bodies/gas");
  start.say("skin.load", start.described(1)["load"].is_null() && !start.file().has("/bodies/skin/load"));
  start.say("gas.wanted",
            start.wanted_at_end(0) == "position:2 velocity:2 mass:1 density:1 volume:1 energy:1 pressure:1 any number");
  start.say("gas.components", start.described(0)["datasets"]["position"]["components"], R"(["x", "y"])");
  start.say("gas.affine", start.described(0)["datasets"]["affine"]["components"], R"(["xx", "xy", "yx", "yy"])");
  start.say("gas.scalar", !start.described(0)["datasets"]["mass"].contains("components"));
  start.say("layer.stress", start.described(3)["datasets"]["stress"]["components"], R"(["xx", "yy", "xy"])");
}

void say_all_of_file(WrittenStart& start, const Case& entry) {
  const Json& all = start.description();
  const Statement statement = entry.statement();
  const Settings settings = settings_of_given();
  start.say("kind", all["kind"] == "initial-state" && start.file().text_attribute("kind") == "initial-state");
  start.say("format", all["exchange_format"] == 1 && start.file().number_attribute("exchange_format") == 1);
  start.say("case", all["case"] == "sod" && start.file().text_attribute("case") == "sod");
  start.say("title", all["title"] == statement.title && all["source"] == statement.source);
  start.say("physics", all["physics"] == statement.physics && all["equations"] == Json(statement.equations));
  const std::string problem = problem_id(entry, settings), begun = start_id(entry, settings);
  start.say("problem", all["problem"] == problem && start.file().text_attribute("problem") == problem);
  start.say("start", all["start"] == begun && start.file().text_attribute("start") == begun);
  start.say("cells", all["cells"] == 20 && start.file().number_attribute("cells") == 20);
  start.say("end_time", all["end_time"] == end_of_given && start.file().number_attribute("end_time") == end_of_given);
  start.say("scheme", all["scheme"] == "default" && all["settings"] == to_json(settings));
  start.say("version", all["version"] == "1.2.3");
  start.say("beside", Json::parse(start.text_beside()) == all);
}

// The accelerations of the load at 201 instants: x by x, as given_scenes.cpp has them.
void add_load(const WrittenStart& start, KnownAnswers& all) {
  std::vector<double> times, rows;
  for (int k = 0; k <= 200; ++k) {
    const double time = 0.01 * k;
    times.push_back(time);
    for (int p = 0; p < 3; ++p) rows.insert(rows.end(), {time * (1 + p), p - time * time});
  }
  add_table("plane.load.time", start.file(), "/bodies/gas/load/time", {201}, times, all);
  add_table("plane.load.acceleration", start.file(), "/bodies/gas/load/acceleration", {201, 6}, rows, all);
  const Json load = start.described(0)["load"];
  all.push_back(yes("plane.load", load["kind"] == "table" && load["unit"] == "m/s^2" && load["times"] == 201));
}

void add_segments_of(WrittenStart& start, std::size_t body, std::size_t count, const std::vector<double>& pairs,
                     KnownAnswers& all) {
  const Json described = start.described(body);
  const std::string name = described["name"];
  add_table(name + ".segments", start.file(), described["group"].get<std::string>() + "/segments", {count, 2}, pairs,
            all);
  all.push_back(yes(name + ".segments.said", described["segments"]["shape"] == Json{count, 2}));
}

// Of the gas the densities that are missing are m / V; its volume and pressure follow from density and energy, gamma = 3/2.
void add_plane(KnownAnswers& all) {
  const Case entry = case_of_given<GivenEnd>(plane_of_gas_and_chains, Kind::coupled);
  WrittenStart start("plane", entry, all);
  say_all_of_plane(start);
  say_all_of_file(start, entry);
  std::vector<double> density = given_rows(column::density, 1, 3, 2), volume, pressure;
  for (const int p : {0, 2}) {
    density[static_cast<std::size_t>(p)] = given_number(column::mass, 0, p, 2) / given_number(column::volume, 0, p, 2);
  }
  for (int p = 0; p < 3; ++p) {
    const double rho = density[static_cast<std::size_t>(p)];
    volume.push_back(given_number(column::mass, 0, p, 2) / rho);
    pressure.push_back(0.5 * rho * given_number(column::energy, 0, p, 2));
  }
  start.holds(0, column::density, 0, density);
  start.holds(0, column::volume, 0, volume);
  start.holds(0, column::pressure, 0, pressure);
  start.holds(0, column::energy);
  start.holds(0, column::affine, 4);
  start.holds_nothing_else(0, 9);  // position, velocity, mass and the load besides; no stress
  for (std::size_t body = 0; body < 4; ++body) {
    start.holds(body, column::position, 2);
    start.holds(body, column::velocity, 2);
    start.holds(body, column::mass);
  }
  for (std::size_t body = 1; body < 4; ++body) {
    start.holds(body, column::volume);
    start.holds(body, column::strain);
  }
  for (std::size_t body = 1; body < 3; ++body) {
    start.holds(body, column::rest_length);
    start.holds_nothing_else(body, 7);
  }
  std::vector<double> stress;  // along (1, 1)/sqrt(2), E = 4 Pa
  for (int p = 0; p < 3; ++p) stress.insert(stress.end(), 3, 2 * given_number(column::strain, 0, p, 2));
  start.holds(3, column::stress, 3, stress);
  start.holds_nothing_else(3, 7);
  add_segments_of(start, 1, 3, {0, 1, 1, 2, 2, 3}, all);
  add_segments_of(start, 2, 3, {0, 1, 1, 2, 2, 0}, all);
  add_segments_of(start, 3, 2, {0, 1, 1, 2}, all);
  add_load(start, all);
}

}  // namespace

KnownAnswers start_answers() {
  KnownAnswers all;
  add_plane(all);
  add_other_starts(all);
  return all;
}

}  // namespace plumbline
