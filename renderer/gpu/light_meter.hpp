// Histograms of a picture's light, made on the GPU.
#pragma once

#include "vesper/gpu/display_mapping.hpp"
#include "vesper/gpu/eye_optics.hpp"
#include "vesper/gpu/program.hpp"
#include "vesper/gpu/shader_library.hpp"
#include "vesper/plan/light_metering.hpp"

#include <string>
#include <vector>

namespace vesper::gpu {

class LightMeter {
public:
  /// The library must outlive the meter.
  explicit LightMeter(const ShaderLibrary& library);

  /// Begins a picture.
  void start(const View& view, Metering metering);
  /// Takes in the extended light of a strip as it is in the scene.
  void add(const StripLight& light);
  /// Takes in that of a whole picture as an eye has seen it.
  void add(const EyeOptics& optics);
  /// What all strips since start() hold. Waits for the GPU.
  [[nodiscard]] LightHistogram histogram();

private:
  void add_cells(const std::vector<std::string>& defines, const Strip& strip);

  ProgramVariants cell_programs_;
  ProgramHandle histogram_program_;
  View view_;
  Metering metering_ = Metering::whole_field;
  std::vector<std::string> defines_; ///< that the picture asks of meter_cells.comp
  MeteringGrid grid_;
  Buffer cells_;
  Buffer bins_;
  double counts_ = 0.0;
};

} // namespace vesper::gpu
