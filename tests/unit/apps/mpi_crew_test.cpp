// Work that several processes share out.
#include "support/command_line_test.hpp"

#include <gtest/gtest.h>

namespace vesper {
namespace {

using test::CommandResult;

class MpiCrew : public test::CommandLineTest {
protected:
  MpiCrew() : CommandLineTest("mpi_crew_probe") {}

  /// As root, on this host alone, however few cores it has.
  [[nodiscard]] CommandResult run_in(int processes, const std::string& arguments) const {
    return run("1 1 1", "export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_plm=isolated "
                        "OMPI_MCA_btl_vader_single_copy_mechanism=none ASAN_OPTIONS=detect_leaks=0; timeout 60 "
                        "'" VESPER_MPIRUN "' --oversubscribe -n " +
                            std::to_string(processes) + " '" VESPER_BIN "/mpi_crew_probe' " + arguments +
                            " && exit 0; exit 1");
  }
};

TEST_F(MpiCrew, DoesEachUnitOnce) {
  // The sum of the squares below n is (n - 1) n (2 n - 1) / 6.
  for (const auto& [processes, arguments] :
       {std::pair{1, "1000 2 5000"}, std::pair{2, "1000 1 5000"}, std::pair{3, "1000 3 5000"}}) {
    const CommandResult result = run_in(processes, arguments);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.out, "1000 units, sum 332833500\n") << processes;
  }
  EXPECT_EQ(run_in(3, "1 2 5000").out, "1 units, sum 0\n");
  EXPECT_EQ(run_in(3, "0 2 5000").out, "0 units, sum 0\n");
}

TEST_F(MpiCrew, AFailureAnywhereReachesTheFirst) {
  for (const char* arguments : {"1000 1 0", "1000 2 777", "1000 1 999"}) {
    const CommandResult result = run_in(3, arguments);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("unit.txt: unit fails"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("kind 1\n"), std::string::npos) << result.out; // ErrorKind::input
  }
}

TEST_F(MpiCrew, AProcessThatCannotBeginIsNamed) {
  const CommandResult result = run_in(2, "10 1 -1");
  EXPECT_NE(result.out.find("process 1 of 2 cannot begin the work"), std::string::npos) << result.out << result.err;
}

} // namespace
} // namespace vesper
