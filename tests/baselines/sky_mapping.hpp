// Ways to lay a table over the sky, to be compared at equal memory: height, view, altitude of the light and azimuth.
#pragma once

#include "baselines/table_mapping.hpp"

#include <array>
#include <memory>
#include <string>

namespace vesper::baseline {

/// Nodes of a table.
struct SkyMappingSize {
  int heights;
  int views;
  int lights;
  int azimuths;
};

/// Where light is asked for, or what a node stands for.
struct SkyPlace {
  double height_km;
  double view_rad; ///< altitude of the view
  bool meets_ground;
  double light_rad; ///< altitude of the light
  double cos_azimuth;
};

class SkyMapping {
public:
  explicit SkyMapping(std::string name, const SkyMappingSize& size) : name_(std::move(name)), size_(size) {}
  virtual ~SkyMapping() = default;
  SkyMapping(const SkyMapping&) = delete;
  SkyMapping& operator=(const SkyMapping&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const SkyMappingSize& size() const { return size_; }
  /// What a node stands for. Height and view do not depend on the others, nor does the light.
  [[nodiscard]] virtual SkyPlace node(int height, int view, int light, int azimuth) const = 0;
  /// The place among the nodes, 0 to their number less 1, of height, view, light and azimuth.
  [[nodiscard]] virtual std::array<double, 4> texel(const SkyPlace& place) const = 0;

private:
  std::string name_;
  SkyMappingSize size_;
};

/// As published by Bruneton, the Sun's altitude as in 2017 or as revised later.
[[nodiscard]] std::unique_ptr<SkyMapping> bruneton_mapping(double ground_km, double top_km, const SkyMappingSize& size,
                                                           bool revised);
/// Atmosphere Plus 3.1.2 and 3.1.3: powers of the height's share and of both cosines; linear with power 1. Azimuths at
/// equal steps, here and below.
[[nodiscard]] std::unique_ptr<SkyMapping> power_mapping(double ground_km, double top_km, const SkyMappingSize& size,
                                                        double power);
/// Atmosphere Plus 3.1.4, with the weights and powers published: the view's axis has parts for rays that rise, that
/// pass through lower air and that meet the ground.
[[nodiscard]] std::unique_ptr<SkyMapping> weighted_power_mapping(double ground_km, double top_km,
                                                                 const SkyMappingSize& size);

} // namespace vesper::baseline
