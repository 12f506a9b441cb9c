// The tables of the published method, linear between their texels and clamped to their edges, as textures are.
#pragma once

#include "baselines/table_mapping.hpp"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace vesper::baseline {

/// Red, green, blue: 680, 550 and 440 nm.
using Rgb = glm::vec3;

/// Over two coordinates.
class PlaneTable {
public:
  PlaneTable() = default;
  PlaneTable(int width, int height);
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] Rgb& operator()(int column, int row);
  [[nodiscard]] Rgb at(float x, float y) const;

private:
  int width_ = 0;
  int height_ = 0;
  std::vector<Rgb> values_;
};

/// What tables of scattering are kept in; the others are floats always.
enum class Storage { single, half };

/// Over r, mu, mu_s and nu, nu running fastest.
class ScatteringTable {
public:
  ScatteringTable(const TableSizes& sizes, Storage storage);

  /// Where in the table a view and a Sun lie, all but nu.
  struct Corners {
    std::array<std::size_t, 8> row{};
    std::array<float, 8> weight{};
    std::size_t count = 0;
  };
  [[nodiscard]] Corners corners(const ScatteringTexel& texel) const;
  [[nodiscard]] Rgb at(const Corners& corners, float nu_texel) const;
  /// The same at all texels of nu.
  [[nodiscard]] std::vector<Rgb> over_nu(const Corners& corners) const;

  [[nodiscard]] std::size_t index(int r, int mu, int mu_s, int nu) const;
  [[nodiscard]] const Rgb& operator[](std::size_t i) const { return values_[i]; }
  /// Rounds to the storage.
  void store(std::size_t i, const Rgb& value);

private:
  TableSizes sizes_;
  Storage storage_;
  std::vector<Rgb> values_;
};

/// Linear between texels.
[[nodiscard]] Rgb linear(const Rgb* texels, int size, float x);

} // namespace vesper::baseline
