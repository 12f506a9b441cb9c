// The crew of a program without MPI.
#include "report/crew.hpp"

namespace vesper {
namespace {

class LocalCrew : public Crew {
public:
  [[nodiscard]] bool leads() const override { return true; }
  [[nodiscard]] unsigned threads(unsigned asked) const override { return threads_alone(asked); }
  void work(const std::vector<std::size_t>& units, unsigned threads, const Work& work, const Done& done) override {
    work_alone(units, threads, work, done);
  }
};

} // namespace

std::unique_ptr<Crew> make_crew(int& /*argc*/, char**& /*argv*/) { return std::make_unique<LocalCrew>(); }

} // namespace vesper
