#pragma once
// One run of a study: made in a process of its own, and kept in a record that a later call takes up again.

#include "child_process.hpp"
#include "planned_run.hpp"

namespace shoreline {

/// What a run left behind; all that tables and pictures use.
struct RunResult {
  bool completed = false;
  std::string reason;                                 ///< why not
  Json summary;                                       ///< of the first repeat; null where there is none
  Json quantities;                                    ///< vectors of numbers by name, as compared with a reference
  std::vector<double> seconds;                        ///< of each repeat, without what only tells of the run
  std::map<std::string, std::vector<double>> phases;  ///< [s] of each repeat
  double wall = 0.0;                                  ///< of all repeats, with everything [s]
  std::filesystem::path folder;                       ///< case.json and record.json
};

/// Runs cases for a study and remembers them.
class Runner {
 public:
  /// @param folder   runs/ of the study's output; made where it is missing, and locked while this object lives
  /// @throws OutputError if the folder cannot be written, or another study holds it
  Runner(const Study& study, std::filesystem::path program, std::filesystem::path folder);
  ~Runner();
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  /// The result on record, if the case has been run as it is now.
  [[nodiscard]] std::optional<RunResult> recorded(const PreparedCase& prepared, int repeat) const;

  /// The result on record, or else that of so many runs, which is then on record.
  [[nodiscard]] RunResult result_of(const PreparedCase& prepared, int repeat);

 private:
  [[nodiscard]] Json identity_of(const PreparedCase& prepared, int repeat) const;
  [[nodiscard]] std::filesystem::path folder_of(const Json& identity) const;
  void warm_up(const std::filesystem::path& folder);
  void add_run(bool first, RunResult& result) const;
  [[nodiscard]] ChildOutcome run_once(const std::filesystem::path& folder) const;

  const Study& study_;
  std::filesystem::path program_;
  std::filesystem::path folder_;
  int lock_ = -1;
  bool warm_ = false;
};

}  // namespace shoreline
