#include "report/crew.hpp"

#include "vesper/base/worker_pool.hpp"

#include <algorithm>
#include <mutex>
#include <thread>

namespace vesper {

unsigned threads_alone(unsigned asked) { return asked > 0 ? asked : std::max(1U, std::thread::hardware_concurrency()); }

void work_alone(const std::vector<std::size_t>& units, unsigned threads, const Crew::Work& work,
                const Crew::Done& done) {
  const ThreadPlan plan = plan_threads(units.size(), threads);
  std::mutex handing_over;
  parallel_for(
      units.size(), 1,
      [&](std::size_t begin, std::size_t /*end*/) {
        const std::vector<double> result = work(units[begin], plan.for_each);
        const std::scoped_lock lock(handing_over);
        done(units[begin], result);
      },
      plan.at_once);
}

} // namespace vesper
