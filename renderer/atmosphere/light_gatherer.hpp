// One order of scattering at all nodes of a light field.
#pragma once

#include "vesper/atmosphere/light_gathering.hpp"

#include <vector>

namespace vesper {

/// What light amounts to at the nodes, in plain sums.
struct LightFieldSums {
  std::vector<f32::LightSums> moments; ///< by node, block
  std::vector<Lanes> sources;          ///< by node below source_heights, direction, block

  explicit LightFieldSums(const LightFieldModel& model);
};

/// Gathers light from all directions at each node. Both calls fill all of the sums.
class LightGatherer {
public:
  LightGatherer() = default;
  LightGatherer(const LightGatherer&) = delete;
  LightGatherer& operator=(const LightGatherer&) = delete;
  virtual ~LightGatherer() = default;

  /// Light scattered or reflected once.
  virtual void gather_once(LightFieldSums& sums) = 0;
  /// Light that has been scattered or reflected more often, from that of the tables.
  virtual void gather_again(const LightFieldTables& tables, LightFieldSums& sums) = 0;
};

/// On the processor's cores. The result does not depend on the number of threads.
class ThreadedLightGatherer final : public LightGatherer {
public:
  /// \param model outlives this object
  ThreadedLightGatherer(const LightFieldModel& model, unsigned threads) : model_(model), threads_(threads) {}

  void gather_once(LightFieldSums& sums) override;
  void gather_again(const LightFieldTables& tables, LightFieldSums& sums) override;

private:
  template <class Gather> void for_each_node(const LightRule& rule, LightFieldSums& sums, const Gather& gather) const;

  const LightFieldModel& model_;
  unsigned threads_;
  LightRule later_rule_; ///< made when first asked for
};

} // namespace vesper
