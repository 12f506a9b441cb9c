// A table of the sky over any mapping, filled from the light field and linear between its nodes.
#pragma once

#include "baselines/sky_mapping.hpp"

#include "vesper/atmosphere/light_field.hpp"

#include <glm/vec4.hpp>

#include <functional>
#include <vector>

namespace vesper::baseline {

/// Between nodes light is linear, or its logarithm.
enum class Between { values, logarithms };

class MappedSky {
public:
  using Responses = std::function<glm::vec4(const LightField::Spectrum&)>;

  /// Light over the phase functions of what scattered it, as published: once-scattered light of aerosol, and the rest
  /// over Rayleigh's.
  MappedSky(const SkyMapping& mapping, const LightField& field, const SampledAir& air, const Responses& responses,
            std::function<double(double cos_angle)> aerosol_phase);

  [[nodiscard]] glm::vec4 light(const SkyPlace& place, Between between) const;

private:
  const SkyMapping& mapping_;
  std::function<double(double)> aerosol_phase_;
  std::vector<glm::vec4> aerosol_;
  std::vector<glm::vec4> other_;
};

/// A ray of the field for a place, brought to its side of the horizon.
[[nodiscard]] LightField::ViewRay view_ray(const LightField& field, const SampledAir& air, const SkyPlace& place);

} // namespace vesper::baseline
