// The error that ends a run at the first inadmissible value.
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

namespace plumbline {

// Non-finite, density <= 0, internal energy < 0, a point outside the grid, a point that moved more than one cell.
struct InadmissibleState : std::runtime_error {
  InadmissibleState(std::string why, std::string body_name, int point_id, std::string field_name, double bad_value)
      : std::runtime_error(why + " (body " + body_name + ", point " + std::to_string(point_id) + ", field " +
                           field_name + ", value " + std::to_string(bad_value) + ")"),
        reason(std::move(why)),
        body(std::move(body_name)),
        point(point_id),
        field(std::move(field_name)),
        value(bad_value) {}

  std::string reason, body;
  int point;          // the point's number as the scene made it
  std::string field;  // a column's name
  double value;
  long step = 0;    // set by the simulation
  double time = 0;  // s
};

}  // namespace plumbline
