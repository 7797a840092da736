// What is written of the starts of solids: stresses that closed forms give of strains and deformations.
#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>

#include "cases/catalog/estimators/exchange/given_scenes.hpp"
#include "cases/catalog/estimators/exchange/written_start.hpp"
#include "kernel/materials/segment_membrane.hpp"

namespace plumbline {
namespace {

// Hooke's law with lambda = mu = 1 Pa.
std::vector<double> rows_of_hooke(int normals, int components, int dim) {
  std::vector<double> rows;
  for (int p = 0; p < 3; ++p) {
    const auto strain = [&](int k) { return given_number(column::strain, k, p, dim); };
    double trace = 0;
    for (int k = 0; k < normals; ++k) trace += strain(k);
    for (int k = 0; k < components; ++k) rows.push_back(k < normals ? trace + 2 * strain(k) : strain(k));
  }
  return rows;
}

// (F F^T - 1 + ln J 1) / J row by row, in rings with the hoop's stretch as the third.
std::vector<double> rows_of_neo_hooke(int dim, bool rings) {
  std::vector<double> rows;
  for (int p = 0; p < 3; ++p) {
    Eigen::Matrix3d f = Eigen::Matrix3d::Identity();
    for (int k = 0; k < dim * dim; ++k) f(k / dim, k % dim) = given_number(column::deformation, k, p, dim);
    if (rings) f(2, 2) = given_number(column::deformation, 4, p, dim);
    const double j = f.determinant();
    const Eigen::Matrix3d one = Eigen::Matrix3d::Identity(), stress = (f * f.transpose() + (std::log(j) - 1) * one) / j;
    for (int k = 0; k < dim * dim; ++k) rows.push_back(stress(k / dim, k % dim));
    if (rings) rows.push_back(stress(2, 2));
  }
  return rows;
}

void hold_motion(WrittenStart& start, std::size_t body, int dim) {
  start.holds(body, column::position, dim);
  start.holds(body, column::velocity, dim);
  start.holds(body, column::mass);
}

void add_start_of_rings(KnownAnswers& all) {
  WrittenStart start("rings", case_of_given<GivenEnd>(rings_of_solids, Kind::solid), all);
  for (std::size_t body = 0; body < 2; ++body) {
    hold_motion(start, body, 2);
    start.holds(body, column::affine, 4);
  }
  start.holds(0, column::volume);
  start.holds(0, column::strain, 4);
  start.holds(0, column::stress, 4, rows_of_hooke(3, 4, 2));
  start.holds_nothing_else(0, 7);
  start.holds(1, column::deformation, 5);
  start.holds(1, column::stress, 5, rows_of_neo_hooke(2, true));
  start.holds_nothing_else(1, 7);
  const auto components = [&](std::size_t body, const char* name) {
    return start.described(body)["datasets"][name]["components"];
  };
  start.say("strain", components(0, "strain"), R"(["rr", "zz", "hoop", "rz"])");
  start.say("stress", components(0, "stress"), R"(["rr", "zz", "hoop", "rz"])");
  start.say("affine", components(0, "affine"), R"(["xx", "xy", "yx", "yy"])");
  start.say("deformation", components(1, "deformation"), R"(["xx", "xy", "yx", "yy", "hoop"])");
  start.say("full", components(1, "stress"), R"(["xx", "xy", "yx", "yy", "hoop"])");
  start.say("small.wanted",
            start.wanted_at_end(0) == "position:2 velocity:2 mass:1 volume:1 stress:4 those written here, row by row");
  start.say("finite.wanted", start.wanted_at_end(1) ==
                                 "position:2 velocity:2 mass:1 volume:1 deformation:5 those written here, row by row");
  start.say("axisymmetric", start.description()["grid"]["axisymmetric"], "true");
  start.say("material", start.described(0)["material"],
            R"({"name": "linear_elastic", "parameters": {
                "youngs_modulus": {"value": 2.5, "unit": "Pa"}, "poissons_ratio": {"value": 0.25, "unit": "1"},
                "density": {"value": 1.5, "unit": "kg/m^3"}, "plane_stress": {"value": 0, "unit": "1"}}})");
  start.say("scored", start.description()["scored"], "true");
  start.say("why_not_scored", start.description()["why_not_scored"], "null");
  start.say("measures", start.description()["measures"],
            R"json([{"name": "height.L1", "unit": "m", "norm": "sum_p V_p |e_p| / sum_p V_p"},
                {"name": "height.L2", "unit": "m", "norm": "sqrt(sum_p V_p e_p^2 / sum_p V_p)"},
                {"name": "height.Linf", "unit": "m", "norm": "max_p |e_p|"},
                {"name": "distance", "unit": "m", "norm": "an error of the case's own, see its statement"},
                {"name": "count", "unit": "1", "norm": "|value - reference|"}])json");
}

void add_start_of_space(KnownAnswers& all) {
  WrittenStart start("space", case_of_given<GivenScene>(space_of_solids, Kind::solid), all);
  for (std::size_t body = 0; body < 2; ++body) {
    hold_motion(start, body, 3);
    start.holds(body, column::affine, 9);
  }
  start.holds(0, column::strain, 6);
  start.holds(0, column::stress, 6, rows_of_hooke(3, 6, 3));
  start.holds(1, column::deformation, 9);
  start.holds(1, column::stress, 9, rows_of_neo_hooke(3, false));
  start.holds(1, column::body_force, 3);
  start.holds_nothing_else(1, 8);
  const auto components = [&](std::size_t body, const char* name) {
    return start.described(body)["datasets"][name]["components"];
  };
  start.say("position", components(0, "position"), R"(["x", "y", "z"])");
  start.say("load", start.described(0)["load"]["kind"] == "follows the points");
  start.say("force", components(1, "body_force"), R"(["x", "y", "z"])");
  start.say("strain", components(0, "strain"), R"(["xx", "yy", "zz", "yz", "zx", "xy"])");
  start.say("full", components(1, "stress"), R"(["xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"])");
  start.say("grid", start.description()["grid"],
            R"({"dim": 3, "axisymmetric": false, "h": 0.5, "low": [0, 0, 0], "high": [4, 3, 3.5], "cells": [8, 6, 7],
                "walls": {"x": ["free", "free"], "y": ["free", "free"], "z": ["free", "free"]}})");
  // Nothing says that the final state is enough.
  start.say("scored", start.description()["scored"], "false");
}

void add_start_of_line(KnownAnswers& all) {
  WrittenStart start("line", case_of_given<GivenEnd>(line_of_solids, Kind::solid), all);
  std::vector<double> stress;
  for (int p = 0; p < 3; ++p) stress.push_back(2.5 * given_number(column::strain, 0, p, 1));
  for (std::size_t body = 0; body < 2; ++body) {
    hold_motion(start, body, 1);
    start.holds(body, column::stress, 0, stress);
    const std::string name = start.described(body)["name"];
    start.say(name, start.described(body)["load"]["kind"] == "follows the points" &&
                        !start.file().has("/bodies/" + name + "/load"));
  }
}

}  // namespace

void add_other_starts(KnownAnswers& all) {
  add_start_of_rings(all);
  add_start_of_space(all);
  add_start_of_line(all);
  WrittenStart bands("bands", case_of_given<GivenScene>(rings_of_bands, Kind::membrane), all);
  bands.holds(0, column::rest_length);
  bands.holds(0, column::rest_radius);
  bands.holds_nothing_else(0, 8);  // position, velocity, mass, volume, strain and segments besides
}

}  // namespace plumbline
