// Normals from colours of a cell's nodes that are the membrane's own on all of its points. [York 7.4, 7.7, text]
#pragma once

#include <vector>

#include "kernel/normals/normals.hpp"
#include "kernel/normals/point_cells.hpp"

namespace plumbline {

// sum_p chi_p N_j(x_p) = sum_i T_ij chi_i, T_ij = sum_p N_i(x_p) N_j(x_p) [York 7.10-7.12] in each cell with points,
// one point of another colour added. The colours solved for are those above the membrane's: so the answer of minimum
// norm, where points do not determine them, does not depend on which colour the membrane has.
//
// A point alone in its cell takes the four cells around the node nearest to it as one ghost cell, with linear shapes;
// alone there, too, it has no direction. Or it keeps the normal it had, and takes the ghost cell when it had none. York
// names both. [York section 7.8]
class MassMatrix final : public NormalsMethod {
 public:
  // quadratic: nine colours on the centres of the cell and its neighbours [York 7.18]; else four on its nodes
  // [York 7.8]. keeps: a point alone in its cell keeps its previous normal.
  explicit MassMatrix(bool quadratic, bool keeps = false) : quadratic_(quadratic), keeps_(keeps) {}
  void find(const NormalsInput& input, std::span<double> normal_x, std::span<double> normal_y) override;

 private:
  // A square with lower corner (x, y), in m, and the points in it in coordinates r, s from 0 to 1.
  struct Square {
    double x, y, edge;
  };
  struct Member {
    double r, s;
    int number;  // negative: an image
  };
  void gather(const Square& square, int cell_x, int cell_y, int across);
  void find_alone(const NormalsInput& input, const Member& alone, const Square& cell, int cell_x, int cell_y,
                  std::span<double> normal_x, std::span<double> normal_y);

  bool quadratic_, keeps_;
  PointCells points_;
  std::vector<Member> members_;
};

}  // namespace plumbline
