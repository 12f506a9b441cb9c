#include "vesper/catalog_tools/picture_wcs.hpp"

#include "vesper/base/error.hpp"
#include "vesper/base/units.hpp"
#include "vesper/catalog_tools/celestial_axes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>
#include <mutex>
#include <string_view>
#include <vector>
#include <wcslib/wcs.h>
#include <wcslib/wcserr.h>
#include <wcslib/wcsfix.h>
#include <wcslib/wcshdr.h>
#include <wcslib/wcsmath.h>
#include <wcslib/wcsprintf.h>

namespace vesper {
namespace {

constexpr std::size_t card_length = 80;
constexpr double whole_turn_deg = 360.0;
constexpr const char* no_wcs_remedy =
    "Give a picture with celestial coordinates, or --frame and --origin for a picture of the whole sky without";

/// WCSLIB's texts of errors and reports lie in buffers that all of the process shares.
std::mutex wcslib_texts;

/// Header cards as WCSLIB takes them: printable, whole.
std::string clean_cards(std::string cards) {
  cards.resize((cards.size() + card_length - 1) / card_length * card_length, ' ');
  std::replace_if(
      cards.begin(), cards.end(), [](char c) { return c < ' ' || c > '~'; }, ' ');
  return cards;
}

std::string trimmed(std::string text) {
  while (!text.empty() && (text.back() == ' ' || text.back() == '\n')) {
    text.pop_back();
  }
  return text;
}

/// The keyword of the first card whose text WCSLIB 7.12 would copy beyond its bounds: open to the end of the card, or
/// longer than axes, units and frames are written. Empty if there is none.
std::string unsafe_keyword(const std::string& cards) {
  constexpr std::size_t longest = 24;
  for (std::size_t at = 0; at < cards.size(); at += card_length) {
    const std::string_view card = std::string_view(cards).substr(at, card_length);
    const std::size_t open = card.find_first_not_of(' ', 9);
    if (card.substr(8, 1) != "=" || open == std::string_view::npos || card[open] != '\'') {
      continue;
    }
    std::size_t close = card.find('\'', open + 1);
    while (close != std::string_view::npos && card.substr(close + 1, 1) == "'") { // one within the text
      close = card.find('\'', close + 2);
    }
    const bool of_coordinates = card.starts_with("C") || card.starts_with("RADE") || card.starts_with("WCSNAME") ||
                                card.starts_with("PS") || card.starts_with("SPEC") || card.starts_with("SSYS");
    if (of_coordinates && (close == std::string_view::npos || close - open > longest) && !card.starts_with("COMMENT")) {
      return trimmed(std::string(card.substr(0, 8)));
    }
  }
  return "";
}

std::string quoted(const std::string& ctype) { return ctype.empty() ? "(missing)" : '"' + ctype + '"'; }

/// The letters of CTYPE before the projection: "RA", "GLON".
std::string axis_letters(const std::string& ctype) { return ctype.substr(0, ctype.find('-')); }

bool is_longitude_or_latitude(const std::string& letters) {
  return letters == "RA" || letters == "DEC" ||
         (letters.size() == 4 && (letters.ends_with("LON") || letters.ends_with("LAT")));
}

std::string known_projections() {
  std::string text;
  for (int i = 0; i < prj_ncode; ++i) {
    text += fmt::format("{}{}", i == 0 ? "" : " ", prj_codes[i]);
  }
  return text;
}

} // namespace

struct PictureWcs::Parameters {
  wcsprm prm{};
  std::vector<double> pixels, image, phi, theta, world;
  std::vector<int> status;

  Parameters() { prm.flag = -1; }
  Parameters(const Parameters&) = delete;
  Parameters& operator=(const Parameters&) = delete;
  ~Parameters() { wcsfree(&prm); }

  /// Takes over the celestial axes of another.
  bool take(const wcsprm& from) {
    int count = 1;
    std::array<int, 2> axes{WCSSUB_CELESTIAL, 0};
    return wcssub(1, &from, &count, axes.data(), &prm) == 0 && count == 2;
  }
  void relax_bounds() {
    // Native longitudes beyond 180 degrees are the other end of a map that goes round, but nowhere else.
    constexpr int all = 7;
    constexpr int not_native = 3;
    wcsbchk(&prm, prm.cel.prj.category == CYLINDRICAL ? not_native : all);
  }
  /// For cylindrical projections, whose longitudes are proportional to x.
  [[nodiscard]] Vec2 period() {
    prjprm& projection = prm.cel.prj;
    const std::array<double, 2> longitudes{0.0, whole_turn_deg / 4.0};
    const std::array<double, 1> equator{0.0};
    std::array<double, 2> x{};
    std::array<double, 2> y{};
    std::array<int, 2> unused{};
    projection.prjs2x(&projection, 2, 1, 1, 1, longitudes.data(), equator.data(), x.data(), y.data(), unused.data());
    std::array<double, 4> plane{};
    for (std::size_t i = 0; i < 2; ++i) {
      plane[2 * i + static_cast<std::size_t>(prm.lng)] = x[i];
      plane[2 * i + static_cast<std::size_t>(prm.lat)] = y[i];
    }
    std::array<double, 4> pixels_of{};
    linx2p(&prm.lin, 2, 2, plane.data(), pixels_of.data());
    return 4.0 * Vec2(pixels_of[2] - pixels_of[0], pixels_of[3] - pixels_of[1]);
  }
  void resize(std::size_t count) {
    pixels.resize(2 * count);
    image.resize(2 * count);
    world.resize(2 * count);
    phi.resize(count);
    theta.resize(count);
    status.resize(count);
  }
};

PictureWcs::PictureWcs(const std::string& cards, const std::string& file, const std::string& hdu)
    : wcs_(std::make_unique<Parameters>()), file_(file), hdu_(hdu) {
  const std::scoped_lock lock(wcslib_texts);
  const auto fail = [&](const std::string& keyword, const std::string& message, const std::string& remedy) {
    throw Error(ErrorKind::input, message, {file, keyword.empty() ? hdu : hdu + ", " + keyword, remedy});
  };
  std::string header = clean_cards(cards);
  if (const std::string keyword = unsafe_keyword(header); !keyword.empty()) {
    fail(keyword, "the text is not closed by a quote, or too long for what it names", "Correct the card in the header");
  }
  struct List {
    int count = 0;
    wcsprm* all = nullptr;
    ~List() {
      wcsvfree(&count, &all);
      wcserr_enable(0);
      wcsprintf_set(stderr);
    }
  } list;
  wcsprintf_set(nullptr);
  wcserr_enable(1);
  int rejected = 0;
  constexpr int report_rejected = 2;
  const int parsed = wcspih(header.data(), static_cast<int>(header.size() / card_length), WCSHDR_all, report_rejected,
                            &rejected, &list.count, &list.all);
  if (parsed != 0 || list.count == 0) {
    fail("", "the header's coordinates cannot be read", no_wcs_remedy);
  }
  if (rejected > 0) {
    const std::string_view said(wcsprintf_buf());
    // A rejected card stands on a line of its own, its reason on the next.
    const std::size_t keyword = said.find_first_not_of(" \n");
    fail(trimmed(std::string(said.substr(keyword == std::string_view::npos ? 0 : keyword, 8))),
         fmt::format("{} coordinate keyword{} no valid value: {}", rejected, rejected == 1 ? " has" : "s have",
                     trimmed(std::string(said.substr(0, 300)))),
         "Correct the card in the header");
  }
  wcsprm& whole = list.all[0];
  std::array<std::string, 2> types;
  for (int i = 0; i < whole.naxis; ++i) {
    const std::string type = trimmed(whole.ctype[i]);
    if (i < 2) {
      types[static_cast<std::size_t>(i)] = type;
    }
    if (type.size() > 5 && type.ends_with("-TAB")) {
      fail(fmt::format("CTYPE{}", i + 1), fmt::format("coordinates by table (\"{}\") are not read", type),
           "Resample the picture to one of " + known_projections());
    }
    const std::string letters = axis_letters(type);
    if (i >= 2 && is_longitude_or_latitude(letters)) {
      fail(fmt::format("CTYPE{}", i + 1),
           fmt::format("the axes are swapped: \"{}\" is axis {}, and axis 1 is {}", type, i + 1,
                       quoted(trimmed(whole.ctype[0]))),
           "Reorder the data so that longitude and latitude are axes 1 and 2 and the channels axis 3");
    }
    if (is_longitude_or_latitude(letters) && type.size() > letters.size()) {
      const std::string code = type.size() >= 8 ? type.substr(5, 3) : "";
      const bool known =
          std::any_of(prj_codes, prj_codes + prj_ncode, [&](const char* known_code) { return code == known_code; }) ||
          code == "NCP" || code == "GLS";
      if (!known) {
        fail(fmt::format("CTYPE{}", i + 1), fmt::format("\"{}\" names no known projection", type),
             "Known are " + known_projections());
      }
    }
  }
  unitfix(0, &whole);
  celfix(&whole);
  if (const int status = wcsset(&whole); status != 0) {
    const std::string text = whole.err != nullptr ? whole.err->msg : wcs_errmsg[status];
    std::string keyword;
    for (const auto& [word, key] : {std::pair("CUNIT1", "CUNIT1"),
                                    {"CUNIT2", "CUNIT2"},
                                    {"units", "CUNIT"},
                                    {"inear transformation matrix", "CD, PC, CDELT"},
                                    {"CTYPE", "CTYPE"},
                                    {"ctype", "CTYPE"},
                                    {"PV", "PV"},
                                    {"projection", "PV"}}) {
      if (keyword.empty() && text.find(word) != std::string::npos) {
        keyword = key;
      }
    }
    fail(keyword, "the coordinates make no sense: " + trimmed(text), "Correct the keywords in the header");
  }
  if (whole.lng < 0 || whole.lat < 0) {
    fail("CTYPE1",
         fmt::format("no celestial coordinates: CTYPE1 is {}, CTYPE2 is {}", quoted(types[0]), quoted(types[1])),
         no_wcs_remedy);
  }
  if (!wcs_->take(whole) || wcsset(&wcs_->prm) != 0 || wcs_->prm.lng < 0 || wcs_->prm.lat < 0) {
    fail("PC, CD", "the celestial axes cannot be parted from the others",
         "Give a matrix that does not mix the first two axes with the third");
  }
  wcsprm& prm = wcs_->prm;
  const std::string letters = trimmed(prm.lngtyp);
  const auto axes = celestial_axes(letters, trimmed(prm.radesys),
                                   prm.equinox == UNDEFINED ? std::nullopt : std::optional<double>(prm.equinox));
  if (!axes) {
    fail(letters == "RA" ? "RADESYS, EQUINOX" : "CTYPE1",
         fmt::format(R"(the frame is not known: "{}", RADESYS "{}", EQUINOX {})", letters, trimmed(prm.radesys),
                     prm.equinox == UNDEFINED ? "missing" : fmt::format("{}", prm.equinox)),
         "Known are GLON, SLON, ELON (equinox J1984 or later) and RA (ICRS, FK5, FK4 of B1950)");
  }
  icrs_from_axes_ = axes->icrs_from_axes;
  description_ = fmt::format("{}, {}", types[0], axes->name);
  wcs_->relax_bounds();
  if (prm.cel.prj.category == CYLINDRICAL) {
    period_ = wcs_->period();
  }
}

void PictureWcs::require_on_sphere(int width, int height) {
  if (wcs_->prm.cel.prj.category != CYLINDRICAL) {
    return;
  }
  // Two pixels, for pictures whose outermost row is centred on the pole.
  for (const double beyond : {2.0, height - 2.0}) {
    const Vec2 place(0.5 * width, beyond);
    std::array<Vec3, 1> unused;
    directions({&place, 1}, unused);
    if (height > 4 && (wcs_->status[0] != 0 || std::abs(wcs_->theta[0]) > whole_turn_deg / 4.0)) {
      throw Error(ErrorKind::input,
                  fmt::format("the picture of {} x {} pixels goes on beyond the pole of its projection: the axes are "
                              "swapped or the scale is wrong",
                              width, height),
                  {file_, hdu_ + ", NAXIS1, NAXIS2, CDELT2 or CD2_2",
                   "Let the data's axes be those of the header, longitude across and latitude up"});
    }
  }
}

PictureWcs::PictureWcs(const PictureWcs& other)
    : wcs_(std::make_unique<Parameters>()), icrs_from_axes_(other.icrs_from_axes_), period_(other.period_),
      description_(other.description_), file_(other.file_), hdu_(other.hdu_) {
  if (!wcs_->take(other.wcs_->prm) || wcsset(&wcs_->prm) != 0) {
    throw std::bad_alloc(); // it had been set before
  }
  wcs_->relax_bounds();
}

PictureWcs::PictureWcs(PictureWcs&&) noexcept = default;
PictureWcs::~PictureWcs() = default;

void PictureWcs::directions(std::span<const Vec2> places, std::span<Vec3> out) {
  Parameters& p = *wcs_;
  const std::size_t count = places.size();
  p.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    // FITS counts the first pixel's centre as 1.
    p.pixels[2 * i] = places[i].x + 0.5;
    p.pixels[2 * i + 1] = places[i].y + 0.5;
  }
  // WCSLIB 7.12 calls all points of a row invalid when one lies between the polar facets of HPX: these go one by one.
  const bool one_by_one = p.prm.cel.prj.category == HEALPIX;
  bool broken = false;
  for (std::size_t i = 0; i < count; i += one_by_one ? 1 : count) {
    const int outcome = wcsp2s(&p.prm, one_by_one ? 1 : static_cast<int>(count), 2, &p.pixels[2 * i], &p.image[2 * i],
                               &p.phi[i], &p.theta[i], &p.world[2 * i], &p.status[i]);
    constexpr int some_invalid = 8;
    broken = broken || (outcome != 0 && outcome != some_invalid);
  }
  constexpr double pole = whole_turn_deg / 4.0 + 1e-9; // with rounding
  const auto longitude = static_cast<std::size_t>(p.prm.lng);
  const auto latitude = static_cast<std::size_t>(p.prm.lat);
  const double rad_per_deg = deg.to(rad);
  for (std::size_t i = 0; i < count; ++i) {
    if (broken || p.status[i] != 0 || !(std::abs(p.theta[i]) <= pole)) {
      out[i] = Vec3(0.0);
      continue;
    }
    const double lon = p.world[2 * i + longitude] * rad_per_deg;
    const double lat = p.world[2 * i + latitude] * rad_per_deg;
    const double c = std::cos(lat);
    out[i] = icrs_from_axes_ * Vec3(c * std::cos(lon), c * std::sin(lon), std::sin(lat));
  }
}

Vec3 PictureWcs::direction(const Vec2& place) {
  Vec3 result;
  directions({&place, 1}, {&result, 1});
  return result;
}

std::optional<Vec2> PictureWcs::place(const Vec3& direction) {
  const Vec3 along = transpose(icrs_from_axes_) * direction;
  std::array<double, 2> world{};
  world[static_cast<std::size_t>(wcs_->prm.lng)] = (std::atan2(along.y, along.x) * rad).to(deg);
  world[static_cast<std::size_t>(wcs_->prm.lat)] = (std::atan2(along.z, std::hypot(along.x, along.y)) * rad).to(deg);
  std::array<double, 2> pixel{};
  std::array<double, 2> image{};
  double phi = 0.0;
  double theta = 0.0;
  int status = 0;
  if (wcss2p(&wcs_->prm, 1, 2, world.data(), &phi, &theta, image.data(), pixel.data(), &status) != 0 || status != 0) {
    return std::nullopt;
  }
  return Vec2(pixel[0] - 0.5, pixel[1] - 0.5);
}

std::string whole_sky_cards(const std::string& frame, double origin_deg, bool mirrored, int width, int height,
                            bool row_0_on_top) {
  struct Axes {
    const char* frame;
    const char* longitude;
    const char* latitude;
    const char* system;
  };
  constexpr std::array<Axes, 4> known{{{"galactic", "GLON-CAR", "GLAT-CAR", "ICRS"},
                                       {"icrs", "RA---CAR", "DEC--CAR", "ICRS"},
                                       {"fk5", "RA---CAR", "DEC--CAR", "FK5"},
                                       {"ecliptic", "ELON-CAR", "ELAT-CAR", "ICRS"}}};
  const auto* axes = std::find_if(known.begin(), known.end(), [&](const Axes& a) { return a.frame == frame; });
  if (axes == known.end()) {
    throw Error(ErrorKind::argument, fmt::format("\"{}\" is no known frame", frame),
                {"", "", "Known are galactic, icrs, fk5 and ecliptic"});
  }
  std::string cards;
  const auto text = [&](const char* key, const char* value) {
    cards += fmt::format("{:<80}", fmt::format("{:<8}= '{:<8}'", key, value));
  };
  const auto number = [&](const char* key, double value) {
    cards += fmt::format("{:<80}", fmt::format("{:<8}= {:>20}", key, fmt::format("{:.12E}", value)));
  };
  text("CTYPE1", axes->longitude);
  text("CTYPE2", axes->latitude);
  text("RADESYS", axes->system);
  number("CRPIX1", 0.5 * (width + 1.0));
  number("CRPIX2", 0.5 * (height + 1.0));
  number("CDELT1", (mirrored ? whole_turn_deg : -whole_turn_deg) / width);
  number("CDELT2", (row_0_on_top ? -0.5 : 0.5) * whole_turn_deg / height);
  number("CRVAL1", origin_deg);
  number("CRVAL2", 0.0);
  return cards;
}

} // namespace vesper
