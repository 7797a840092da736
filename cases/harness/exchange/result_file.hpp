// The final state that another program hands in: reports/docs/how-to/score-another-code.md says what it holds.
#pragma once

#include <string>
#include <vector>

#include "cases/harness/exchange/final_state.hpp"
#include "cases/harness/exchange/foreign_file.hpp"

namespace plumbline {

class ResultFile {
 public:
  // Reads the attributes; patience as of ForeignFile. Throws FileError for a file that is none of these, naming what is missing
  // or wrong.
  explicit ResultFile(const std::string& path, double patience = default_patience);

  const std::string& path() const { return reader_.path(); }
  std::string case_name, program, version;
  std::string start;    // start_id of the export
  std::string problem;  // problem_id of the export, if the program handed it on
  int cells = 0;        // > 0
  double time = 0;      // s
  long steps = 0;       // 0: not said
  double wall_s = 0;    // 0: not said

  // The points of each body of the scene. Throws FileError naming dataset and value: missing, of another shape, not
  // finite, out of range; of solids other points than the scene's.
  std::vector<HandedIn> points(const Scene& scene) const;

 private:
  HandedIn points_of(const Body& body, const GridSpec& grid) const;
  ForeignFile reader_;
};

}  // namespace plumbline
