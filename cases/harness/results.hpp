// Result files in a results folder: one a run, one a study, one a verification.
#pragma once

#include <string>
#include <vector>

#include "cases/harness/documents.hpp"

namespace plumbline {

// 2: frames stand in a group of their own. 1: in a group /VTKHDF, which ParaView misread.
inline constexpr int results_format = 2;

class ResultsFolder {
 public:
  // Makes the folder if need be; FileError if it cannot be written to.
  explicit ResultsFolder(std::string path);

  const std::string& path() const { return path_; }

  // Writes run.file whole, or not at all.
  void write_run(const RunResult& run, const std::vector<JudgedGate>& gates, const Provenance& provenance) const;
  // The name of a run's file: case, scheme, cells and the hash of the settings.
  static std::string run_name(const RunResult& run);
  static std::string run_name(const std::string& case_name, const std::string& scheme, const Settings& settings);

  // With a table /comparator/<name> for each of the case's comparators, which run now.
  void write_study(StudyResult& study, const std::vector<JudgedGate>& gates, const Provenance& provenance) const;
  static std::string study_name(const StudyResult& study);

  // `document`: the output of verify; `entries`: its cases.
  void write_verdicts(const Json& document, const std::vector<const Case*>& entries, const std::string& tier,
                      const Provenance& provenance) const;

 private:
  std::string path_;
};

}  // namespace plumbline
