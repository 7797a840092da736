// Cholesky factors of a large sparse matrix whose unknowns stand in space.
#pragma once

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <vector>

namespace plumbline {

// A = L L^T by nested dissection (A. George, SIAM J. Numer. Anal. 10 (1973) 345, doi 10.1137/0710032) and dense fronts (I. S. Duff,
// J. K. Reid, ACM Trans. Math. Softw. 9 (1983) 302, doi 10.1145/356044.356047): unknowns are halved across their longest side again
// and again, and those of one half that couple with the other are eliminated after both. Of n unknowns on a surface, each of which
// couples with those near it, it takes of the order of n^1.5 operations, nearly all of them in products of dense matrices.
class DissectedCholesky {
 public:
  //   matrix  symmetric and positive definite; both triangles are stored
  //   places  of the unknowns, in any unit, finite, one for each row
  // Throws std::invalid_argument where a pivot is not positive or the sizes do not agree.
  DissectedCholesky(const Eigen::SparseMatrix<double>& matrix, const std::vector<Eigen::Vector3d>& places);

  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  // Unknowns that are eliminated together, `first` up to, not with, `end` in the order of elimination, and later ones that they couple
  // with by then.
  struct Front {
    int first = 0, end = 0;
    std::vector<int> later;      // ascending
    std::vector<int> parts;      // fronts whose unknowns are eliminated into this one
    Eigen::MatrixXd own, below;  // of L: lower triangle of its own unknowns; rows of the later ones
  };

  int dissect(std::vector<int> unknowns, const Eigen::SparseMatrix<double>& matrix,
              const std::vector<Eigen::Vector3d>& places);
  void find_later(Front& front, const Eigen::SparseMatrix<double>& matrix) const;
  Eigen::MatrixXd eliminate(Front& front, const Eigen::SparseMatrix<double>& matrix,
                            std::vector<Eigen::MatrixXd>& updates);

  std::vector<int> unknown_, turn_;  // by turn of elimination, and the turn of each
  std::vector<Front> fronts_;        // in the order of elimination
};

}  // namespace plumbline
