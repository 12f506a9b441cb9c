// Where on the sky the pixels of a FITS picture lie.
#pragma once

#include "vesper/base/vector.hpp"

#include <memory>
#include <optional>
#include <span>
#include <string>

namespace vesper {

/// The celestial coordinates of a picture, from its header by the FITS standard (Greisen and Calabretta 2002, A&A 395,
/// 1061; Calabretta and Greisen 2002, A&A 395, 1077) through WCSLIB: any of its projections, on galactic,
/// supergalactic, ecliptic or equatorial axes (ICRS, FK5 of any equinox, FK4 of B1950 without E-terms, below 0.4"); CD,
/// PC or CDELT; defaults where keywords are missing.
///
/// Pixel places are in pixels from the outer corner of the first pixel, whose centre is at (0.5, 0.5). Directions are
/// unit vectors of ICRS axes.
class PictureWcs {
public:
  /// \param cards the header, 80 characters a card
  /// \param file,hdu for messages: "sky.fits", "HDU 1"
  /// Throws Error(input), naming the keyword, for a header without celestial axes, an unknown projection or frame, a
  /// value that is no number, a singular matrix or celestial axes other than the first two.
  PictureWcs(const std::string& cards, const std::string& file, const std::string& hdu);
  /// Throws Error(input) where the picture, `width` by `height`, continues beyond both poles: its axes are swapped or
  /// its scale is wrong.
  void require_on_sphere(int width, int height);

  /// A copy computes on its own: one for each thread.
  PictureWcs(const PictureWcs& other);
  PictureWcs(PictureWcs&&) noexcept;
  PictureWcs& operator=(const PictureWcs&) = delete;
  PictureWcs& operator=(PictureWcs&&) = delete;
  ~PictureWcs();

  /// The directions of pixel places; the zero vector for places that are not on the sky. Cylindrical projections go on
  /// beyond 180 degrees from their middle, where they repeat themselves.
  void directions(std::span<const Vec2> places, std::span<Vec3> out);
  [[nodiscard]] Vec3 direction(const Vec2& place);
  /// The place of a direction, which may lie outside the picture; none where the projection has no place for it.
  [[nodiscard]] std::optional<Vec2> place(const Vec3& direction);
  /// The step in pixels after which a cylindrical projection repeats itself; none for others.
  [[nodiscard]] std::optional<Vec2> period() const { return period_; }

  /// "GLON-CAR, galactic": for reports.
  [[nodiscard]] const std::string& description() const { return description_; }

private:
  struct Parameters;
  std::unique_ptr<Parameters> wcs_;
  Mat3 icrs_from_axes_{1.0};
  std::optional<Vec2> period_;
  std::string description_;
  std::string file_, hdu_;
};

/// The header of a picture that shows the whole sky, longitude across and latitude up, from -90 to 90 degrees.
///
/// \param frame      galactic, icrs, fk5 or ecliptic
/// \param origin_deg longitude at the middle of the picture
/// \param mirrored   longitude grows to the right, as on a globe seen from outside; else to the left
[[nodiscard]] std::string whole_sky_cards(const std::string& frame, double origin_deg, bool mirrored, int width,
                                          int height, bool row_0_on_top);

} // namespace vesper
