#include "cases/harness/exchange/result_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cases/harness/files/errors.hpp"
#include "kernel/materials/ideal_gas.hpp"
#include "kernel/materials/linear_elastic.hpp"

namespace plumbline {
namespace {

[[noreturn]] void refuse(const ForeignFile& file, const std::string& why) {
  throw FileError(file.path(), file.path() + ": " + why);
}

std::string wanted_text(const ForeignFile& file, const std::string& name) {
  const auto text = file.text_attribute(name);
  if (!text)
    refuse(file, "the attribute " + name +
                     " is missing; reports/docs/how-to/score-another-code.md lists what a result holds");
  return *text;
}

double wanted_number(const ForeignFile& file, const std::string& name) {
  const auto number = file.number_attribute(name);
  if (!number)
    refuse(file, "the attribute " + name +
                     " is missing; reports/docs/how-to/score-another-code.md lists what a result holds");
  return *number;
}

// A number that is optional, at least zero and finite.
double count_of(const ForeignFile& file, const std::string& name) {
  const double number = file.number_attribute(name).value_or(0);
  if (!(number >= 0) || !std::isfinite(number)) {
    refuse(file, fmt::format("the attribute {} is {}; a number >= 0 is wanted", name, number));
  }
  return number;
}

// Fit for a file's name.
std::string plain(std::string text) {
  for (char& c : text) {
    const bool kept = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
                      c == '_' || c == '-' || c == '+';
    if (!kept) c = '_';
  }
  return text.empty() ? "unnamed" : text.substr(0, 40);
}

std::string shape_text(const std::vector<std::size_t>& shape) {
  return shape.size() == 1 ? fmt::format("({})", shape[0]) : fmt::format("({}, {})", shape[0], shape[1]);
}

ColumnId column_of(const std::string& name) {
  for (const ColumnId& id : {column::position, column::velocity, column::mass, column::volume, column::density,
                             column::energy, column::pressure, column::stress, column::deformation}) {
    if (id.name() == name) return id;
  }
  throw std::logic_error("no column " + name);
}

// Reads the datasets of one body.
class BodyReader {
 public:
  BodyReader(const ForeignFile& file, const Body& body, const GridSpec& grid)
      : file_(file),
        group_("/bodies/" + body.name),
        wanted_(wanted_datasets(*body.material, grid.dim, grid.axisymmetric)) {
    if (!file.has(group_)) refuse(file, "the group " + group_ + " is missing" + held("/bodies"));
  }

  // How many points: the rows of the first dataset.
  std::size_t rows() const {
    const std::string first = group_ + "/" + wanted_.front().name;
    if (!file_.has(first)) refuse(file_, first + " is missing" + held(group_));
    const std::size_t rows = file_.numbers(first).shape[0];
    if (rows == 0) refuse(file_, first + " has no rows");
    return rows;
  }

  // Fills what is there; returns the names.
  std::vector<std::string> read(std::size_t rows, Columns& points) const {
    std::vector<std::string> found;
    for (const WantedDataset& wanted : wanted_) {
      const std::string path = group_ + "/" + wanted.name;
      if (file_.has(path)) {
        take(wanted, path, rows, points);
        found.push_back(wanted.name);
        continue;
      }
      const bool other = std::any_of(wanted.instead.begin(), wanted.instead.end(),
                                     [&](const std::string& name) { return file_.has(group_ + "/" + name); });
      if (!other) {
        refuse(file_, path + " is missing" + (wanted.instead.empty() ? "" : ", and so is " + wanted.instead.front()) +
                          held(group_));
      }
    }
    return found;
  }

 private:
  std::string held(const std::string& group) const {
    std::string names;
    for (const std::string& name : file_.members(group)) names += (names.empty() ? "" : ", ") + name;
    return fmt::format("; {} holds {}", group, names.empty() ? "nothing" : names);
  }

  void take(const WantedDataset& wanted, const std::string& path, std::size_t rows, Columns& points) const {
    const NumberTable table = file_.numbers(path);
    const auto columns = static_cast<std::size_t>(wanted.components);
    const std::vector<std::size_t> full{rows, columns};
    const bool flat = columns == 1 && table.shape == std::vector<std::size_t>{rows};
    if (!flat && table.shape != full) {
      refuse(file_, fmt::format("{} has the shape {}; {} is wanted", path, shape_text(table.shape), shape_text(full)));
    }
    const ColumnId id = column_of(wanted.name);
    points.add(id, wanted.components);
    for (std::size_t p = 0; p < rows; ++p) {
      for (std::size_t k = 0; k < columns; ++k) {
        const double value = table.values[p * columns + k];
        check(wanted, path, p, value);
        points(id, static_cast<int>(k))[p] = value;
      }
    }
  }

  void check(const WantedDataset& wanted, const std::string& path, std::size_t row, double value) const {
    const bool good = std::isfinite(value) && (!wanted.positive || value > 0) && (!wanted.not_negative || value >= 0);
    if (good) return;
    const char* allowed = wanted.positive ? "finite and > 0" : wanted.not_negative ? "finite and >= 0" : "finite";
    refuse(file_, fmt::format("{} is {} in row {}; it must be {}", path, value, row, allowed));
  }

  const ForeignFile& file_;
  std::string group_;
  std::vector<WantedDataset> wanted_;
};

bool contains(const std::vector<std::string>& names, const char* name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// No point leaves the grid by more than a cell: rounding and walls that give way a little are all that may.
void require_inside(const ForeignFile& file, const std::string& body, const GridSpec& grid, const Columns& points) {
  for (int d = 0; d < grid.dim; ++d) {
    const auto k = static_cast<std::size_t>(d);
    const double low = grid.origin[k] - grid.h, high = grid.origin[k] + (grid.cells[k] + 1) * grid.h;
    for (int p = 0; p < points.points(); ++p) {
      const double x = points(column::position, d)[p];
      if (x >= low && x <= high) continue;
      refuse(file, fmt::format("/bodies/{}/position is {} in row {}; the grid reaches from {} to {} in {}", body, x, p,
                               low + grid.h, high - grid.h, "xyz"[d]));
    }
  }
}

// What the file gives stays as it is; of a gas the other half follows from the mass and the equation of state.
void complete_gas(const IdealGas& gas, const std::vector<std::string>& found, Columns& points) {
  for (const ColumnId& id : {column::density, column::volume, column::energy, column::pressure}) points.add(id);
  for (int p = 0; p < points.points(); ++p) {
    const double m = points(column::mass)[p];
    double &rho = points(column::density)[p], &volume = points(column::volume)[p];
    double &e = points(column::energy)[p], &pressure = points(column::pressure)[p];
    if (!contains(found, "density")) rho = m / volume;
    if (!contains(found, "volume")) volume = m / rho;
    if (!contains(found, "energy")) e = pressure / ((gas.gamma - 1) * rho);  // [York 4.4]
    if (!contains(found, "pressure")) pressure = (gas.gamma - 1) * rho * e;  // [York 4.4]
  }
}

// The strain of Hooke's law [Hooke 1], solved for it.
void complete_elastic(const LinearElastic& material, const GridSpec& grid, Columns& points) {
  const int components = points.components(column::stress);
  const int normals = normal_components(grid.dim, grid.axisymmetric);
  const auto [lambda, mu] = material.constants(grid.dim);
  points.add(column::strain, components);
  for (int p = 0; p < points.points(); ++p) {
    double trace = 0;
    for (int k = 0; k < normals; ++k) trace += points(column::stress, k)[p] / (normals * lambda + 2 * mu);
    for (int k = 0; k < components; ++k) {
      const double stress = points(column::stress, k)[p];
      points(column::strain, k)[p] = k < normals ? (stress - lambda * trace) / (2 * mu) : stress / mu;
    }
  }
}

}  // namespace

ResultFile::ResultFile(const std::string& path, double patience) : reader_(path, patience) {
  const double format = wanted_number(reader_, "exchange_format");
  if (format != exchange_format) {
    refuse(reader_, fmt::format("exchange_format is {}; this program reads {}", format, exchange_format));
  }
  const std::string kind = wanted_text(reader_, "kind");
  if (kind != "final-state") refuse(reader_, "the attribute kind is " + kind + "; final-state is wanted");
  case_name = wanted_text(reader_, "case");
  start = wanted_text(reader_, "start");
  time = wanted_number(reader_, "time");
  const double mesh = wanted_number(reader_, "cells");
  if (!(mesh >= 1) || mesh > 1e9 || mesh != std::floor(mesh)) {
    refuse(reader_, fmt::format("the attribute cells is {}; a whole number > 0 is wanted", mesh));
  }
  cells = static_cast<int>(mesh);
  program = plain(reader_.text_attribute("program").value_or(""));
  version = reader_.text_attribute("version").value_or("");
  problem = reader_.text_attribute("problem").value_or("");
  steps = static_cast<long>(std::min(count_of(reader_, "steps"), 1e15));
  wall_s = count_of(reader_, "wall_s");
}

std::vector<HandedIn> ResultFile::points(const Scene& scene) const {
  std::vector<HandedIn> all;
  for (const Body& body : scene.bodies) all.push_back(points_of(body, scene.grid));
  for (const std::string& name : reader_.members("/bodies")) {
    const bool known = std::any_of(scene.bodies.begin(), scene.bodies.end(),
                                   [&](const Body& body) { return body.name == name; });
    if (!known) refuse(reader_, "/bodies/" + name + ": the case has no such body");
  }
  return all;
}

HandedIn ResultFile::points_of(const Body& body, const GridSpec& grid) const {
  const BodyReader reader(reader_, body, grid);
  const std::size_t rows = reader.rows();
  const auto own = static_cast<std::size_t>(body.points.points());
  if (!any_points_will_do(*body.material) && rows != own) {
    refuse(reader_, fmt::format("/bodies/{}/position has {} rows; the case has {} points at {} cells, and a solid is "
                                "judged particle by particle: hand in the points of the export, in its order",
                                body.name, rows, own, cells));
  }
  HandedIn in{static_cast<int>(rows), Columns(static_cast<int>(rows))};
  const std::vector<std::string> found = reader.read(rows, in.columns);
  require_inside(reader_, body.name, grid, in.columns);
  if (const auto* gas = dynamic_cast<const IdealGas*>(body.material.get())) complete_gas(*gas, found, in.columns);
  if (const auto* elastic = dynamic_cast<const LinearElastic*>(body.material.get())) {
    complete_elastic(*elastic, grid, in.columns);
  }
  return in;
}

}  // namespace plumbline
