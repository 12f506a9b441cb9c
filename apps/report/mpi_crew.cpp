// The crew of a program that mpirun starts in several processes: the first leads, hands out units and works itself.
#include "report/crew.hpp"

#include "vesper/base/error.hpp"

#include <mpi.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <mutex>
#include <string>
#include <thread>

namespace vesper {
namespace {

constexpr int leader = 0;
constexpr std::int64_t no_unit = -1;

/// What a thread of another process tells the leader. `request` and `result` are answered with the next unit.
enum Tag : int { request, result, failure, answer };

class MpiCrew : public Crew {
public:
  MpiCrew(int& argc, char**& argv) {
    MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &thread_level_);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    if (rank_ != leader) {
      // What all processes have to say, the leader says. Failures while working are sent to it.
      static_cast<void>(std::freopen("/dev/null", "w", stdout));
      static_cast<void>(std::freopen("/dev/null", "w", stderr));
    }
  }
  ~MpiCrew() override {
    if (!begun_) {
      static_cast<void>(first_unready(false));
    }
    MPI_Finalize();
  }
  MpiCrew(const MpiCrew&) = delete;
  MpiCrew& operator=(const MpiCrew&) = delete;

  [[nodiscard]] bool leads() const override { return rank_ == leader; }

  [[nodiscard]] unsigned threads(unsigned asked) const override {
    return size_ == 1 ? threads_alone(asked) : std::max(asked, 1U);
  }

  void work(const std::vector<std::size_t>& units, unsigned threads, const Work& work, const Done& done) override {
    begun_ = true;
    if (size_ > 1 && thread_level_ < MPI_THREAD_SERIALIZED) {
      throw Error(ErrorKind::file, "this MPI lets no threads speak",
                  {"", "", "Start one process, or install an MPI with MPI_THREAD_SERIALIZED"});
    }
    if (const int unready = first_unready(true); unready < size_) {
      if (!leads()) {
        return;
      }
      throw Error(ErrorKind::file, fmt::format("process {} of {} cannot begin the work", unready, size_),
                  {"", "", "See that all processes find the same files and have enough memory"});
    }
    if (size_ == 1) {
      work_alone(units, threads, work, done);
      return;
    }
    std::uint64_t count = units.size();
    MPI_Bcast(&count, 1, MPI_UINT64_T, leader, MPI_COMM_WORLD);
    const auto processes = static_cast<std::size_t>(size_);
    const ThreadPlan plan = plan_threads((count + processes - 1) / processes, threads);
    const int followers_here = leads() ? 0 : static_cast<int>(plan.at_once);
    int followers = 0;
    MPI_Allreduce(&followers_here, &followers, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
    if (leads()) {
      lead(units, plan, followers, work, done);
    } else {
      follow(plan, work);
    }
  }

private:
  /// The lowest rank that is not ready, or the number of processes. All of them must call it.
  [[nodiscard]] int first_unready(bool ready) const {
    const int here = ready ? size_ : rank_;
    int first = here;
    MPI_Allreduce(&here, &first, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
    return first;
  }

  /// Only the calling thread of the leader speaks to other processes; the threads that it starts work.
  void lead(const std::vector<std::size_t>& units, const ThreadPlan& plan, int followers, const Work& work,
            const Done& done) const {
    std::atomic<std::size_t> next{0};
    std::mutex handing_over;
    std::exception_ptr failed;
    const auto next_unit = [&] {
      const std::size_t i = next++;
      return i < units.size() ? static_cast<std::int64_t>(units[i]) : no_unit;
    };
    const auto hand_over = [&](std::int64_t unit, const std::vector<double>& values) {
      const std::scoped_lock lock(handing_over);
      if (!failed) {
        done(static_cast<std::size_t>(unit), values);
      }
    };
    const auto give_up = [&](const std::exception_ptr& why) {
      const std::scoped_lock lock(handing_over);
      failed = failed ? failed : why;
      next = units.size();
    };
    std::vector<std::jthread> threads;
    for (unsigned i = 0; i < plan.at_once; ++i) {
      threads.emplace_back([&] {
        try {
          for (std::int64_t unit = next_unit(); unit != no_unit; unit = next_unit()) {
            hand_over(unit, work(static_cast<std::size_t>(unit), plan.for_each));
          }
        } catch (...) {
          give_up(std::current_exception());
        }
      });
    }
    while (followers > 0) {
      int there = 0;
      MPI_Status status;
      MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
      if (there == 0) {
        // Waiting within MPI would take a core from the threads that work.
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        continue;
      }
      if (status.MPI_TAG == failure) {
        give_up(receive_failure(status));
        --followers;
        continue;
      }
      std::vector<double> values = receive<double>(status, MPI_DOUBLE);
      if (status.MPI_TAG == result) {
        const auto unit = static_cast<std::int64_t>(values.back());
        values.pop_back();
        try {
          hand_over(unit, values);
        } catch (...) {
          give_up(std::current_exception());
        }
      }
      const std::int64_t unit = next_unit();
      MPI_Send(&unit, 1, MPI_INT64_T, status.MPI_SOURCE, answer, MPI_COMM_WORLD);
      followers -= unit == no_unit ? 1 : 0;
    }
    threads.clear();
    if (failed) {
      std::rethrow_exception(failed);
    }
  }

  static void follow(const ThreadPlan& plan, const Work& work) {
    std::mutex speaking;
    const auto ask = [&](Tag tag, const std::vector<double>& values) {
      const std::scoped_lock lock(speaking);
      MPI_Send(values.data(), static_cast<int>(values.size()), MPI_DOUBLE, leader, tag, MPI_COMM_WORLD);
      std::int64_t unit = no_unit;
      MPI_Recv(&unit, 1, MPI_INT64_T, leader, answer, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
      return unit;
    };
    const auto confess = [&](ErrorKind kind, const std::string& text) {
      const std::string message = std::to_string(static_cast<int>(kind)) + text;
      const std::scoped_lock lock(speaking);
      MPI_Send(message.data(), static_cast<int>(message.size()), MPI_CHAR, leader, failure, MPI_COMM_WORLD);
    };
    std::vector<std::jthread> threads;
    for (unsigned i = 0; i < plan.at_once; ++i) {
      threads.emplace_back([&] {
        try {
          std::int64_t unit = ask(request, {});
          while (unit != no_unit) {
            std::vector<double> values = work(static_cast<std::size_t>(unit), plan.for_each);
            values.push_back(static_cast<double>(unit)); // exact below 2^53
            unit = ask(result, values);
          }
        } catch (const Error& e) {
          confess(e.kind(), e.what());
        } catch (const std::exception& e) {
          confess(ErrorKind::file, e.what());
        }
      });
    }
  }

  template <class T> [[nodiscard]] static std::vector<T> receive(const MPI_Status& status, MPI_Datatype type) {
    int count = 0;
    MPI_Get_count(&status, type, &count);
    std::vector<T> values(static_cast<std::size_t>(count));
    MPI_Recv(values.data(), count, type, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return values;
  }

  [[nodiscard]] static std::exception_ptr receive_failure(const MPI_Status& status) {
    const std::vector<char> text = receive<char>(status, MPI_CHAR);
    const auto kind = static_cast<ErrorKind>(text.at(0) - '0');
    return std::make_exception_ptr(
        Error(kind, fmt::format("process {}: {}", status.MPI_SOURCE, std::string(text.begin() + 1, text.end()))));
  }

  int thread_level_ = MPI_THREAD_SINGLE;
  int rank_ = 0;
  int size_ = 1;
  bool begun_ = false;
};

} // namespace

std::unique_ptr<Crew> make_crew(int& argc, char**& argv) { return std::make_unique<MpiCrew>(argc, argv); }

} // namespace vesper
