// Result files in a results folder: one a run, one a study, one a verification.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/harness/results/documents.hpp"
#include "cases/harness/results/restore.hpp"

namespace plumbline {

// 2: frames stand in a group of their own. 1: in a group /VTKHDF, which ParaView misread.
inline constexpr int results_format = 2;

class ResultsFolder {
 public:
  // Makes the folder if need be; FileError if it cannot be written to.
  explicit ResultsFolder(std::string path);

  const std::string& path() const { return path_; }

  // Writes run.file whole, or not at all.
  void write_run(const RunResult& run, const std::vector<JudgedGate>& gates, const Provenance& provenance,
                 const Making& making = {}) const;
  // What a run's file says of how it was made; nothing if it is of an older version. FileError if it is damaged, newer or
  // not there.
  std::optional<Stored> read_stored(const std::string& file) const;
  // The run of a file, bit for bit but for its frames, if the code of this fingerprint made it. FileError likewise.
  std::optional<RunResult> read_run(const std::string& file, const std::string& fingerprint) const;
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
