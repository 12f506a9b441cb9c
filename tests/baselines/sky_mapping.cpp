#include "baselines/sky_mapping.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesper::baseline {
namespace {

using std::numbers::pi;

double share_of(int i, int count) { return static_cast<double>(i) / (count - 1); }

/// sign(x) |x|^p.
double signed_power(double x, double p) { return std::copysign(std::pow(std::abs(x), p), x); }

class Bruneton : public SkyMapping {
public:
  Bruneton(double ground_km, double top_km, const SkyMappingSize& size, bool revised)
      : SkyMapping(revised ? "Bruneton, revised" : "Bruneton 2017", size), shell_{static_cast<float>(ground_km),
                                                                                  static_cast<float>(top_km), 0.0F} {
    sizes_.scattering_r = size.heights;
    sizes_.scattering_mu = size.views;
    sizes_.scattering_mu_s = size.lights;
    sizes_.scattering_nu = size.azimuths;
    shell_.sun_span =
        revised ? sun_span_revised(shell_, -0.5F) : sun_span_2017(shell_, -0.2079117F); // 120, 102 degrees
  }

  [[nodiscard]] SkyPlace node(int height, int view, int light, int azimuth) const override {
    const ScatteringPlace place = scattering_place(
        shell_, sizes_,
        {static_cast<float>(height), static_cast<float>(view), static_cast<float>(light), static_cast<float>(azimuth)});
    const double mu = place.mu;
    const double mu_s = place.mu_s;
    const double spread = std::sqrt((1.0 - mu * mu) * (1.0 - mu_s * mu_s));
    const double nu = place.nu;
    return {static_cast<double>(place.r - shell_.ground_km), std::asin(mu), place.meets_ground, std::asin(mu_s),
            spread > 0.0 ? std::clamp((nu - mu * mu_s) / spread, -1.0, 1.0) : 1.0};
  }

  [[nodiscard]] std::array<double, 4> texel(const SkyPlace& place) const override {
    const double nu = std::sin(place.view_rad) * std::sin(place.light_rad) +
                      std::cos(place.view_rad) * std::cos(place.light_rad) * place.cos_azimuth;
    const ScatteringTexel at = scattering_texel(
        shell_, sizes_,
        {shell_.ground_km + static_cast<float>(place.height_km), static_cast<float>(std::sin(place.view_rad)),
         static_cast<float>(std::sin(place.light_rad)), static_cast<float>(nu), place.meets_ground});
    return {at.r, at.mu, at.mu_s, at.nu};
  }

private:
  Shell shell_;
  TableSizes sizes_;
};

/// Heights, lights and azimuths of Atmosphere Plus.
class AtmospherePlus : public SkyMapping {
public:
  AtmospherePlus(const std::string& name, double ground_km, double top_km, const SkyMappingSize& size, double power)
      : SkyMapping(name, size), ground_km_(ground_km), thickness_km_(top_km - ground_km), power_(power) {}

  [[nodiscard]] SkyPlace node(int height, int view, int light, int azimuth) const override {
    const double u = share_of(height, size().heights);
    const double height_km = thickness_km_ * std::pow(u, power_);
    const double v = share_of(view, size().views);
    const double cosine = std::clamp(view_cosine(v, u, height_km), -1.0, 1.0);
    return {height_km, std::asin(cosine), cosine < horizon_cosine(height_km),
            std::asin(signed_power(2.0 * share_of(light, size().lights) - 1.0, power_)),
            std::cos(pi * share_of(azimuth, size().azimuths))};
  }

  [[nodiscard]] std::array<double, 4> texel(const SkyPlace& place) const override {
    const double u = std::pow(std::clamp(place.height_km / thickness_km_, 0.0, 1.0), 1.0 / power_);
    const double w = 0.5 * (signed_power(std::sin(place.light_rad), 1.0 / power_) + 1.0);
    const double v = std::clamp(view_share(std::sin(place.view_rad), u, place.height_km, place.meets_ground), 0.0, 1.0);
    return {u * (size().heights - 1), v * (size().views - 1), w * (size().lights - 1),
            std::acos(std::clamp(place.cos_azimuth, -1.0, 1.0)) / pi * (size().azimuths - 1)};
  }

protected:
  [[nodiscard]] double horizon_cosine(double height_km) const {
    return -std::sqrt(height_km * (2.0 * ground_km_ + height_km)) / (ground_km_ + height_km);
  }
  [[nodiscard]] double power() const { return power_; }

private:
  [[nodiscard]] virtual double view_cosine(double v, double u, double height_km) const = 0;
  [[nodiscard]] virtual double view_share(double cosine, double u, double height_km, bool meets_ground) const = 0;

  double ground_km_;
  double thickness_km_;
  double power_;
};

class Power : public AtmospherePlus {
public:
  using AtmospherePlus::AtmospherePlus;

private:
  [[nodiscard]] double view_cosine(double v, double /*u*/, double /*height_km*/) const override {
    return signed_power(2.0 * v - 1.0, power());
  }
  [[nodiscard]] double view_share(double cosine, double /*u*/, double /*height_km*/,
                                  bool /*meets_ground*/) const override {
    return 0.5 * (signed_power(cosine, 1.0 / power()) + 1.0);
  }
};

class WeightedPower : public AtmospherePlus {
public:
  WeightedPower(double ground_km, double top_km, const SkyMappingSize& size)
      : AtmospherePlus("weighted power", ground_km, top_km, size, 2.0) {}

private:
  struct Weights {
    double lower, surface;
  };
  static Weights weights(double u) { return {20.0 / 32.0 * u, 4.0 / 32.0 * u + 4.0 / 32.0}; }
  static constexpr double epsilon = 1.0e-5;

  [[nodiscard]] double view_cosine(double v, double u, double height_km) const override {
    const auto [lower, surface] = weights(u);
    const double horizon = horizon_cosine(height_km);
    if (v >= lower + surface) {
      return std::pow((v - lower - surface) / (1.0 - lower - surface), power());
    }
    if (v >= surface) {
      return horizon - horizon * std::pow((v - surface) / std::max(lower, epsilon), power());
    }
    return horizon + (-1.0 - horizon) * std::pow(1.0 - v / surface, power());
  }
  [[nodiscard]] double view_share(double cosine, double u, double height_km, bool meets_ground) const override {
    const auto [lower, surface] = weights(u);
    const double horizon = horizon_cosine(height_km);
    if (meets_ground) {
      const double share = std::clamp((cosine - horizon) / (-1.0 - horizon), 0.0, 1.0);
      return surface * (1.0 - std::pow(share, 1.0 / power()));
    }
    if (cosine < 0.0) {
      const double share = std::clamp((cosine - horizon) / std::max(-horizon, epsilon), 0.0, 1.0);
      return surface + lower * std::pow(share, 1.0 / power());
    }
    return lower + surface + (1.0 - lower - surface) * std::pow(cosine, 1.0 / power());
  }
};

} // namespace

std::unique_ptr<SkyMapping> bruneton_mapping(double ground_km, double top_km, const SkyMappingSize& size,
                                             bool revised) {
  return std::make_unique<Bruneton>(ground_km, top_km, size, revised);
}

std::unique_ptr<SkyMapping> power_mapping(double ground_km, double top_km, const SkyMappingSize& size, double power) {
  return std::make_unique<Power>(power == 1.0 ? "linear" : "power", ground_km, top_km, size, power);
}

std::unique_ptr<SkyMapping> weighted_power_mapping(double ground_km, double top_km, const SkyMappingSize& size) {
  return std::make_unique<WeightedPower>(ground_km, top_km, size);
}

} // namespace vesper::baseline
