// A light field's orders of scattering on the GPU.
#pragma once

#include "vesper/atmosphere/light_gatherer.hpp"
#include "vesper/gpu/objects.hpp"
#include "vesper/gpu/program.hpp"

namespace vesper::gpu {

/// Gathers by compute shaders what ThreadedLightGatherer does on the processor, from the same text of
/// shaders/lib/light_field.glsl; the two agree within single precision's rounding. The rays' steps are made on the
/// processor.
class GpuLightGatherer final : public LightGatherer {
public:
  /// \param model outlives this object
  /// Throws Error(gpu) where the driver's buffer textures are too small for the field.
  GpuLightGatherer(const ShaderLibrary& library, const LightFieldModel& model);

  void gather_once(LightFieldSums& sums) override;
  void gather_again(const LightFieldTables& tables, LightFieldSums& sums) override;

private:
  /// A rule's directions and rays in buffers.
  struct Rule {
    explicit Rule(const LightFieldModel& model, const LightRule& rule);

    int directions;
    int zeniths;
    Buffer directions_from;
    Buffer rays;
    Buffer steps;
    Buffer weights;
    Buffer ground_weights;
    Buffer phase_matrix;
    Buffer radiances;
  };
  /// A table that shaders read.
  struct Table {
    Buffer buffer;
    Texture texture;
  };

  [[nodiscard]] static Table make_table(std::size_t bytes, int channels);
  void gather(const ProgramHandle& program, const Rule& rule, LightFieldSums& sums) const;

  const LightFieldModel& model_;
  ProgramHandle once_;
  ProgramHandle again_;
  ProgramHandle sum_;
  Rule first_rule_;
  Rule later_rule_;
  Buffer cosines_;
  Buffer parameters_;
  Buffer second_moments_;
  Buffer moments_;
  Buffer sources_;
  Table places_;
  Table depths_;
  Table field_table_;
  Table source_table_;
  Table ground_table_;
};

} // namespace vesper::gpu
