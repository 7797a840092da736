// The folder of a scoreboard: exported starts, and the final states of each program. reports/docs/how-to/score-another-code.md shows it.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace plumbline {

// How an adapter's run on one start ended, as the file beside its result says.
struct AdapterEnd {
  enum class How { written, failed, late };
  How how = How::written;
  std::string reason;  // empty where the result is written
  double seconds = 0;  // wall time, its own start-up included
};

class ScoreFolder {
 public:
  // Throws UsageError for a path that is no folder, or one without starts; FileError for one that cannot be read.
  explicit ScoreFolder(std::string path);

  const std::string& path() const { return path_; }
  // Names of the starts, "sod-100.h5", in order.
  const std::vector<std::string>& starts() const { return starts_; }
  // Names of the programs that have a folder, in order. FileError if they cannot be read.
  std::vector<std::string> programs() const;
  // Results of a program (their names) that belong to no start. FileError likewise.
  std::vector<std::string> strays(const std::string& program) const;

  std::string start(const std::string& name) const;
  std::string result(const std::string& program, const std::string& start) const;
  std::string log(const std::string& program, const std::string& start) const;

  // Makes the folder of a program if need be. FileError.
  void add_program(const std::string& program) const;
  // Removes result, log and end of an earlier run. FileError.
  void clear(const std::string& program, const std::string& start) const;
  // FileError; nothing is read where no adapter was run.
  void write_end(const std::string& program, const std::string& start, const AdapterEnd& end) const;
  std::optional<AdapterEnd> read_end(const std::string& program, const std::string& start) const;

 private:
  std::string end(const std::string& program, const std::string& start) const;

  std::string path_;
  std::vector<std::string> starts_;
};

}  // namespace plumbline
