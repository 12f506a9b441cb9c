// Who does long work: the threads of this process, and those of others under mpirun.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace vesper {

/// The processes and threads among which independent units of work are shared out. What a unit results in must not
/// depend on who does it.
class Crew {
public:
  /// \param threads to work on this unit with
  using Work = std::function<std::vector<double>(std::size_t unit, unsigned threads)>;
  using Done = std::function<void(std::size_t unit, const std::vector<double>& result)>;

  Crew() = default;
  virtual ~Crew() = default;
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  /// One process leads: it reads what was done before, writes, and speaks to the user. The others say nothing.
  [[nodiscard]] virtual bool leads() const = 0;

  /// How many threads this process may take: as many as asked for, and for 0 one per core of a process alone, one of
  /// each of several.
  [[nodiscard]] virtual unsigned threads(unsigned asked) const = 0;

  /// To be called once, in all processes: does `units`, and in the leading process hands each result to `done`, one at
  /// a time, in any order. The first failure anywhere is thrown there, after all have stopped.
  /// \param units  those of the leading process count
  /// \param threads of each process, at least 1
  virtual void work(const std::vector<std::size_t>& units, unsigned threads, const Work& work, const Done& done) = 0;
};

/// The crew of this program (local_crew.cpp or mpi_crew.cpp), to be made before the command line is read and to be kept
/// until the program ends.
[[nodiscard]] std::unique_ptr<Crew> make_crew(int& argc, char**& argv);

/// How the threads of a process share its part of the work: each its own units, or all together at one when there are
/// fewer units than threads.
struct ThreadPlan {
  unsigned at_once = 1; ///< units
  unsigned for_each = 1;
};
/// \param threads at least 1
[[nodiscard]] inline ThreadPlan plan_threads(std::size_t units, unsigned threads) {
  return units < threads ? ThreadPlan{1, threads} : ThreadPlan{threads, 1};
}

/// One per core for 0.
[[nodiscard]] unsigned threads_alone(unsigned asked);
/// The work of a process alone.
void work_alone(const std::vector<std::size_t>& units, unsigned threads, const Crew::Work& work,
                const Crew::Done& done);

} // namespace vesper
