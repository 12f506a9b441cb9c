#include "baselines/tables.hpp"

#include <glm/gtc/packing.hpp>

#include <algorithm>

namespace vesper::baseline {
namespace {

std::size_t count(int value) { return static_cast<std::size_t>(value); }
float half_rounded(float x) { return glm::unpackHalf1x16(glm::packHalf1x16(x)); }

/// The texel below a place, with one above it, and how far the place is on the way to that.
struct Between {
  int low;
  float share;
};
Between between(float x, int size) {
  const float clamped = std::clamp(x, 0.0F, static_cast<float>(size - 1));
  const int low = std::min(static_cast<int>(clamped), size - 2);
  return {low, clamped - static_cast<float>(low)};
}

} // namespace

Rgb linear(const Rgb* texels, int size, float x) {
  const Between place = between(x, size);
  return (1.0F - place.share) * texels[place.low] + place.share * texels[place.low + 1];
}

PlaneTable::PlaneTable(int width, int height)
    : width_(width), height_(height), values_(count(width) * count(height), Rgb(0.0F)) {}

Rgb& PlaneTable::operator()(int column, int row) { return values_[count(row) * count(width_) + count(column)]; }

Rgb PlaneTable::at(float x, float y) const {
  const Between row = between(y, height_);
  const Rgb* low = &values_[count(row.low) * count(width_)];
  return (1.0F - row.share) * linear(low, width_, x) + row.share * linear(low + width_, width_, x);
}

ScatteringTable::ScatteringTable(const TableSizes& sizes, Storage storage)
    : sizes_(sizes), storage_(storage), values_(count(sizes.scattering_r) * count(sizes.scattering_mu) *
                                                    count(sizes.scattering_mu_s) * count(sizes.scattering_nu),
                                                Rgb(0.0F)) {}

std::size_t ScatteringTable::index(int r, int mu, int mu_s, int nu) const {
  const std::size_t view = count(r) * count(sizes_.scattering_mu) + count(mu);
  return (view * count(sizes_.scattering_mu_s) + count(mu_s)) * count(sizes_.scattering_nu) + count(nu);
}

void ScatteringTable::store(std::size_t i, const Rgb& value) {
  values_[i] =
      storage_ == Storage::half ? Rgb(half_rounded(value.x), half_rounded(value.y), half_rounded(value.z)) : value;
}

ScatteringTable::Corners ScatteringTable::corners(const ScatteringTexel& texel) const {
  const Between r = between(texel.r, sizes_.scattering_r);
  const Between mu = between(texel.mu, sizes_.scattering_mu);
  const Between mu_s = between(texel.mu_s, sizes_.scattering_mu_s);
  Corners result;
  for (int corner = 0; corner < 8; ++corner) {
    const int i = corner / 4;
    const int j = corner / 2 % 2;
    const int k = corner % 2;
    const float weight = (i != 0 ? r.share : 1.0F - r.share) * (j != 0 ? mu.share : 1.0F - mu.share) *
                         (k != 0 ? mu_s.share : 1.0F - mu_s.share);
    if (weight > 0.0F) {
      result.row[result.count] = index(r.low + i, mu.low + j, mu_s.low + k, 0);
      result.weight[result.count++] = weight;
    }
  }
  return result;
}

Rgb ScatteringTable::at(const Corners& corners, float nu_texel) const {
  Rgb sum(0.0F);
  for (std::size_t i = 0; i < corners.count; ++i) {
    sum += corners.weight[i] * linear(&values_[corners.row[i]], sizes_.scattering_nu, nu_texel);
  }
  return sum;
}

std::vector<Rgb> ScatteringTable::over_nu(const Corners& corners) const {
  std::vector<Rgb> sums(count(sizes_.scattering_nu), Rgb(0.0F));
  for (std::size_t i = 0; i < corners.count; ++i) {
    for (std::size_t nu = 0; nu < sums.size(); ++nu) {
      sums[nu] += corners.weight[i] * values_[corners.row[i] + nu];
    }
  }
  return sums;
}

} // namespace vesper::baseline
