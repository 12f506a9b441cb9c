// What a long calculation has found so far, kept beside its output so that it can be resumed.
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace vesper {

/// A text file that names its request in the first line and holds a finished unit in each further one, written out at
/// once. A last line that was cut off is as if it were not there.
class PartialResults {
public:
  /// Takes up what the file at `path` holds, or begins it.
  /// \param request text that tells requests apart, without line breaks
  /// \param units  units are numbered below it
  /// \param values numbers that a unit has
  /// Throws Error(input) for a file of another request, Error(file) when it cannot be read or written.
  PartialResults(std::filesystem::path path, const std::string& request, std::size_t units, std::size_t values);

  [[nodiscard]] const std::map<std::size_t, std::vector<double>>& finished() const { return finished_; }
  /// Throws Error(file).
  void add(std::size_t unit, const std::vector<double>& values);

private:
  std::filesystem::path path_;
  std::ofstream file_;
  std::map<std::size_t, std::vector<double>> finished_;
};

} // namespace vesper
