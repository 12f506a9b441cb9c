// A crew at work that anyone can check: the squares of numbers, and a failure at one of them.
#include "report/crew.hpp"

#include "vesper/base/error.hpp"

#include <cstdio>
#include <cstdlib>
#include <numeric>

/// mpi_crew_probe UNITS THREADS FAILING_UNIT: prints the sum of the squares below UNITS; a FAILING_UNIT below UNITS
/// fails instead, and one that is negative keeps a process other than the first from beginning.
int main(int argc, char** argv) {
  using namespace vesper;
  const std::unique_ptr<Crew> crew = make_crew(argc, argv);
  const auto argument = [&](int i) { return std::strtol(argv[i], nullptr, 10); }; // NOLINT(*-pointer-arithmetic)
  const long failing = argument(3);
  if (failing < 0 && !crew->leads()) {
    return 3;
  }
  std::vector<std::size_t> units(crew->leads() ? static_cast<std::size_t>(argument(1)) : 0);
  std::iota(units.begin(), units.end(), 0);
  double sum = 0.0;
  std::size_t done = 0;
  try {
    crew->work(
        units, crew->threads(static_cast<unsigned>(argument(2))),
        [&](std::size_t unit, unsigned /*threads*/) {
          if (static_cast<long>(unit) == failing) {
            throw Error(ErrorKind::input, "unit fails", {"unit.txt", "", ""});
          }
          const auto value = static_cast<double>(unit);
          return std::vector<double>{value * value};
        },
        [&](std::size_t /*unit*/, const std::vector<double>& result) {
          sum += result.at(0);
          ++done;
        });
  } catch (const Error& e) {
    std::printf("%s kind %d\n", e.what(), static_cast<int>(e.kind()));
    return 0;
  }
  if (crew->leads()) {
    std::printf("%zu units, sum %.0f\n", done, sum);
  }
  return 0;
}
