#include "vesper/atmosphere/light_field_solution.hpp"

#include "vesper/base/worker_pool.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vesper {
namespace {

/// Of what is dark. Smaller numbers would leave the range of a float.
constexpr float darkest = 1.0e-36F;
/// Mean radiance, 1/sr, below which nobody asks whether orders are missing: a hundredth of that with a Sun at -18
/// degrees.
constexpr float dimmest = 1.0e-11F;

f32::LightSums operator+(const f32::LightSums& a, const f32::LightSums& b) {
  return {a.all + b.all, a.xx + b.xx, a.zz + b.zz, a.xz + b.xz, a.level + b.level};
}

/// The tables of the light of all orders so far.
void tabulate(const LightFieldModel& model, const LightFieldSums& once, const LightFieldSums& later, unsigned threads,
              LightFieldTables& tables) {
  const std::size_t blocks = model.blocks();
  const auto log = [](Lanes light) { return log2(max(light, Lanes(darkest))); };
  parallel_for(
      model.nodes(), 16,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin * blocks; k < end * blocks; ++k) {
          const f32::LightSums sum = once.moments[k] + later.moments[k];
          const Lanes all = max(sum.all, Lanes(darkest));
          Lanes* field = &tables.field[k / blocks * f32::field_moments * blocks + k % blocks];
          field[0] = log2(all);
          field[blocks] = sum.xx / all;
          field[2 * blocks] = sum.zz / all;
          field[3 * blocks] = sum.xz / all;
          if (k < tables.ground.size()) {
            tables.ground[k] = log(f32::sphere_sr * sum.level);
          }
        }
      },
      threads);
  parallel_for(
      tables.sources.size(), 1024,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
          tables.sources[k] = log(once.sources[k] + later.sources[k]);
        }
      },
      threads);
}

/// Estimates at each node what the orders to come add: they fall in a nearly constant ratio.
class Tail {
public:
  explicit Tail(const LightFieldModel& model)
      : last_(model.nodes() * model.blocks()), all_(last_.size()), factors_(last_.size()) {}

  /// Takes what the later orders amount to, without and with the last.
  /// \return the share of all light by which the estimate may still be wrong
  double estimate(const LightFieldSums& once, const LightFieldSums& before, const LightFieldSums& later) {
    constexpr float steepest = 0.95F;
    float error = 0.0F;
    for (std::size_t k = 0; k < last_.size(); ++k) {
      const Lanes step = later.moments[k].all - before.moments[k].all;
      const Lanes sum = once.moments[k].all + later.moments[k].all;
      for (std::size_t i = 0; i < Lanes::size; ++i) {
        const float ratio = last_[k][i] > 0.0F ? std::clamp(step[i] / last_[k][i], 0.0F, steepest) : steepest;
        factors_[k].values[i] = ratio / (1.0F - ratio);
        const float all = sum[i] + step[i] * factors_[k][i];
        if (all > dimmest) {
          error = std::max(error, std::abs(all - all_[k][i]) / all * factors_[k][i]);
        }
        all_[k].values[i] = all;
      }
      last_[k] = step;
    }
    return static_cast<double>(error);
  }

  /// Adds the estimate.
  void extend(const LightFieldModel& model, const LightFieldSums& before, LightFieldSums& later) const {
    const std::size_t blocks = model.blocks();
    for (std::size_t k = 0; k < factors_.size(); ++k) {
      const f32::LightSums& old = before.moments[k];
      f32::LightSums& sum = later.moments[k];
      const auto extended = [&](Lanes without, Lanes with) { return with + factors_[k] * (with - without); };
      sum = {extended(old.all, sum.all), extended(old.xx, sum.xx), extended(old.zz, sum.zz), extended(old.xz, sum.xz),
             extended(old.level, sum.level)};
    }
    for (std::size_t k = 0; k < later.sources.size(); ++k) {
      const std::size_t node = k / (LightFieldModel::source_directions * blocks);
      later.sources[k] += factors_[node * blocks + k % blocks] * (later.sources[k] - before.sources[k]);
    }
  }

private:
  std::vector<Lanes> last_;    ///< what the last order added to the mean radiance
  std::vector<Lanes> all_;     ///< estimate of it in all orders
  std::vector<Lanes> factors_; ///< of the last order, in the orders to come
};

} // namespace

LightFieldSolution solve_light_field(const LightFieldModel& model, LightGatherer& gatherer, unsigned threads) {
  const LightFieldSize& size = model.size();
  LightFieldSums once(model);
  LightFieldSums before(model); ///< all orders but the first and the last
  LightFieldSums later(model);  ///< all but the first
  gatherer.gather_once(once);
  LightFieldSolution solution;
  LightFieldTables& tables = solution.tables;
  tables.field.resize(once.moments.size() * f32::field_moments);
  tables.sources.resize(once.sources.size());
  tables.ground.resize(model.angles() * model.blocks());
  tabulate(model, once, later, threads, tables);
  Tail tail(model);
  while (solution.orders < size.most_orders && solution.rest > size.rest) {
    std::swap(before, later);
    gatherer.gather_again(tables, later);
    solution.rest = tail.estimate(once, before, later);
    ++solution.orders;
    tabulate(model, once, later, threads, tables);
  }
  tail.extend(model, before, later);
  tabulate(model, once, later, threads, tables);
  return solution;
}

} // namespace vesper
